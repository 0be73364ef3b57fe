#!/usr/bin/env python3
"""pages.py: checks that the pages of the project agree with its files. Every relative link and its anchor lead somewhere; every
task has a chapter; every picture of the handbook has the command below it that makes it (writeup/handbook.json has its settings);
a mistake that a page names exists; the points in sample tables can occur; and a page that says "more than N" of something that
can be counted is right. Promises that the view names are in a contract."""
import glob
import json
import os
import re
import sys

os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../.."))
HANDOUT = "scripts/editions/handout_README.md"  # it is at the root of the handout
complaints = []


def read(name):
    with open(name, encoding="utf-8") as file:
        return file.read()


def pages():
    for folder, folders, files in os.walk("."):
        folders[:] = [name for name in folders if name not in ("build", ".git")]
        yield from (os.path.relpath(os.path.join(folder, name)) for name in files if name.endswith(".md"))


def anchors(text):
    """The anchors of a page's headings, as GitHub makes them."""
    headings = re.findall(r"^#+ (.*)$", text, re.M)
    return {re.sub(r"[^a-z0-9_-]", "", heading.lower().replace(" ", "-")) for heading in headings}


def check_links(page, text):
    folder = "." if page == HANDOUT else os.path.dirname(page)
    for link in re.findall(r"\]\(([^)\s]+)\)", text) + re.findall(r'<img src="([^"]+)"', text):
        if re.match(r"[a-z]+:", link):
            continue
        name, _, anchor = link.partition("#")
        target = os.path.normpath(os.path.join(folder, name)) if name else page
        if not os.path.exists(target):
            complaints.append(f"{page}: nothing at '{link}'")
        elif anchor and anchor not in anchors(read(target)):
            complaints.append(f"{page}: no heading for '{link}'")


def shown_mistakes(task):
    """The mistakes of a task that are in a handout."""
    return re.findall(rf"\b{task}/([a-z0-9_]+)", re.search(r"set\(FIRSTLIGHT_SHOWN_MISTAKES ([^)]*)", read("cmake/mistakes.cmake"))[1])


def check_names(page, text):
    for scene in re.findall(r"\./run .*?(scenes/[a-z_]+\.dae)", text):
        if not os.path.exists(scene):
            complaints.append(f"{page}: no scene '{scene}'")
    for task, name in re.findall(r"^    \./run .*--from ([a-z_]+)=([a-z0-9_]+)", text, re.M):
        if name not in ("student", "reference") and name not in shown_mistakes(task):
            complaints.append(f"{page}: a handout has no mistake {task}={name} (cmake/mistakes.cmake)")


def check_points(page, text):
    """The rows of a sample table have the number of possible points that follows from the usual worth of a promise and of a picture."""
    for slug, got, possible in re.findall(r"^ +[1-9]\.[0-9]  ([a-z_]+) +[a-z]+ +([0-9]+)/([0-9]+)", text, re.M):
        promises = len([line for line in re.findall(r"^//   - .*", read(f"pt/tasks/{slug}.h"), re.M) if "(bonus)" not in line])
        pictures = len([line for line in re.findall(r'"tasks".*', read("scenes/recipes.json")) if f'"{slug}"' in line])
        if int(possible) != promises + 3 * pictures or int(got) > int(possible):
            complaints.append(f"{page}: {slug} has {promises + 3 * pictures} points, not {got}/{possible}")


# Options of ./run render by the names of the settings.
VALUES = {"samples": "-s", "bounces": "-m", "light_samples": "-l", "adaptive": "-a", "size": "-r", "camera": "--camera", "engine": "--engine"}
DEFAULTS = {"-m": "5", "-l": "1"}


def options(words):
    """The options of a command that change its picture: name -> value."""
    found, name = {}, None
    for word in words:
        if re.match(r"--?[A-Za-z]", word):
            name = word
            found.setdefault(name, [])
        elif name:
            found[name].append(word)
    return {name: " ".join(values) for name, values in found.items()}


def expected_command(figure, plan):
    """The scene and the options of the command that makes a picture in a handout."""
    picture = figure["pictures"][0]
    settings = {**plan["defaults"], **figure.get("settings", {}), **picture}
    expected = {option: " ".join(map(str, settings[name])) if isinstance(settings[name], list) else str(settings[name])
                for name, option in VALUES.items() if name in settings}
    if settings.get("hemisphere"):
        expected["-H"] = ""
    if "bounces" in picture:
        expected.update({"--show": "bounce", "--bounce": str(picture["bounces"][0])})
        expected.pop("-m")
    elif "show" in settings:
        expected["--show"] = settings["show"]
    mistake = settings.get("mistake")
    choices = [f"{task}={mistake}" for task in os.listdir("grader/tasks") if mistake in shown_mistakes(task)]
    expected["--from"] = " ".join(["reference"] + (["hit_sphere=student"] if mistake == "no_spheres" else choices))
    return plan["scenes"][settings["scene"]]["own"], expected


