#!/usr/bin/env python3
"""link_lists.py BUILD: names the libraries that a target of BUILD lists although another library of its list hands them on:
a list should have only what the target itself calls. Reads BUILD/link_lists, which link_lists.cmake writes. Objects
have to be listed where they are linked, so they are ignored; so are the flags that every library of ours has. Exit code 1 if
there is such a library that is not an exception, or an exception that nothing needs."""
import re
import sys

EXCEPTIONS = {  # target, library: the reason why it is listed anyway
}


class Target:
    def __init__(self, line):
        head, listed, handed_on = line.rstrip("\n").split("|")
        self.type, self.name = head.split(" ", 1)
        self.listed = [name for name in listed.split(";") if name]
        # A library that only the linker gets is not handed on: its callers list it.
        self.handed_on = [name for name in handed_on.split(";") if name and not name.startswith("$<LINK_ONLY")]


def read(path):
    with open(path, encoding="utf-8") as file:
        targets = [Target(line) for line in file]
    return {target.name: target for target in targets}


def all_handed_on(targets, name, known):
    """All libraries that the library hands on, directly or through others."""
    if name not in known:
        known[name] = set()
        for each in targets[name].handed_on if name in targets else []:
            known[name] |= {each} | all_handed_on(targets, each, known)
    return known[name]


def needless(targets, target, known):
    """Pairs of a library in the target's list, and another library there that hands it on."""
    reasoned = {name for name in target.listed if name in targets and targets[name].type == "OBJECT_LIBRARY"}
    if target.type != "EXECUTABLE":
        reasoned.add("firstlight_options")
    for i, name in enumerate(target.listed):
        if name in target.listed[:i]:
            yield name, name
        by = [other for other in target.listed if name in all_handed_on(targets, other, known)]
        if by and name not in reasoned:
            yield name, by[0]


def main():
    targets = read(sys.argv[1] + "/link_lists")
    known = {}
    found = {(target.name, name): by for target in targets.values() for name, by in needless(targets, target, known)}
    wrong = sorted(set(found) - set(EXCEPTIONS))
    for target, name in wrong:
        print(f"{target} lists {name}, which {found[target, name]} hands on: leave it out")
    unused = sorted(set(EXCEPTIONS) - set(found))
    for target, name in unused:
        print(f"tests/rules/link_lists.py has an exception for {target} and {name}, which is not needed")
    print(f"{len(targets)} targets, {len(wrong)} libraries listed for nothing")
    return 1 if wrong or unused or not targets else 0


if __name__ == "__main__":
    sys.exit(main())
