#!/usr/bin/env python3
"""run.py --check
run.py FOLDER [--only NAME]... [--part K N]
run.py FOLDER --draw N [--seed S] [PATH]...

Tests the tests of the framework: puts one mistake after the other into a copy of the project in FOLDER, builds the programs of its tests and
runs them there; one must fail. The mistakes are those of mutants.txt, or with --draw N small changes (edits_of_tokens.py), drawn from the
folders of folders.txt, or from those files of them that lie in PATH. --part K N takes every N-th mistake, from the K-th on. A seed is chosen and printed if none is given. Found ones are
kept in FOLDER, so that a run may be stopped and started again, a draw with its seed. --check builds nothing; it says which entries
of mutants.txt do not fit their files any more, and draws one.

A drawn change that no test finds is printed in the form of small_changes.txt: mend the test or the code; or, if the change is right,
keep it there, below the reason. One that leaves the programs of its tests as they are, byte by byte, is no change.

The exit status is 1 if a mistake survives its tests, 2 if something cannot be used.
"""

import argparse
import collections
import hashlib
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import textwrap

from edits_of_tokens import changed_files
from reasons import ROOT, reasons, shown

TABLE, FOLDERS = ROOT / "tests/mutants/mutants.txt", ROOT / "tests/mutants/folders.txt"
SECONDS = 900  # that the tests of a mistake may take

# `command` runs in the folder of the build. `line` and `changed_line` of a drawn one are as in small_changes.txt.
Mistake = collections.namedtuple("Mistake", "name file text command targets says line changed_line", defaults=["", "", ""])


def fail(text):
    print(text, file=sys.stderr)
    sys.exit(2)


def edits(*what):
    """What cmake/edits.awk says of mutants.txt."""
    said = subprocess.run(["awk", "-v", f"root={ROOT}", "-v", "needed=says base old test", "-v", *what, "-f", ROOT / "cmake/edits.awk", TABLE],
                          capture_output=True, text=True)
    return said.stdout if said.returncode == 0 else fail(said.stderr.strip())


def written(only):
    rows = [row.split("\t") for row in edits("list=name base test says target").splitlines()]
    unknown = set(only) - {row[0] for row in rows}
    if unknown:
        fail(f"{TABLE} has no mistake {', '.join(sorted(unknown))}")
    for name, file, command, says, target in rows:
        if not only or name in only:
            own = re.search(r"(?:^| )tests/(\S+)", command)
            yield Mistake(name, file, edits(f"only={name}"), command, [name for name in (own and own[1], target) if name], says)


def tests_of_folders():
    rows = [line.split() for line in FOLDERS.read_text().splitlines() if line and line[0] != "#"]
    return {row[0]: row[1:] for row in rows}


def drawn(count, seed, paths):
    """Each file is drawn by its length, and then one of its changes."""
    tests, random_numbers = tests_of_folders(), random.Random(seed)
    listed = subprocess.run(["git", "ls-files", *(paths or tests)], cwd=ROOT, capture_output=True, text=True).stdout.splitlines()
    folder_of = {file: max((f for f in tests if file.startswith(f + "/")), key=len, default="") for file in listed}
    files = sorted(file for file in listed if file.endswith((".cpp", ".h")) and folder_of[file])
    if not files:
        fail(f"{FOLDERS} has no row for a C++ file of {' '.join(paths)}; write other files, or a row")
    lengths, mistakes = [(ROOT / file).stat().st_size for file in files], {}
    for file in random_numbers.choices(files, lengths, k=20 * count):
        source = (ROOT / file).read_text()
        # Single precision is nearly always enough, and an assertion may say less.
        changed = [(text, place) for text, place in changed_files(source).items()
                   if place[2] != "float" and not shown(source, place)[0].startswith("assert(")]
        if changed and len(mistakes) < count:
            text, place = random_numbers.choice(changed)
            names = tests[folder_of[file]]
            command = f"ctest --no-tests=error --stop-on-failure --output-on-failure -R '^({'|'.join(map(re.escape, names))})$'"
            mistakes[file, text] = Mistake("", file, text, command, names, "", *shown(source, place))
    return sorted(mistakes.values())


