#!/usr/bin/env python3
"""precompiled_fits.py SOURCE FOLDER: configures SOURCE in FOLDER with precompiled headers, as on a machine without a compiler
cache, and names the files that are compiled without a macro with which their precompiled header was made: the compiler
refuses the header there ("not used because X not defined"), and a build with warnings as errors fails. Nothing is compiled.
Exit code 1 if there is such a file, or if nothing is precompiled."""
import json
import os
import shlex
import subprocess
import sys


def configure(source, folder):
    command = ["cmake", "--preset", "check", "-B", folder, "-DFIRSTLIGHT_PCH=ON", "-DFIRSTLIGHT_MIXTURES="]
    result = subprocess.run(command, cwd=source, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if result.returncode != 0:
        sys.exit(result.stdout)


def read_command(command):
    """Its macros (-DNAME or -DNAME=VALUE), and the header that it includes before everything else, or None."""
    words = shlex.split(command)
    macros = {word for word in words if word.startswith("-D")}
    headers = [words[i + 1] for i, word in enumerate(words[:-1]) if word == "-include"]
    return macros, next((header for header in headers if header.endswith("cmake_pch.hxx")), None)


def main():
    source, folder = sys.argv[1:]
    configure(source, folder)
    with open(os.path.join(folder, "compile_commands.json"), encoding="utf-8") as file:
        commands = [(each["file"], *read_command(each["command"])) for each in json.load(file)]
    made = {header: macros for path, macros, header in commands if header and path.startswith(header)}
    users = [(path, macros, header) for path, macros, header in commands if header and not path.startswith(header)]
    if not made or not users:
        print("no header is precompiled")
        return 1
    wrong = [(path, sorted(made[header] - macros), header) for path, macros, header in users if made[header] - macros]
    for path, missing, header in wrong:
        print(f"{path} is compiled without {' '.join(missing)}, with which {os.path.relpath(header, folder)} was made: "
              "link the library that defines it, or name the target after EXCEPT")
    print(f"{len(users)} files include {len(made)} precompiled headers, {len(wrong)} of them refused")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
