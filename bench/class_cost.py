#!/usr/bin/env python3
"""class_cost.py GRADER CLASS [--make N] [--of KIND] [--jobs N] [-- OPTIONS of grade]: measures what it costs to grade a class from nothing.

--make N first writes a class of N submissions to CLASS, a new folder, in which no two files are equal. KIND says of what:
  mixed    a third of the task files is right, a third has a known mistake, the rest are of other right solutions (default)
  right    the reference
  wrong    each task has a known mistake
  looping  the reference, but hit_bvh never ends
`./run grade --submission reference` has to have run before, for build/mistakes.

Prints processor seconds per submission by stage, submissions per hour on N processors if nothing else runs on them, and bytes. GRADER is
the folder with grade_class and its grade.json (build/check/grader). perf samples all processes, so those that are killed count too. Processor
time and not wall time is measured; but a busy machine lengthens it as well.
"""
import argparse
import csv
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

# A stage, and the processes that are its, by the start of their names: the kernel keeps 15 characters.
STAGES = [
    ("compiling", r"cc1plus|as$|x86_64-linux|g\+\+|c\+\+|cpp"),
    ("linking", r"ld|collect2"),
    ("boxes", r"bwrap|box|launcher"),
    ("the submission's own code", r"[0-9a-f]{15}$"),
    ("promises: draws and questions", r"graded\."),
    ("pictures: judging", r"graded_picture"),
    ("grade: audit, keys, reports", r"grade$|flatten|unpack"),
    ("the class", r"grade_class"),
]


def make_class(folder, count, kind):
    """Submissions whose files all differ, the same ones every time."""
    draw = random.Random(7)
    root = pathlib.Path(__file__).resolve().parent.parent
    for number in range(1, count + 1):
        for reference in sorted((root / "reference").glob("[0-9]_*/*.cpp")):
            slug = reference.stem
            if not (root / "grader/tasks" / slug).is_dir():
                continue
            wrong = sorted((root / "build/mistakes" / slug).glob("*/*.cpp"))
            other = sorted((root / "grader/tasks" / slug / "right").glob("*.cpp"))
            kinds = {"mixed": [files for files in ([reference], wrong, other) if files], "wrong": [wrong]}.get(kind, [[reference]])
            source = draw.choice(draw.choice(kinds)).read_text()
            if kind == "looping" and slug == "hit_bvh":
                source = re.sub(r"\{\n", "{\n  for (volatile int i = 0;;) i = 1;\n", source)
            to = folder / f"learner {number}" / reference.parent.name / reference.name
            to.parent.mkdir(parents=True, exist_ok=True)
            to.write_text(f"{source}// of learner {number}\n")


def seconds_by_stage(data):
    """Of each stage, from the samples of perf, which are a thousandth of a second each."""
    told = subprocess.run(["perf", "report", "-i", data, "--no-children", "--sort", "comm", "-g", "none", "-F", "sample,comm"],
                          capture_output=True, text=True, check=True).stdout
    spent = {}
    for line in told.splitlines():
        words = line.split()
        if len(words) < 2 or not words[0].isdigit():
            continue
        name = next((stage for stage, of in STAGES if re.match(of, words[1])), "other programs")
        spent[name] = spent.get(name, 0) + int(words[0]) / 1000
    return spent


def size(paths):
    return sum(path.stat().st_size for path in paths)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("grader", type=pathlib.Path)
    parser.add_argument("classes", type=pathlib.Path, metavar="class")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--make", type=int, help="first write a class of that many submissions")
    parser.add_argument("--of", choices=["mixed", "right", "wrong", "looping"], default="mixed")
    parser.add_argument("--keep", type=pathlib.Path, help="a new folder for the reports")
    words = sys.argv[1:]
    options = parser.parse_args(words[: words.index("--")] if "--" in words else words)
    more = words[words.index("--") :] if "--" in words else []
    if shutil.which("perf") is None:
        sys.exit("perf is missing (Debian: linux-perf)")
    if options.make:
        if options.classes.exists():
            sys.exit(f"{options.classes}: it exists; --make needs a new folder")
        make_class(options.classes, options.make, options.of)
    here = pathlib.Path(tempfile.mkdtemp())
    try:
        config = json.loads((options.grader / "grade.json").read_text())
        config["work"] = str(here / "work")  # nothing is known there
        (here / "grade.json").write_text(json.dumps(config))
        (here / "grade").write_text(f"#!/bin/bash\nexec '{options.grader.resolve()}/grade' --config '{here}/grade.json' \"$@\"\n")
        (here / "grade").chmod(0o755)
        os.symlink(options.grader.resolve() / "unpack", here / "unpack")
        out = options.keep or here / "out"
        command = ["perf", "record", "-q", "-e", "cpu-clock", "-c", "1000000", "-o", here / "perf", options.grader / "grade_class",
                   options.classes, "--out", out, "--seed", "7", "--config", here / "grade.json", "--jobs", str(options.jobs), *more]
        with open(here / "said", "w", encoding="utf-8") as said:
            status = subprocess.run(command, stdout=said, stderr=said, check=False).returncode
        if not (out / "class.csv").exists():
            sys.exit((here / "said").read_text())
        with open(out / "class.csv", newline="", encoding="utf-8-sig") as table:
            rows = list(csv.DictReader(table))
        n = len(rows)
        problems = {row["problem"] for row in rows} - {""}
        spent = seconds_by_stage(here / "perf")
        whole = sum(spent.values())
        print(f"{n} submissions; exit status {status}", *problems)
        for name, value in sorted({"all": whole, **spent}.items(), key=lambda each: -each[1]):
            print(f"  {name:30} {value:8.1f} s   {value / n:7.3f} s each")
        print(f"  {3600 * options.jobs * n / whole:.0f} submissions per hour on {options.jobs} processors")
        kinds = {}
        for path in (here / "work/cache").iterdir():
            kinds.setdefault("".join(path.suffixes), []).append(path)
        for kind, paths in sorted(kinds.items(), key=lambda each: -size(each[1]))[:6]:
            print(f"  cache {kind:22} {len(paths):6} files {size(paths) / 1e6:8.1f} MB")
        print(f"  pages {size(out.glob('*.html')) / 1e6 / n:.3f} MB each; json {size(out.glob('*.json')) / 1e6 / n:.3f} MB each")
    finally:
        shutil.rmtree(here)


if __name__ == "__main__":
    main()
