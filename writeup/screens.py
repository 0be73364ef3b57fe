#!/usr/bin/env python3
"""screens.py [NAME ...]: makes docs/screens/*.png, which the handbook shows, or those of the names: what `watch` says in a
terminal of 80 by 24 characters, the page of a report, and the view of five bugs. Needs Chromium, and that ./run watch and
./run view --submission were built before."""
import html
import os
import pty
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PROGRAMS = os.path.join(ROOT, "build/check/grader")
COLUMNS, ROWS = 80, 24
COLORS = {"31": "#f08a7c", "32": "#8fd18a", "33": "#e8c66a", "1": None, "2": "#9a9a9a"}


def submission(folder):
    """Part 1 is written, with a mistake in hit_triangle; of the other parts there are the stubs."""
    shutil.copytree(os.path.join(ROOT, "student"), folder)
    for name in ("camera_ray", "estimate_pixel", "hit_sphere"):
        shutil.copy(os.path.join(ROOT, f"reference/1_rays/{name}.cpp"), os.path.join(folder, "1_rays"))
    shutil.copy(os.path.join(ROOT, "build/mistakes/hit_triangle/sum_of_weights_unchecked/hit_triangle.cpp"),
                os.path.join(folder, "1_rays/hit_triangle.cpp"))


def last_screen(command, until):
    """What a program shows in a terminal once `until` stands there, its last screen only."""
    child, terminal = pty.fork()
    if child == 0:
        os.environ["TERM"] = "xterm"
        subprocess.run(["stty", "rows", str(ROWS), "columns", str(COLUMNS)], check=True)
        os.execv(command[0], command)
    text, end = b"", time.time() + 60
    while not all(part in text.decode(errors="replace").rsplit("\x1b[2J", 1)[-1] for part in until):
        if time.time() > end:
            sys.exit(f"{command[0]} did not say {until}:\n" + text.decode(errors="replace").rsplit("\x1b[2J", 1)[-1])
        if select.select([terminal], [], [], 1)[0]:
            text += os.read(terminal, 4096)
    os.write(terminal, b"q")
    os.waitpid(child, 0)
    os.close(terminal)
    return text.decode().rsplit("\x1b[2J", 1)[-1].replace("\r", "")


def as_html(screen):
    """A screen with colours, as a page."""
    body = html.escape(screen.rstrip("\n"))
    body = re.sub("\x1b\\[K", "", body)
    body = re.sub("\x1b\\[0?m", "</span>", body)
    body = re.sub("\x1b\\[(\\d+)m", lambda found: "<span style='" + (
        f"color:{COLORS[found[1]]}" if COLORS.get(found[1]) else "font-weight:bold") + "'>", body)
    return ("<!doctype html><meta charset=utf-8><style>body{margin:0;background:#1d1f21;color:#e6e6e6}"
            "pre{font:14px/18px 'DejaVu Sans Mono',monospace;margin:12px 14px}</style><pre>" + body + "</pre>")


def take_picture(page, picture, width, height):
    subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                    f"--window-size={width},{height}", f"--screenshot={picture}", "file://" + page],
                   check=True, stderr=subprocess.DEVNULL, timeout=120)


# The five bugs of student/finding_by_looking.md: the mistake, the picture, the pixel, and the height of what is shown.
BUGS = [("2_bvh/hit_bvh", "range_overwritten", "bvh_coil", "44 27", 330), ("2_bvh/hit_bvh", "first_child_that_hits", "bvh_coil", "44 19", 490),
        ("1_rays/hit_triangle", "t_never_stored", "direct_large_light", "48 35", 490),
        ("4_global/trace_path", "bsdf_applied_twice", "global_indirect", "48 20", 612),
        ("5_adaptive/adaptive_pixel", "running_total_as_the_sample", "adaptive_fine", "16 12", 300)]
ONLY_FINDING = """<style>#status, main .note, .chooser, #controls, #reference_title, #reference, #draws, #ray, footer,
.brand, #own_title, .path tr > :nth-child(n + 8) { display: none !important } .stage { max-width: 320px }
main { gap: 0.2rem } main h2 { margin: 0.6rem 0 0.2rem; font-size: 1rem } body.view { padding-top: 0 }</style>"""


def add_style(page, style):
    with open(page, encoding="utf-8") as file:
        text = file.read().replace("</head>", style + "</head>")
    with open(page, "w", encoding="utf-8") as file:
        file.write(text)


def views(out, names, folder):
    """The page of ./run view for each bug, as its submission shows it."""
    build = os.path.join(ROOT, "build/check")
    for file, mistake, picture, pixel, height in BUGS:
        if names and mistake not in names:
            continue
        task = file.split("/")[1]
        handed_in, boxed, page = (os.path.join(folder, mistake + ending) for ending in ("", ".json", ".html"))
        shutil.copytree(os.path.join(ROOT, "reference"), handed_in)
        shutil.copy(os.path.join(ROOT, f"build/mistakes/{task}/{mistake}/{task}.cpp"), os.path.join(handed_in, os.path.dirname(file)))
        subprocess.run([build + "/measure/writeup_boxed", "build", handed_in, boxed, "view_boxed.json", task], check=True)
        subprocess.run([build + "/view/view", "--recipes", "scenes/recipes.json", "--boxed", boxed, "--reference", build + "/view/view_worker.reference",
                        "--mixture", f"{task}=student", picture, "--pixel", *pixel.split(), "--export", page], check=True, cwd=ROOT)
        add_style(page, ONLY_FINDING)
        take_picture(page, f"{out}/view_{mistake}.png", 600, height)


def main():
    out, names = os.path.join(ROOT, "docs/screens"), sys.argv[1:]
    os.makedirs(out, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        views(out, names, folder)
    if names:
        return
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        submission("student")
        page = os.path.join(folder, "watch.html")
        with open(page, "w", encoding="utf-8") as file:
            file.write(as_html(last_screen([PROGRAMS + "/watch"], ["expected", "q quit"])))
        take_picture(page, out + "/watch.png", 720, 24 + 18 * ROWS)
        page = os.path.join(ROOT, "build/screen.html")  # in the project, where it has links
        subprocess.run([PROGRAMS + "/grade", "hit_triangle", "--html", page],
                       check=False, stdout=subprocess.DEVNULL)
        take_picture(page, out + "/report.png", 760, 1420)
        os.remove(page)


main()
