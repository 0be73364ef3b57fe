#!/usr/bin/env python3
"""Checks that the render program compiles for another system, and for macOS what else a learner needs at home; links the render program, and
for macOS hint and compare, where the sources of their libraries are named. Nothing is downloaded: without the compiler the test is skipped (77).
other_systems.py windows | macos: CMake says how each file is compiled without FIRSTLIGHT_SERVICE, in a folder of its own.
Windows: Debian's mingw g++. macOS: zig (`zig c++`, in the path; its libc++ is older than Xcode's).
FIRSTLIGHT_SOURCES: the sources of libraries, with spaces between: tinyxml2.cpp (apt-get source tinyxml2), for macOS also zlib's *.c.
FIRSTLIGHT_LINKED: the folder where the programs are kept."""
import concurrent.futures, json, os, pathlib, shlex, shutil, subprocess, sys, tempfile

system, root = sys.argv[1], pathlib.Path(__file__).resolve().parents[2]
compiler, linked, only_compiled, package = {
    "windows": (["x86_64-w64-mingw32-g++-posix"], ["pt/render"], [], "apt-get install g++-mingw-w64-x86-64-posix libz-mingw-w64-dev"),
    "macos": (["zig", "c++", "-target", "aarch64-macos"], ["pt/render", "grader/hint", "grader/compare"],
              ["view/view", "view/view_worker.student", "grader/check.hit_sphere.student"], "zig 0.11 or newer"),
}[system]
if shutil.which(compiler[0]) is None:
    print(f"SKIPPED: the compiler for {system} is missing ({package})")
    sys.exit(77)
folder = pathlib.Path(tempfile.mkdtemp())
build = folder / "build"
subprocess.run(["cmake", "-S", root, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DFIRSTLIGHT_SERVICE=OFF"],
               stdout=subprocess.DEVNULL, check=True)

# The headers of libraries, without those of Linux beside them.
headers = folder / "headers"
headers.mkdir()
for name in ("fmt", "CLI", "stb", "tinyxml2.h", "tinyexr.h", "nlohmann", "gtest", "rapidcheck", "rapidcheck.h", "httplib.h", "kainjow"):
    (headers / name).symlink_to(pathlib.Path("/usr/include") / name)
(folder / "tinyexr.cpp").write_text("#include <algorithm>\n#define TINYEXR_IMPLEMENTATION\n#include <tinyexr.h>\n")
sources = os.environ.get("FIRSTLIGHT_SOURCES", "").split()
common = ["-isystem", str(headers), "-DFMT_HEADER_ONLY", "-O1"]
# A Mac has no kernels of x86-64.
other_machine = ("-DPT_X86_KERNELS", "-march=x86-64-v2", "-march=x86-64-v3", "-march=x86-64-v4") if system == "macos" else ()


def words(command):
    """The words of a command for g++ that say what is compiled and how, without optimisation, Linux and precompiled headers."""
    kept, all_words = [], shlex.split(command)[1:]
    while all_words:
        word = all_words.pop(0)
        if word in ("-o", "-c", "-include", "-isystem", "-MF", "-MT"):
            all_words.pop(0)
        elif word.startswith(("-I", "-D", "-std", "-f", "-m")) and word not in ("-flto=auto", "-DTINYXML2_IMPORT", *other_machine) \
                and not word.startswith("-DCPPHTTPLIB_"):
            kept.append(word)
    return kept


def compiled(number, source, flags):
    target = folder / f"{number}.o"
    done = subprocess.run([*compiler, *flags, *common, "-c", "-o", target, source], cwd=build, capture_output=True, text=True)
    return target, (done.stderr or "it cannot be run") if done.returncode else ""


def told_by_ninja(ending, *question):
    asked = subprocess.run(["ninja", "-C", build, "-t", *question], capture_output=True, text=True, check=True)
    return {line.strip() for line in asked.stdout.splitlines() if line.strip().endswith(ending)}


made = told_by_ninja(".cpp", "targets", "rule", "CUSTOM_COMMAND")
subprocess.run(["ninja", "-C", build, *made], stdout=subprocess.DEVNULL, check=True)
objects_of = {program: told_by_ninja(".o", "inputs", program) for program in linked + only_compiled}
objects = set().union(*objects_of.values())
commands = [(each["file"], shlex.split(each["command"])) for each in json.loads((build / "compile_commands.json").read_text())]
jobs = [(file, words(shlex.join(command)), command[command.index("-o") + 1]) for file, command in commands
        if command[command.index("-o") + 1] in objects and not (other_machine and "/kernel_v" in file)]
assert len(jobs) > 25, f"the programs have only {len(jobs)} files"
if sources:
    near = [word for source in sources for word in ("-isystem", str(pathlib.Path(source).parent))]
    jobs += [(source, [*near, "-w", *(["-x", "c"] if source.endswith(".c") else [])], None) for source in (*sources, str(folder / "tinyexr.cpp"))]
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    results = list(pool.map(compiled, range(len(jobs)), *list(zip(*jobs))[:2]))
failed = [(source, text) for (source, *_), (_, text) in zip(jobs, results) if text]
for source, text in failed:
    print(f"FAILED: {source} does not compile for {system}:\n{text}")
status = 1 if failed else 0
if not failed:
    print(f"{len(jobs)} files are compiled" + ("" if sources else "; they are not linked, because FIRSTLIGHT_SOURCES names no sources of libraries"))
for program in linked if sources and not failed else []:
    target = pathlib.Path(os.environ.get("FIRSTLIGHT_LINKED", folder)) / (program.split("/")[1] + (".exe" if system == "windows" else ""))
    parts = [str(each) for (*_, made), (each, _) in zip(jobs, results) if made is None or made in objects_of[program]]
    done = subprocess.run([*compiler, *(["-static"] if system == "windows" else []), *parts, *(["-lz"] if system == "windows" else []),
                           "-o", target], capture_output=True, text=True)
    status = max(status, done.returncode)
    print(done.stderr or f"{program}: {len(parts)} of them are linked, {target.stat().st_size >> 10} kB")
shutil.rmtree(folder)
sys.exit(1 if status else 0)
