#!/usr/bin/env python3
"""handbook.py HANDOUT COMPARE [TABLE]: runs every command of the handbook in a handout whose tasks are stubs, as a learner types them.
A picture that a page shows has to be the one that the command below it makes; COMPARE is the program of ./run compare. TABLE gets
a line for each command: exit code, seconds, and the longest time without output."""
import glob
import os
import pty
import re
import select
import shutil
import signal
import subprocess
import sys
import time

HANDOUT, COMPARE = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
PAGES = ["student/README.md", *sorted(glob.glob("student/*/README.md")), "student/finding_by_looking.md", "student/reading_a_report.md",
         "student/tools.md"]
MAY_DIFFER = 1e-6  # relMSE. The noise is that of the page, as the seed is the same; the mistake of the vase makes 2.4e-4
LIMIT = 3600  # seconds, for a command that does not end, on a busy machine too
complaints = []

# What a page of the view has to say where the handbook says it.
FOUND = {"range_overwritten": "primitive 6 ", "first_child_that_hits": "primitive 5320", "t_never_stored": "outside",
         "bsdf_applied_twice": "0.190986", "running_total_as_the_sample": ""}
# Commands that end with another code while nothing is written: the tests fail, and there is nothing to measure or to stop at.
NOTHING_WRITTEN = {"grade": 1, "measure": 1, "stability": 1, "cheapest": 2, "hint": 0, "submit": 0, "writeup": 1}
# They stay until q, which is typed where these words stand.
UNTIL_Q = {"watch": b"q quit", "view": b"http://", "debug": b"(gdb)"}


def commands():
    """Yields the page and the command, for each command on a line of its own or in backquotes in a sentence."""
    for page in PAGES:
        with open(page, encoding="utf-8") as file:
            text = file.read()
        for found in re.findall(r"^    (\./run .*|git .*)$|`(\./run [^`]*)`", text, re.M):
            command = re.sub(r"  +.*", "", found[0] or found[1])  # what stands beside it says what it does
            if len(command.split()) > 1:
                yield page, command


def ends_with(command):
    words = command.split()
    if words[0] == "git" or words[-1] == "--help":
        return 0
    if command == "./run grade --resume":
        return 2  # nothing was interrupted
    return NOTHING_WRITTEN.get(words[1], 0)


def run(command):
    """The exit code, the output, the seconds, and the longest silence of a command in a terminal."""
    child, terminal = pty.fork()
    if child == 0:
        os.chdir(HANDOUT)
        os.environ.update(TERM="xterm", BROWSER="true", PAGER="cat")
        os.execvp("bash", ["bash", "-c", command])
    start = last = time.time()
    output, silence, asked = b"", 0, False
    ready_for_q = UNTIL_Q.get(command.split()[1]) if "--export" not in command else None
    while True:
        ready = select.select([terminal], [], [], .1)[0]
        now = time.time()
        if ready:
            try:
                part = os.read(terminal, 65536)
            except OSError:
                part = b""
            if not part:
                break
            output += part
            silence, last = max(silence, now - last), now
        elif ready_for_q and not asked and now - last > 3 and ready_for_q in output:
            os.write(terminal, b"q\ny\n")
            asked, last = True, now
        elif now - start > LIMIT:
            os.kill(child, signal.SIGKILL)
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    os.close(terminal)
    return code, output.decode(errors="replace"), time.time() - start, max(silence, 0 if asked else time.time() - last)


def differs(made, shown):
    """What is wrong with the picture that a command made; empty if it is the one of the page."""
    if not os.path.exists(made):
        return "makes no such picture"
    said = subprocess.run([COMPARE, made, shown], capture_output=True, text=True, check=False).stdout
    found = re.search(r"^relMSE +(\S+)", said, re.M)
    if found and float(found[1]) < MAY_DIFFER:
        return ""
    return f"makes another picture than the page shows: {found[1] if found else said}"


def check_picture(command):
    """Whether it makes the pictures of that name on the pages; returns their names."""
    found = re.search(r"^./run render .* -f (\S+)\.png", command)
    pictures = set()
    for ending in ("", "_rate") if found else ():
        shown = f"student/pictures/{found[1]}{ending}.png"
        if os.path.exists(shown):
            pictures.add(os.path.basename(shown))
            if wrong := differs(os.path.join(HANDOUT, os.path.basename(shown)), shown):
                complaints.append(f"{command}: {wrong}")
    return pictures


def check_view(command):
    """Whether the page of a bug says what the handbook says."""
    name = re.search(r"=(\w+)$", command)
    code, output, *_ = run(f"{command} --export page.html")
    page = ""
    if code == 0:
        with open(f"{HANDOUT}/page.html", encoding="utf-8") as file:
            page = file.read()
    if code != 0 or (name and FOUND[name[1]] not in page):
        complaints.append(f"{command}: the page lacks '{FOUND.get(name and name[1])}' {output[-300:]}")


def prepare():
    """What the pages say that the learner has: another picture, a newer handout."""
    shutil.copy("student/pictures/spheres_normals.png", f"{HANDOUT}/theirs.png")


def main():
    prepare()
    rows, pictures, seen = [], set(), {}
    for page, command in commands():
        if command in seen or re.search(r"[A-Z]{3}|<|update|\.\.\.", command.replace("README", "")):
            continue
        seen[command] = page
        code, output, seconds, silence = run(command)
        rows.append((page, command, code, seconds, silence))
        print(f"{code} {seconds:6.1f} {silence:5.1f}  {command}", flush=True)
        if code != ends_with(command):
            complaints.append(f"{page}: {command} ended with {code}: {output[-600:]}")
        pictures |= check_picture(command)
        if " view " in command and "--from" in command:
            check_view(command)
    if missing := set(os.listdir("student/pictures")) - pictures:
        complaints.append(f"no command makes {sorted(missing)}")
    if len(sys.argv) > 3:
        with open(sys.argv[3], "w", encoding="utf-8") as file:
            file.write("| command | exit code | seconds | longest silence |\n|---|---|---|---|\n")
            file.writelines(f"| `{command}` | {code} | {seconds:.1f} | {silence:.1f} |\n" for _, command, code, seconds, silence in rows)
    print(*complaints, sep="\n")
    sys.exit(1 if complaints else 0)


main()
