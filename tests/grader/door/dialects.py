#!/usr/bin/env python3
"""dialects.py PROGRAMS: what a clone is judged by. With --dialect none it is the contracts, and in the dialect of a year it differs from them as the
table in docs/course.md says, by the promises of the adapters, and by nothing else."""
import json
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from clones import expect, finish, grade, made  # noqa: E402

ROOT = os.path.dirname(os.path.abspath(__file__)) + "/../../../"
DOOR = ROOT + "grader/door/"


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def table(year):
    """{(task, promise): dropped, bonus or slower} of the rows in docs/course.md that are about a year."""
    rows = re.findall(r"^\| ([a-z_, ]+) \| ([a-z ]+) \| [^|]* \| (dropped|bonus|slower)( since 2020| in 2019)?[^|]*\|$", read(ROOT + "docs/course.md"), re.M)
    is_meant = {"": True, " since 2020": year >= 2020, " in 2019": year == 2019}
    return {(task, promise.replace(" ", "_")): change for tasks, promise, change, years in rows if is_meant[years] for task in tasks.split(", ")}


def of_adapters(year):
    """The promises that only a clone of the year can keep, by task."""
    return {(name[:-4], promise) for name in os.listdir(DOOR + "tasks")
            for since, promise in re.findall(r"^promise +(\d+) (\w+)", read(DOOR + "tasks/" + name), re.M) if year >= int(since)}


def listed(results):
    """{(task, promise): whether it is a bonus}"""
    return {(task["slug"], promise["name"]): promise["bonus"] for task in results["tasks"] for promise in task["promises"]}


_, stubs = grade(os.path.realpath(ROOT + "student"), to="student.json")
contracts = listed(stubs)
for year in 2019, 2020, 2022, 2023:
    clone = made(str(year), year, unwritten=True)
    _, by_contracts = grade(clone, "--dialect", "none")
    _, by_course = grade(clone)
    expect(len(contracts) > 130 and listed(by_contracts) == contracts, f"the contracts, in {year}", set(listed(by_contracts)) ^ set(contracts))
    changes = table(year)
    kept = json.loads(read(f"{DOOR}dialects/{min(year, 2022)}.json"))["tasks"]
    in_data = {(task, promise): change[0] for task, promises in kept.items() for promise, change in promises.items()}
    expect(len(changes) > 9 and in_data == changes, f"the table and the dialect of {year}", set(in_data.items()) ^ set(changes.items()))
    expected = {key: bonus or key in changes for key, bonus in contracts.items() if changes.get(key) != "dropped"}
    expected.update({key: key[1].endswith("_bonus") for key in of_adapters(year)})
    expect(listed(by_course) == expected, f"the dialect of {year}", set(listed(by_course).items()) ^ set(expected.items()))
finish()
