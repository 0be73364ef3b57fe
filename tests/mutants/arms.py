#!/usr/bin/env python3
"""arms.py BUILD [TASK]...

Runs the promises of each right solution, the reference among them, and asks gcov which arms of its branches they take. Inputs that take
an arm in fewer than one of a thousand calls of the task say nothing about what is written there: a mistake in that place of a
student's file would pass. Such an arm needs an input, or a reason in arms.txt, where "- " is its line, below the reason. Below "== any file"
it is a regular expression that lines of many files match.

Arms that only an exception takes are left out. The exit status is 1 if an arm has no reason, or a reason has no such arm, 2 if
something cannot be used.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import textwrap

from reasons import ANY_FILE, ROOT, entries
from small_changes import Task

TABLE = ROOT / "tests/mutants/arms.txt"
CALLS = 1000  # of which one has to take an arm


def reasons_of_arms():
    """The (file, line) that arms.txt has a reason for, and the expressions."""
    found, everywhere = set(), []
    for number, base, why, _, text in entries(TABLE):
        if not why:
            sys.exit(f"{TABLE}:{number}: write the reason above it")
        if base == ANY_FILE:
            everywhere.append(re.compile(text))
        else:
            found.add((base, text))
    return found, everywhere


def covered(task, file, folder):
    """What gcov says of a file after a run of all its promises."""
    source, target = folder / file.name, folder / "task.o"
    source.write_text(file.read_text())
    words = task.flags + ["-O0", "-fno-inline", "--coverage", "-o", str(target), "-c", str(source)]
    link = [str(target) if word == task.object else word for word in task.link] + ["--coverage"]
    link[link.index("-o") + 1] = str(folder / "check")
    for command in (words, link):
        run = subprocess.run(command, cwd=task.build, capture_output=True, text=True)
        if run.returncode != 0:
            sys.exit(f"{file}: {run.stderr}")
    subprocess.run([folder / "check", "--gtest_brief=1"], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    said = subprocess.run(["gcov", "--json-format", "--branch-probabilities", "--stdout", "task.gcda"], cwd=folder,
                          capture_output=True, text=True)
    if said.returncode != 0:
        sys.exit(f"{file}: gcov: {said.stderr}")
    return next(each for each in json.loads(said.stdout)["files"] if each["file"].endswith(file.name))


def rare_arms(task, file):
    """The number of calls; and for each line with an arm that too few calls take, the lowest count of its arms."""
    with tempfile.TemporaryDirectory(dir=task.build) as folder:
        found = covered(task, file, pathlib.Path(folder))
    public = tuple(f"pt::{function}(" for function in task.functions)
    calls = sum(each["execution_count"] for each in found["functions"]
                if each["demangled_name"].startswith(public) and "lambda" not in each["demangled_name"])
    arms = {}  # by line and place; a template has a list of arms for each of its instances
    for line in found["lines"]:
        for i, arm in enumerate(arm for arm in line["branches"] if not arm["throw"]):
            arms[line["line_number"], i] = arms.get((line["line_number"], i), 0) + arm["count"]
    text, rare = file.read_text().splitlines(), {}
    for (number, _), count in arms.items():
        line = " ".join(text[number - 1].split())
        # What only an exception takes is also at the end of a block, and where it is caught.
        if count * CALLS < calls and not line.startswith("}"):
            rare[line] = min(rare.get(line, calls), count)
    return calls, rare


def main():
    parser = argparse.ArgumentParser(description=textwrap.dedent(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("tasks", nargs="*")
    options = parser.parse_args()
    (known, everywhere), missing = reasons_of_arms(), 0
    for slug in options.tasks or sorted(p.parent.name for p in (ROOT / "grader/tasks").glob("*/task.json")):
        task = Task(options.build, slug)
        for file in [*ROOT.glob(f"reference/*/{slug}.cpp"), *sorted((ROOT / "grader/tasks" / slug / "right").glob("*.cpp"))]:
            place = str(file.relative_to(ROOT))
            calls, rare = rare_arms(task, file)
            has_reason = lambda line: (place, line) in known or any(each.search(line) for each in everywhere)
            new = {line: count for line, count in rare.items() if not has_reason(line)}
            old = {line for base, line in known if base == place} - rare.keys()
            missing += len(new) + len(old)
            if new or old:
                print(f"== {place}\n# {calls} calls", flush=True)
            for line, count in new.items():
                print(f"# an arm is taken {count} times\n- {line}", flush=True)
            for line in old:
                print(f"# arms.txt has a reason for this line, and each arm of it is taken often\n- {line}", flush=True)
    sys.exit(1 if missing else 0)


main()
