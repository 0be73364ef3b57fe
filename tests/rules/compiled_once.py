#!/usr/bin/env python3
"""compiled_once.py BUILD: names the files of the project that BUILD compiles more than once, into two targets. Such a file
belongs in a library that both link: compiled twice it costs twice the time, and may be two different things in one
program. Reads BUILD/compile_commands.json. Exit code 1 if there is such a file that is not an exception, or an exception that
nothing needs."""
import collections
import json
import os
import sys

FOLDERS = ("pt", "scenes", "reference", "fast", "student", "grader", "measure", "writeup", "view", "tests", "bench")

# Recorded versions of a task are files of their own, made by CMake (cmake/recorded.cpp.in), and so are the kernels of pt/accel:
# they need no exceptions. The files of student/ are compiled again under sanitizers, and once more to count the lines that
# run (--coverage).
EXCEPTIONS = {  # file: why it is compiled for each of several targets
    "grader/check/language/repeat_local.cpp": "once for each task, which FIRSTLIGHT_TASK names",
    "grader/service/wire/implementation.cpp": "once for each task, which FIRSTLIGHT_TASK names",
    "grader/explain/record.cpp": "in a library for the judge, and as an object for workers, which link no library of the grader",
    "grader/service/wire/callback.cpp": "once for each function that the judge answers, which FIRSTLIGHT_TASK names",
}


def times_compiled(build, root):
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        commands = json.load(file)
    paths = (os.path.relpath(os.path.join(each["directory"], each["file"]), root) for each in commands)
    return collections.Counter(path for path in paths if path.split(os.sep)[0] in FOLDERS)


def main():
    build = sys.argv[1]
    root = os.path.abspath(os.path.join(os.path.dirname(__file__), "../.."))
    count = times_compiled(build, root)
    if not count:
        print(f"{build}/compile_commands.json compiles no file of {root}")
        return 1
    twice = [path for path in sorted(count) if count[path] > 1 + 2 * path.startswith("student/") and path not in EXCEPTIONS]
    for path in twice:
        print(f"{path} is compiled {count[path]} times: put it into a library that its targets link")
    unused = [path for path in EXCEPTIONS if count[path] < 2]
    for path in unused:
        print(f"{path} is an exception in tests/rules/compiled_once.py, and is compiled {count[path]} times")
    print(f"{len(count)} files, {len(twice)} compiled more than once without a reason")
    return 1 if twice or unused else 0


if __name__ == "__main__":
    sys.exit(main())
