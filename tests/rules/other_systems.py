#!/usr/bin/env python3
"""Checks with Debian's mingw g++ that the render program compiles for Windows, and compiles and links it where tinyxml2's source and a
zlib for Windows are found. Nothing is downloaded: without the compiler the test is skipped (77).
windows.py BUILD: the build folder whose render program is taken; its compile commands say how each file is compiled.
FIRSTLIGHT_TINYXML2: the file tinyxml2.cpp (apt-get source tinyxml2). FIRSTLIGHT_WINDOWS: where render.exe is kept."""
import concurrent.futures, json, os, pathlib, shlex, shutil, subprocess, sys, tempfile

build = pathlib.Path(sys.argv[1]).resolve()
compiler = shutil.which("x86_64-w64-mingw32-g++-posix")
if compiler is None:
    print("SKIPPED: the compiler for Windows is missing (apt-get install g++-mingw-w64-x86-64-posix libz-mingw-w64-dev)")
    sys.exit(77)
folder = pathlib.Path(tempfile.mkdtemp())

# The headers of libraries, without those of Linux beside them.
headers = folder / "headers"
headers.mkdir()
for name in ("fmt", "CLI", "stb", "tinyxml2.h", "tinyexr.h"):
    (headers / name).symlink_to(pathlib.Path("/usr/include") / name)
(folder / "tinyexr.cpp").write_text("#include <algorithm>\n#define TINYEXR_IMPLEMENTATION\n#include <tinyexr.h>\n")
tinyxml2 = os.environ.get("FIRSTLIGHT_TINYXML2", "")
common = ["-isystem", str(headers), "-DFMT_HEADER_ONLY", "-O1"]


def words(command):
    """The words of a command for g++ that say what is compiled and how, without optimisation, Linux and precompiled headers."""
    kept, all_words = [], shlex.split(command)[1:]
    while all_words:
        word = all_words.pop(0)
        if word in ("-o", "-c", "-include", "-isystem", "-MF", "-MT"):
            all_words.pop(0)
        elif word.startswith(("-I", "-D", "-std", "-f", "-m")) and word not in ("-flto=auto", "-DTINYXML2_IMPORT"):
            kept.append(word)
    return kept


def compiled(number, source, flags):
    target = folder / f"{number}.o"
    what = ["-c", "-o", target] if tinyxml2 else ["-fsyntax-only"]
    done = subprocess.run([compiler, *flags, *common, *what, source], cwd=build, capture_output=True, text=True)
    return target, done.stderr if done.returncode else ""


asked = subprocess.run(["ninja", "-C", build, "-t", "inputs", "pt/render"], capture_output=True, text=True, check=True)
objects = {line.strip() for line in asked.stdout.splitlines() if line.endswith(".o")}
commands = json.loads((build / "compile_commands.json").read_text())
jobs = [(each["file"], words(each["command"])) for each in commands
        if shlex.split(each["command"])[shlex.split(each["command"]).index("-o") + 1] in objects]
assert len(jobs) > 25, f"the render program has only {len(jobs)} files"
if tinyxml2:
    jobs += [(tinyxml2, []), (folder / "tinyexr.cpp", ["-w"])]
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    results = list(pool.map(compiled, range(len(jobs)), *zip(*jobs)))
failed = [(source, text) for (source, _), (_, text) in zip(jobs, results) if text]
for source, text in failed:
    print(f"FAILED: {source} does not compile for Windows:\n{text}")
status = 1 if failed else 0
if not failed and tinyxml2:
    target = pathlib.Path(os.environ.get("FIRSTLIGHT_WINDOWS", folder)) / "render.exe"
    linked = subprocess.run([compiler, "-static", *(str(each) for each, _ in results), "-lz", "-o", target], capture_output=True, text=True)
    status = linked.returncode
    print(linked.stderr or f"{len(jobs)} files are compiled and linked: {target.stat().st_size >> 10} kB")
elif not failed:
    print(f"{len(jobs)} files are compiled; they are not linked, because FIRSTLIGHT_TINYXML2 does not name tinyxml2.cpp")
shutil.rmtree(folder)
sys.exit(1 if status else 0)
