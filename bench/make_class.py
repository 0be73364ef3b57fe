#!/usr/bin/env python3
"""make_class.py FOLDER [--submissions N] [--seed S]: makes a class of any size, as it could be handed in.

Each learner has written some of the tasks. A task that is written is the reference, a right variant or a known mistake; a
task that is not is a stub. One learner in twenty is hostile or broken: endless loops, crashes, system calls, files that do not
compile, damaged archives, nothing at all. One in ten hands in the work of another. Every other file differs
from all others, as in a class, so that it has to be compiled. The same seed gives the same class.
"""
import argparse
import json
import pathlib
import random
import shutil
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
TASKS = [(path.parent.name, part) for _, part, path in sorted(
    (task["number"], task["part"], path) for path in (ROOT / "grader/tasks").glob("*/task.json")
    for task in [json.loads(path.read_text())])]
BROKEN = 1 / 20
COPIED = 1 / 10
WRONG, VARIANT = 0.25, 0.2  # of the files that are written


def solutions(slug, kind):
    """Right variants, or the mistakes that the build has made of grader/tasks/<slug>/mistakes.txt."""
    if kind == "wrong":
        return sorted((ROOT / "build/mistakes" / slug).glob("*/*.cpp"))
    return sorted((ROOT / "grader/tasks" / slug / kind).glob("*.cpp"))


def written(rng, slug, part):
    """The path of a file as a learner may write it."""
    draw = rng.random()
    if draw < WRONG:
        return rng.choice(solutions(slug, "wrong"))
    if draw < WRONG + VARIANT and solutions(slug, "right"):
        return rng.choice(solutions(slug, "right"))
    return ROOT / "reference" / part / (slug + ".cpp")


def learner(rng, name):
    """The files of one learner, by path, with some tasks begun."""
    begun = rng.choice([2, 4, 4, 7, 10, 12, 12, 12])
    files = {}
    for number, (slug, part) in enumerate(TASKS):
        path = f"{part}/{slug}.cpp"
        if number < begun:
            files[path] = written(rng, slug, part).read_text() + f"// by {name}\n"
        else:
            files[path] = (ROOT / "student" / path).read_text()
    return files


def hostile(rng, files):
    """Writes one folder of hostile files over the learner's. Some would need to know where to look: they find nothing."""
    folder = rng.choice(sorted(p for p in (ROOT / "tests/fixtures/hostile").iterdir() if p.is_dir()))
    raw = (ROOT / "tests/fixtures/hostile/raw.h").read_text()
    for path in folder.rglob("*.cpp"):
        text = path.read_text()
        for sign, value in (("@RAW@", raw), ("@ROOT@", "/nowhere"), ("@SUBMISSION@", "/nowhere"), ("@WORK@", "/nowhere")):
            text = text.replace(sign, value)
        files[str(path.relative_to(folder))] = text


def put(folder, name, files, as_zip):
    if as_zip:
        with zipfile.ZipFile(folder / (name + ".zip"), "w", zipfile.ZIP_DEFLATED) as archive:
            for path, text in files.items():
                archive.writestr("student/" + path, text)
        return
    for path, text in files.items():
        target = folder / name / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)


def put_broken(rng, folder, name, files):
    kind = rng.randrange(5)
    if kind == 0:  # an archive that ends too early
        put(folder, name, files, True)
        archive = folder / (name + ".zip")
        archive.write_bytes(archive.read_bytes()[:500])
    elif kind == 1:
        (folder / name).mkdir()
    else:
        if kind == 2:
            path = rng.choice(sorted(files))
            files[path] = files[path].replace(";", "", 3)
        else:
            hostile(rng, files)
        put(folder, name, files, rng.random() < 0.5)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--submissions", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    if options.folder.exists():
        parser.error(f"{options.folder} is there already; give the name of a new folder")
    rng = random.Random(options.seed)
    folder = options.folder.with_name(options.folder.name + ".tmp")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    handed_in = []
    for number in range(1, options.submissions + 1):
        name = f"learner {number:04}"
        files = learner(rng, name)
        draw = rng.random()
        if draw < BROKEN:
            put_broken(rng, folder, name, files)
            continue
        if draw < BROKEN + COPIED and handed_in:
            files = rng.choice(handed_in)
        handed_in.append(files)
        put(folder, name, files, rng.random() < 0.3)
    folder.rename(options.folder)


if __name__ == "__main__":
    main()
