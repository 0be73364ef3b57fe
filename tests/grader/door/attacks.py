#!/usr/bin/env python3
"""attacks.py PROGRAMS: hostile work in the look-alike of a course's skeleton, and what each attack got. No attack earns a point that the same
work earns not without it, none reads a file outside of its clone, and none stops the judge. The table in docs/instructors/isolation.md is this one."""
import json
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE + "/../../fixtures/course")
import make_clone  # noqa: E402

PROGRAMS = sys.argv[1]
SECRET = "a-word-that-nobody-may-read"
complaints = []
folder = tempfile.TemporaryDirectory()
outside = os.path.join(folder.name, "outside.h")
with open(outside, "w", encoding="utf-8") as secret_file:
    secret_file.write(f"const char* secret = {SECRET};\n")

BOX = "src/scene/bbox.cpp"
WRONG_BOX = "bool BBox::intersect(const Ray& r, double& t0, double& t1) const { return r.min_t < 0; }\n"


def box(before="", after="", body=""):
    """bbox.cpp with a wrong intersect, and text of the attack around it or in it."""
    wrong = WRONG_BOX.replace("{ ", "{ " + body, 1)
    return {BOX: f'#include "scene/bbox.h"\n#include <cstdio>\n#include <unistd.h>\n{before}\nnamespace CGL {{\n{wrong}}}\n{after}'}


# The name, the task, the files that are other than those of right work, the state, and a part of what is said.
ATTACKS = [
    ("an include by an absolute path", "hit_box", box(before=f'#include "{outside}"'), "fail", "outside.h"),
    ("an include that leaves by ..", "hit_box", box(before='#include "../../../outside.h"'), "fail", "outside.h"),
    ("a link to a file outside", "hit_box", {**box(before='#include "link.h"'), "src/scene/link.h": None}, "fail", "link"),
    ("a file read by the assembler", "hit_box", box(before=f'asm(".incbin \\"{outside}\\"");'), "fail", ""),
    ("a header of 2 MiB", "hit_box", {**box(before='#include "large.h"'), "src/scene/large.h": "//" + " " * (2 << 20)}, "fail", "larger than 1 MiB"),
    ("headers that include each other", "hit_box", {**box(before='#include "a.h"'), "src/scene/a.h": '#include "b.h"\n', "src/scene/b.h": '#include "a.h"\n'}, "fail", ""),
    ("a line that lies about its file", "hit_box", box(before='#line 1 "door/around"\nint x = ;'), "rejected", "not judged"),
    ("a macro for a keyword", "hit_box", box(before="#define if(x) if (false)\n#define return return true;return"), "rejected", "not judged"),
    ("a macro for a name of ours", "hit_box", box(before="#undef FL_WRITTEN\n#define FL_WRITTEN 1\n#define fl_out(x) fl_in(x)"), "fail", ""),
    ("a namespace that is closed, and a task of ours", "hit_box", box(after="}\n#include \"pt/tasks/hit_sphere.h\"\nstd::optional<pt::SurfaceHit> pt::hit_sphere(const pt::Sphere&, const pt::Ray&) { return {}; }\nnamespace {\n"), "rejected", ""),
    ("the reference by its path", "hit_box", box(before='#include "reference/2_bvh/hit_box.cpp"'), "fail", "reference/2_bvh/hit_box.cpp"),
    ("a header of ours, for another task", "hit_box", box(before='#include "pt/tasks/hit_bvh.h"', body="pt::hit_bvh({}, {}, {}); "), "fail", "pt/geometry"),
    ("a name of ours that says what is kept", "hit_box", box(body='fl_not_kept("x", "y"); '), "fail", "fl_not_kept"),
    ("a file of the machine", "hit_box", box(body='FILE* file = fopen("/proc/self/environ", "r"); if (file) return true; '), "fail", ""),
    ("a text that does not end", "hit_box", box(after='\nconst char* rest = R"x('), "fail", ""),
    ("a condition that does not end", "hit_box", box(after="\n#if 0\n"), "fail", ""),
    ("a constructor that ends the worker", "hit_box", box(before="static struct Early { Early() { _exit(0); } } early;"), "rejected", "_exit"),
    ("bytes for the judge", "hit_box", box(body='for (int fd = 0; fd < 16; ++fd) (void)!write(fd, "\\1\\0\\0\\0\\1\\0\\0\\0", 8);'), "rejected", "write"),
    ("lines of an adapter", "hit_box", box(body='fprintf(stderr, "\\nnot kept: x: y\\nheld: all\\n");'), "fail", ""),
]


def grade(name, task, files):
    clone = os.path.join(folder.name, name.replace(" ", "_"))
    make_clone.make(2022, clone)
    for path, text in files.items():
        place = os.path.join(clone, path)
        if text is None:
            os.symlink(outside, place)
        elif isinstance(text, tuple):
            with open(place, encoding="utf-8") as file:
                old = file.read()
            assert old.count(text[0]) == 1, text[0]
            with open(place, "w", encoding="utf-8") as file:
                file.write(old.replace(*text))
        else:
            with open(place, "w", encoding="utf-8") as file:
                file.write(text)
    run = subprocess.run([PROGRAMS + "/grade", task, "--submission", clone, "--no-pictures", "--quiet", "--json", clone + ".json"],
                         capture_output=True, text=True, check=False)
    if run.returncode not in (0, 1):
        return None, run.stderr, ""
    with open(clone + ".json", encoding="utf-8") as file:
        text = file.read()
    return next(each for each in json.loads(text)["tasks"] if each["slug"] == task), run.stdout, text


_, _, _ = grade("right work", "hit_box", {})
wrong, _, _ = grade("wrong work", "hit_box", box())
for name, task, files, state, said in ATTACKS:
    result, shown, text = grade(name, task, files)
    if result is None:
        complaints.append(f"{name}: the judge ended: {shown}")
        continue
    most = wrong["points"] + wrong["bonus_points"] if task == "hit_box" else 0
    got = result["points"] + result["bonus_points"]
    print(f"{name}: {result['state']}, {got} points: {result['reason'] or result['compiler_output'][:150]!r}")
    if got > most:
        complaints.append(f"{name}: it earns {got} points, and without the attack {most}")
    if SECRET in text:
        complaints.append(f"{name}: the report has what is in a file outside")
    if state and result["state"] != state or said and said not in result["reason"] + result["compiler_output"]:
        complaints.append(f"{name}: {result['state']}, {result['reason']} {result['compiler_output'][:300]}")
print("\n".join(complaints) or "no attack got anything")
sys.exit(1 if complaints else 0)
