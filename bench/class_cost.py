#!/usr/bin/env python3
"""class_cost.py GRADER CLASS [--make N] [--jobs N] [-- OPTIONS of grade]: measures what it costs to grade a class from nothing.

--make N first writes a class of N submissions to CLASS, a new folder: a third of the task files is right, a third has a known
mistake, the rest are of other right solutions, and no two files are equal. `./run grade --submission reference` has to have run
before, for build/mistakes.

Prints processor seconds per submission by phase, submissions per hour on N processors if nothing else runs on them,
and bytes. GRADER is the folder with grade_class and its grade.json (build/check/grader). Processor time and not wall time is
measured, so a busy machine gives nearly the same result.
"""
import argparse
import csv
import json
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile

WRAPPER = """#!/bin/bash
what={what}
for word; do case $word in --battery*) what=naming ;; --integrated) [ $what != properties ] || what=together ;; esac; done
'{program}' {more} "$@"
status=$?
times >'{log}'.$$
echo "$what $(tail -n 1 '{log}'.$$)" >>'{log}'
rm '{log}'.$$
exit $status
"""


def seconds(text):
    minutes, rest = re.fullmatch(r"(\d+)m([\d.]+)s", text).groups()
    return 60 * int(minutes) + float(rest)


def prepare(grader, here):
    """A folder of programs that write down their processor time, with nothing in their cache."""
    def wrap(name, program, what, more=""):
        path = here / name
        path.write_text(WRAPPER.format(program=program, what=what, more=more, log=here / "log"))
        path.chmod(0o755)
        return str(path)

    config = json.loads((grader / "grade.json").read_text())
    config["work"] = str(here / "work")
    config["picture"] = wrap("graded_picture", config["picture"], "pictures")
    for task in config["tasks"]:
        task["graded"] = wrap("graded." + task["slug"], task["graded"], "properties")
    (here / "grade.json").write_text(json.dumps(config))
    wrap("grade", grader / "grade", "all", f"--config '{here}/grade.json'")
    os.symlink(grader / "unpack", here / "unpack")


def make_class(folder, count):
    """Submissions whose files all differ, the same ones every time."""
    draw = random.Random(7)
    root = pathlib.Path(__file__).resolve().parent.parent
    tasks = sorted(path for path in (root / "reference").glob("[0-9]_*/*.cpp"))
    for number in range(1, count + 1):
        for reference in tasks:
            slug = reference.stem
            if not (root / "grader/tasks" / slug).is_dir():
                continue
            wrong = sorted((root / "build/mistakes" / slug).glob("*/*.cpp"))
            other = sorted((root / "grader/tasks" / slug / "right").glob("*.cpp"))
            kinds = [kind for kind in ([reference], wrong, other) if kind]
            source = draw.choice(draw.choice(kinds)).read_text()
            to = folder / f"learner {number}" / reference.parent.name / reference.name
            to.parent.mkdir(parents=True, exist_ok=True)
            to.write_text(f"{source}// of learner {number}\n")


def size(paths):
    return sum(path.stat().st_size for path in paths)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("grader", type=pathlib.Path)
    parser.add_argument("classes", type=pathlib.Path, metavar="class")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--make", type=int, help="first write a class of that many submissions")
    parser.add_argument("--keep", type=pathlib.Path, help="a new folder for the reports")
    words = sys.argv[1:]
    options = parser.parse_args(words[: words.index("--")] if "--" in words else words)
    more = words[words.index("--") :] if "--" in words else []
    if options.make:
        if options.classes.exists():
            sys.exit(f"{options.classes}: it exists; --make needs a new folder")
        make_class(options.classes, options.make)
    here = pathlib.Path(tempfile.mkdtemp())
    try:
        prepare(options.grader.resolve(), here)
        out = options.keep or here / "out"
        command = [options.grader / "grade_class", options.classes, "--out", out, "--seed", "7", "--config",
                   here / "grade.json", "--jobs", str(options.jobs), *more]
        with open(here / "said", "w", encoding="utf-8") as said:
            status = subprocess.run(command, stdout=said, stderr=said, check=False).returncode
        if not (out / "class.csv").exists():
            sys.exit((here / "said").read_text())
        with open(out / "class.csv", newline="", encoding="utf-8-sig") as table:
            rows = list(csv.DictReader(table))
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        phases = {"all": usage.ru_utime + usage.ru_stime}
        counts = {}
        grade = 0
        for line in (here / "log").read_text().splitlines():
            what, user, system = line.split()
            spent = seconds(user) + seconds(system)
            counts[what] = counts.get(what, 0) + 1
            if what == "all":
                grade += spent
            else:
                phases[what] = phases.get(what, 0) + spent
        rest = sum(value for name, value in phases.items() if name != "all")
        phases["compiling, linking, reports"] = grade - rest
        phases["the class"] = phases["all"] - grade
        n = len(rows)
        print(f"{n} submissions, {counts.get('all', 0)} of them graded, {sum(row['problem'] != '' for row in rows)} with a problem; exit status {status}")
        for name, value in sorted(phases.items(), key=lambda each: -each[1]):
            print(f"  {name:28} {value:8.1f} s   {value / n:7.3f} s each   {counts.get(name, '')}")
        print(f"  {3600 * options.jobs * n / phases['all']:.0f} submissions per hour on {options.jobs} processors")
        cache = here / "work/cache"
        kinds = {}
        for path in cache.iterdir():
            kind = "".join(path.suffixes)
            kinds.setdefault(kind, []).append(path)
        for kind, paths in sorted(kinds.items(), key=lambda each: -size(each[1]))[:6]:
            print(f"  cache {kind:22} {len(paths):6} files {size(paths) / 1e6:8.1f} MB")
        print(f"  pages {size(out.glob('*.html')) / 1e6 / n:.3f} MB each; json {size(out.glob('*.json')) / 1e6 / n:.3f} MB each")
        print(f"  largest process {usage.ru_maxrss / 1024:.0f} MiB")
    finally:
        shutil.rmtree(here)


if __name__ == "__main__":
    main()
