"""What the tests of clones share: makes clones of the look-alike of a course's skeleton (tests/fixtures/course/), and grades them."""
import json
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)) + "/../../fixtures/course")
import make_clone  # noqa: E402

PROGRAMS = sys.argv[1]
complaints = []
folder = tempfile.TemporaryDirectory()


def grade(clone, *words, to=None):
    """(what the command printed, its results.json)"""
    results = os.path.join(folder.name, to) if to else clone + ".json"
    run = subprocess.run([PROGRAMS + "/grade", *words, "--submission", clone, "--no-pictures", "--quiet", "--json", results],
                         capture_output=True, text=True, check=False)
    if run.returncode not in (0, 1):
        raise SystemExit(f"{clone} {words}: status {run.returncode}: {run.stderr}")
    with open(results, encoding="utf-8") as file:
        return run.stdout, json.load(file)


def made(name, year, **how):
    clone = os.path.join(folder.name, name)
    make_clone.make(year, clone, **how)
    return clone


def expect(holds, what, found):
    if not holds:
        complaints.append(f"{what}: {found}")


def broken(task):
    return [promise["name"] for promise in task["promises"] if not promise["held"] and not promise["bonus"]]


DIALECTS = {2019: "CS184, 2019 and before", 2020: "CS184, 2020 and 2021", 2022: "CS184, 2022 and later", 2023: "CS184, 2022 and later"}


def finish():
    print("\n".join(complaints) or "all clones have their verdicts")
    sys.exit(1 if complaints else 0)