class Copy:
    """A copy of the project, which is built and tested."""

    def __init__(self, folder):
        self.folder, self.build = folder, folder / "tree/build/check"
        folder.mkdir(parents=True, exist_ok=True)
        subprocess.run(["bash", "-c", '. tests/commands/copy_tree.sh; update_copy "$1" "$2"', "copy", ROOT, folder], cwd=ROOT, check=True)
        # Without precompiled headers, a change makes one file of its library be compiled.
        if not (self.build / "build.ninja").exists() and self.status("cmake --preset check -DFIRSTLIGHT_PCH=OFF", folder / "tree") != 0:
            fail(f"the copy cannot be configured: see {folder}/log")
        self.needs = {row[0]: row[2:] for row in map(str.split, (self.build / "tests.txt").read_text().splitlines())}

    def status(self, command, place):
        with open(self.folder / "log", "w") as log:
            child = subprocess.Popen(["bash", "-c", command], cwd=place, env=os.environ | {"GTEST_FAIL_FAST": "1"}, stdin=subprocess.DEVNULL,
                                     stdout=log, stderr=log, start_new_session=True)
            try:
                return child.wait(None if "ninja" in command or "cmake" in command else SECONDS)
            except subprocess.TimeoutExpired:
                return -signal.SIGKILL
            finally:  # also if we are interrupted
                if child.poll() is None:
                    os.killpg(child.pid, signal.SIGKILL)
                    child.wait()

    def targets(self, mistake):
        return sorted({target for name in mistake.targets for target in self.needs.get(name, [name])})

    def builds(self, mistakes):
        return self.status(f"ninja {' '.join(sorted({target for m in mistakes for target in self.targets(m)}))}", self.build) == 0

    def programs(self, mistake):
        places = [self.build / folder / target for target in self.targets(mistake) for folder in ("tests", "grader", "pt/render", "view")]
        return [hashlib.sha256(place.read_bytes()).hexdigest() for place in places if place.is_file()]

    def outcome(self, mistake, unchanged):
        place = self.folder / "tree" / mistake.file
        try:
            place.write_text(mistake.text)
            if not self.builds([mistake]):
                return "does not compile"
            if mistake.line and self.programs(mistake) == unchanged:
                return "same program"
            return "SURVIVES" if self.status(mistake.command, self.build) == 0 else "found"
        finally:
            place.write_text((ROOT / mistake.file).read_text())


def state_of(folder):
    """What the outcomes depend on: all files of the copy but those here."""
    listed = [file for file in (folder / "files").read_text().split("\n") if file and not file.startswith("tests/mutants/")]
    return hashlib.sha256(b"".join((ROOT / file).read_bytes() for file in listed if (ROOT / file).is_file())).hexdigest()[:16]


def try_all(mistakes, copy):
    """(mistake, outcome) of each, as it comes to be known."""
    kept = copy.folder / f"found.{state_of(copy.folder)}"
    found = set(kept.read_text().split()) if kept.exists() else set()
    key = lambda m: hashlib.sha256("\0".join([m.file, m.text, m.command]).encode()).hexdigest()[:24]
    todo = [m for m in mistakes if key(m) not in found]
    yield from ((m, "found before") for m in mistakes if key(m) in found)
    if not copy.builds(todo):
        fail(f"the project does not build: see {copy.folder}/log")
    # Without a mistake each test passes; else it would prove nothing that it fails with one. One that is skipped here proves nothing either.
    statuses = {}
    for command in sorted({m.command for m in todo}):
        statuses[command] = copy.status(command, copy.build)
        if statuses[command] not in (0, 77):
            fail(f"the test '{command}' fails without any mistake: see {copy.folder}/log")
    unchanged = {m.command: copy.programs(m) for m in todo}
    for m in todo:
        outcome = copy.outcome(m, unchanged[m.command]) if statuses[m.command] == 0 else "not tried: its test is skipped here"
        if outcome == "found":
            with kept.open("a") as file:
                file.write(key(m) + "\n")
        yield m, outcome


def main():
    parser = argparse.ArgumentParser(description=textwrap.dedent(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("paths", nargs="*")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--only", action="append", default=[], metavar="NAME")
    parser.add_argument("--part", type=int, nargs=2, default=[1, 1], metavar=("K", "N"))
    parser.add_argument("--draw", type=int, metavar="N")
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(10**6))
    options = parser.parse_intermixed_args()
    if options.check:
        count = len(drawn(1, 1, []))
        print(f"{len(edits('list=name').splitlines())} mistakes fit their files, and {count} is drawn")
        sys.exit(0 if count == 1 else 1)
    if not options.folder:
        fail("say where: run.py FOLDER")
    known_reasons = reasons()
    if options.draw:
        print(f"--draw {options.draw} --seed {options.seed} {' '.join(options.paths)}", flush=True)
    mistakes = drawn(options.draw, options.seed, options.paths) if options.draw else list(written(options.only))
    mistakes = mistakes[options.part[0] - 1::options.part[1]]
    if not mistakes:
        fail("this part has no mistake")
    counts = collections.Counter()
    for m, outcome in try_all(mistakes, Copy(options.folder)):
        if outcome == "SURVIVES" and (m.file, m.line, m.changed_line) in known_reasons:
            outcome = "has a reason"
        counts[outcome] += 1
        if not options.draw:
            print(f"{m.name:40} {m.file:50} {outcome}", flush=True)
        if outcome == "SURVIVES":
            print(f"== {m.file}\n- {m.line}\n+ {m.changed_line}" if m.line else f"    {m.says}", flush=True)
    print(f"{len(mistakes)} mistakes: {', '.join(f'{n} {outcome}' for outcome, n in sorted(counts.items()))}")
    if counts["does not compile"] and not options.draw:
        sys.exit(2)
    sys.exit(1 if counts["SURVIVES"] else 0)


main()
