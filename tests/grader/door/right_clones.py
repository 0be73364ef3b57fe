#!/usr/bin/env python3
"""right_clones.py PROGRAMS [few]: right work in the skeleton of a course has full points in the dialect of its year, whatever its kind: the look-alike with
five seeds in each of the three generations, and twenty mixtures of the ideas in tests/fixtures/course/variants.py. With `few`, one mixture of each
generation."""
import os
import random
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from clones import DIALECTS, broken, expect, finish, grade, made  # noqa: E402
import variants  # noqa: E402

YEARS = 2019, 2020, 2022


def judge(clone, year, what, *words):
    said, results = grade(clone, *words)
    short = {task["slug"]: broken(task) or task["reason"] for task in results["tasks"] if task["state"] != "pass" or task["points"] < task["max_points"]}
    print(f"{what}: {short or 'full points'}", flush=True)
    expect(said.startswith(f"Judged by {DIALECTS[year]};"), f"the dialect of {what}", said[:200])
    expect(results["passed"] and len(results["tasks"]) == 12 and not short, what, short)


def mixture(number):
    year = YEARS[number % 3]
    names, edits = variants.mixture(random.Random(number))
    judge(made(f"mixture{number}", year, edits=edits), year, f"mixture {number} of {year}: {', '.join(names)}")


if "few" in sys.argv:
    for number in range(3):
        mixture(number)
else:
    for year in YEARS:
        clone = made(str(year), year)
        for seed in range(2, 7):
            judge(clone, year, f"{year}, seed {seed}", "--seed", str(seed))
    for number in range(20):
        mixture(number)
finish()
