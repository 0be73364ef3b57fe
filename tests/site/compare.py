#!/usr/bin/env python3
"""compare.py LIVE_CALLS CALLS.json: makes the calls that a page made once more, with the same source compiled for this machine (calls.cpp).
CALLS.json is the answer of WebDriver: for each function its last numbers in and out. What uses only + - * / and sqrt is the same bit for
bit. Sines and powers of other libraries differ in the last digits, and where such a number decides, a pixel may differ."""
import json
import struct
import subprocess
import sys

EXACT = {"hit_triangle", "hit_sphere", "hit_box", "tree", "walk"}
calls = json.loads(json.load(open(sys.argv[2], encoding="utf-8"))["value"])
if not calls:
    sys.exit("the page has called nothing")
again = json.loads(subprocess.run([sys.argv[1]], input=json.dumps(calls), capture_output=True, text=True, check=True).stdout)
for name, call in calls.items():
    page, native = call["answer"], again[name]
    size = len(native)
    if len(page) != len(native):
        sys.exit(f"{name}{call['given']}: {len(page)} numbers in the page, {len(native)} here")
    if name in EXACT:
        wrong = [i for i in range(size) if struct.pack("d", page[i]) != struct.pack("d", native[i])]
        allowed = 0
    else:
        wrong = [i for i in range(size) if not abs(page[i] - native[i]) <= 1e-9 * max(1, abs(native[i]))]
        allowed = size // 100
    if len(wrong) > allowed:
        i = wrong[0]
        sys.exit(f"{name}{call['given']}: number {i} is {page[i]!r} in the page, {native[i]!r} here; {len(wrong)} of {size} differ")
    print(f"{name}: {size} numbers, {len(wrong)} differ")
