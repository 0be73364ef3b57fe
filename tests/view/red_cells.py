#!/usr/bin/env python3
"""red_cells.py BUILD [COUNT]: draws COUNT (40) mistakes of parts 1 to 4 at random, with a pinned seed. Each is graded; the view is
opened at the pixel that its report names, as `see it` says; then it is counted whether a cell is red there. docs/view.md has the
figure. It needs `grade`, `graded`, `view`, `view_worker.reference` and `view_boxed`, and takes some minutes."""
import concurrent.futures
import glob
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SEED = 20261126


def all_mistakes():
    """(folder of the part, task, mistake), in a fixed order."""
    for file in sorted(glob.glob(ROOT + "/reference/[1-4]_*/*.cpp")):
        part, task = os.path.basename(os.path.dirname(file)), os.path.basename(file)[:-4]
        with open(f"{ROOT}/grader/tasks/{task}/mistakes.txt", encoding="utf-8") as text:
            for name in re.findall(r"^(?:name|guard) +(\S+)", text.read(), re.M):
                yield part, task, name


def output(*command):
    return subprocess.run(command, cwd=ROOT, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout


def looked_at(build, part, task, name):
    """As looked_at_in, in a folder of its own."""
    with tempfile.TemporaryDirectory() as folder:
        return looked_at_in(folder, build, part, task, name)


def looked_at_in(folder, build, part, task, name):
    """The place that the report names, and the cells that are red there: [(task, promise)]; None: the report names no place."""
    shutil.copytree(ROOT + "/reference", folder + "/handed_in")
    shutil.copy(f"{ROOT}/build/mistakes/{task}/{name}/{task}.cpp", f"{folder}/handed_in/{part}")
    report = output(build + "/grader/grade", task, "--submission", folder + "/handed_in", "--all")
    place = re.search(r"\./run view (\S+) --pixel (\d+) (\d+)", report)
    if not place:
        return None, []
    boxed, page = folder + "/boxed.json", folder + "/page.json"
    said = output(build + "/measure/writeup_boxed", "build", folder + "/handed_in", boxed, "view_boxed.json", task)
    said += output(build + "/view/view", "--recipes", "scenes/recipes.json", "--boxed", boxed, "--reference",
                   build + "/view/view_worker.reference", "--mixture", task + "=student", place[1], "--pixel", place[2], place[3],
                   "--export", page)
    if not os.path.exists(page):
        return f"{place[0]} (no page: {said.strip().splitlines()[-1]})", []
    with open(page, encoding="utf-8") as file:
        paths = json.load(file)["paths"]
    found = paths["findings"] + [finding for path in paths["paths"] for finding in path["findings"]]
    return place[0], sorted({(finding["task"], finding["promise"]) for finding in found})


def main():
    build, count = os.path.abspath(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 40
    drawn = random.Random(SEED).sample(list(all_mistakes()), count)
    placed = red = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as threads:
        for (_, task, name), (place, cells) in zip(drawn, threads.map(lambda each: looked_at(build, *each), drawn)):
            placed += place is not None
            red += bool(cells)
            said = ", ".join(f"{where} {promise}" for where, promise in cells) or ("no red cell" if place else "no pixel in the report")
            print(f"{task} {name}: {place or '-'}: {said}", flush=True)
    print(f"{red} of {count} have a red cell at the pixel that the report names; {count - placed} reports name no pixel")


main()