def check_pictures():
    plan = json.loads(read("writeup/handbook.json"))
    chapters = {name: read(name) for name in glob.glob("student/*/README.md")}
    for figure in plan["figures"]:
        file = figure["file"]
        if not file.startswith("student/pictures/"):
            continue
        name = os.path.basename(file)
        if os.path.getsize(file) > 120 * 1024:
            complaints.append(f"{file} is larger than 120 KiB")
        shown = [(page, text) for page, text in chapters.items() if f"pictures/{name})" in text]
        if not shown:
            complaints.append(f"no page shows {file}")
        for page, text in shown:
            # The first command below the picture. Sample-rate pictures are written next to the picture that a command names.
            output = re.sub(r"_rate\.png$", ".png", name)
            made = re.compile(rf"^    \./run render (\S+) (.*-f {re.escape(output)}\b.*)$", re.M)
            command = made.search(text, text.index(f"pictures/{name})")) or made.search(text)
            if not command:
                complaints.append(f"{page}: no command makes {name}")
                continue
            scene, expected = expected_command(figure, plan)
            got = options(command[2].split())
            del got["-f"]
            for default in DEFAULTS.items():
                got.setdefault(*default)
                expected.setdefault(*default)
            if command[1] != scene or got != expected:
                differs = {key: (got.get(key), expected.get(key)) for key in {*got, *expected} if got.get(key) != expected.get(key)}
                complaints.append(f"{page}: the command below {name} makes another picture: {command[1]}, {differs} (here, in handbook.json)")
    known = {figure["file"] for figure in plan["figures"]}
    # What README shows first is made by the reference, and loads at once.
    first = re.search(r'<img src="([^"]+)"', read("README.md"))
    if not first or first[1] not in {figure["file"] for figure in plan["figures"] if figure["part"] == "readme"}:
        complaints.append("README.md: writeup/handbook.json does not make its first picture")
    elif os.path.exists(first[1]) and os.path.getsize(first[1]) > 600 * 1024:
        complaints.append(f"{first[1]} is larger than 600 KiB")
    for file in glob.glob("student/pictures/*.png"):
        if file not in known:
            complaints.append(f"writeup/handbook.json does not make {file}")


def check_tasks():
    chapters = [read(name) for name in glob.glob("student/*/README.md")]
    for contract in glob.glob("pt/tasks/*.h"):
        slug = os.path.basename(contract)[:-2]
        if not any(re.search(rf"^## [0-9.]+ {slug}$", text, re.M) for text in chapters):
            complaints.append(f"no chapter for {slug}")
        if not any(f"tasks/{slug}.h" in text for text in chapters):
            complaints.append(f"no link to {contract}")


def check_promises():
    """Every promise that the view names is in a contract."""
    contracts = "".join(read(name) for name in glob.glob("pt/tasks/*.h"))
    promises = {re.sub(r"[^a-z0-9]+", "_", name.strip().replace("'", "").lower()) for name in re.findall(r"^//   - ([^:(]*)", contracts, re.M)}
    for file in glob.glob("view/worker/*.cpp"):
        for name in re.findall(r'"([a-z0-9]+(?:_[a-z0-9]+){2,})"', read(file)):
            if name not in promises:
                complaints.append(f"{file}: no contract has the promise '{name}'")


def count(pattern, files):
    return sum(len(re.findall(pattern, read(name), re.M)) for name in glob.glob(files))


COUNTED = {"promises": lambda: count(r"^//   - ", "pt/tasks/*.h"),
           "wrong solutions": lambda: count(r"^(name|guard) ", "grader/tasks/*/mistakes.txt"),
           "figures": lambda: len(json.loads(read("writeup/figures.json"))["figures"]),
           "correct variants": lambda: len(glob.glob("grader/tasks/*/right/*.cpp"))}


def check_counts(page, text):
    """"more than N things": there are more, and not many more."""
    for number, things in re.findall(r"[Mm]ore than ([0-9]+) (%s)" % "|".join(COUNTED), " ".join(text.split())):
        if not int(number) < COUNTED[things]() <= 1.25 * int(number):
            complaints.append(f"{page}: there are {COUNTED[things]()} {things}, not 'more than {number}'")
    return len(re.findall(r"[Mm]ore than [0-9]+ (?:%s)" % "|".join(COUNTED), " ".join(text.split())))


def main():
    names, counts = sorted(pages()), 0
    for page in names:
        text = read(page)
        check_links(page, text)
        check_names(page, text)
        check_points(page, text)
        counts += check_counts(page, text)
    if len(names) < 20 or counts < 2:
        complaints.append(f"only {len(names)} pages and {counts} counts found")
    check_pictures()
    check_tasks()
    check_promises()
    for complaint in complaints:
        print(complaint)
    print(f"{len(names)} pages, {len(complaints)} complaints")
    return len(complaints) > 0


if __name__ == "__main__":
    sys.exit(main())
