#!/usr/bin/env python3
"""same_alone.py GRADER CLASS GRADED [--submissions N] [--draw SEED] [-- OPTIONS of grade]: tests whether a class gets the same verdicts as its submissions one by one.

CLASS was graded into GRADED by ./run grade-class. N of its submissions, drawn at random, are graded again by ./run grade, each with
nothing known before, and every state, point, promise and picture is compared. GRADER is the folder with grade (build/check/grader).
Exit code 1 if anything differs.
"""
import argparse
import json
import pathlib
import random
import subprocess
import sys
import tempfile


def verdicts(results):
    """Everything that makes a verdict, by task."""
    return {
        task["slug"]: {
            "state": task["state"],
            "points": task["points"],
            "promises": {each["name"]: each["held"] for each in task["promises"]},
            "pictures": {each["recipe"]: each["state"] for each in task["pictures"]},
        }
        for task in results["tasks"]
    }


def folder_of(submission):
    """Finds the folder of its files: an archive may nest them."""
    inner = list(submission.rglob("1_rays"))
    return inner[0].parent if inner else None


def grade_alone(grader, folder, seed, options):
    with tempfile.TemporaryDirectory() as work:
        report = pathlib.Path(work) / "alone.json"
        subprocess.run([grader / "grade", "--submission", folder, "--seed", seed, "--work", work, "--json", report, "--quiet",
                        *options], stdout=subprocess.DEVNULL, check=False)
        return verdicts(json.loads(report.read_text()))


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    options.add_argument("grader", type=pathlib.Path)
    options.add_argument("submissions", type=pathlib.Path, metavar="class")
    options.add_argument("graded", type=pathlib.Path)
    options.add_argument("--submissions", dest="count", type=int, default=50)
    options.add_argument("--draw", type=int, default=1)
    words, more = sys.argv[1:], []
    if "--" in words:
        words, more = words[:words.index("--")], words[words.index("--") + 1:]
    chosen = options.parse_args(words)
    seed = (chosen.graded / "seed").read_text().strip()
    known = sorted(path.stem for path in chosen.graded.glob("*.json") if (chosen.submissions / path.stem).is_dir())
    known = [name for name in known if folder_of(chosen.submissions / name)]
    drawn = random.Random(chosen.draw).sample(known, min(chosen.count, len(known)))
    different = 0
    for name in drawn:
        alone = grade_alone(chosen.grader, folder_of(chosen.submissions / name), seed, more)
        in_class = verdicts(json.loads((chosen.graded / f"{name}.json").read_text()))
        if alone != in_class:
            different += 1
            tasks = [slug for slug in alone if alone[slug] != in_class.get(slug)]
            print(f"{name}: {', '.join(tasks)}: alone {alone[tasks[0]]}, in the class {in_class.get(tasks[0])}")
    print(f"{len(drawn)} submissions graded alone: {different} differ from the class")
    return 1 if different or not drawn else 0


sys.exit(main())
