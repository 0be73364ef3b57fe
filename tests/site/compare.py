#!/usr/bin/env python3
"""compare.py LIVE.so CALLS.json: makes the calls that a page made once more, with the same source compiled for this machine.
CALLS.json is the answer of WebDriver: for each function its last numbers in and out. What uses only + - * / and sqrt is the same bit for
bit. Sines and powers of other libraries differ in the last digits, and where such a number decides, a pixel may differ."""
import ctypes
import json
import struct
import sys

EXACT = {"hit_triangle", "hit_sphere", "hit_box", "tree", "walk"}
library = ctypes.CDLL(sys.argv[1])
library.numbers_in.restype = library.numbers_out.restype = ctypes.POINTER(ctypes.c_double)
calls = json.loads(json.load(open(sys.argv[2], encoding="utf-8"))["value"])
if not calls:
    sys.exit("the page has called nothing")
for name, call in calls.items():
    place = library.numbers_in(len(call["given"]))
    for i, number in enumerate(call["given"]):
        place[i] = number
    size = library[f"live_{name}"]()
    native = library.numbers_out()[:size]
    page = call["answer"]
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
