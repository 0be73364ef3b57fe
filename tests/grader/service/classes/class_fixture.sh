# shellcheck shell=bash
# For tests, to be sourced: a class of cheap submissions, and a grader that logs what it judges. Sets `folder`, which is
# removed at the end (with Slurm if it runs there); uses `grader`, the programs' folder.
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../../fixtures/shell.sh"
# shellcheck source=tests/grader/service/classes/slurm_loopback.sh
. tests/grader/service/classes/slurm_loopback.sh
stops=yes
also_end() { stop_slurm "$folder/slurm"; }

# pack_learner NUMBER: turns the folder into an archive.
pack_learner() (
  cd "$folder/class/learner $1" || exit
  cmake -E tar cf "../learner $1.zip" --format=zip hit_sphere.cpp
  rm -r "../learner $1"
)

# make_class N: submissions in $folder/class, of hit_sphere alone: right, wrong, stubs, equal files, and an unreadable file.
# Every fourth is an archive.
make_class() {
  local i from wrong=(build/mistakes/hit_sphere/*/hit_sphere.cpp)
  for i in $(seq -w "$1"); do
    mkdir -p "$folder/class/learner $i"
    case $((10#$i % 5)) in
      0) from=student/1_rays/hit_sphere.cpp ;;
      1 | 2) from=reference/1_rays/hit_sphere.cpp ;;
      *) from=${wrong[10#$i % ${#wrong[@]}]} ;;
    esac
    cp "$from" "$folder/class/learner $i/hit_sphere.cpp"
    # Otherwise nearly all would be equal.
    [ $((10#$i % 5)) -eq 2 ] || echo "// by learner $i" >>"$folder/class/learner $i/hit_sphere.cpp"
    [ $((10#$i % 4)) -ne 0 ] || pack_learner "$i"
  done
  mkdir "$folder/class/nobody"
}

# log_what_is_judged GRADER: $folder/programs gets the programs of that folder, and a `grade` that first writes the
# submission's name into $folder/judged. They read points and everything else from $folder/root.
log_what_is_judged() {
  local entry
  mkdir "$folder/programs" "$folder/root" "$folder/root/grader"
  cp -r pt "$folder/root"
  ln -s "$PWD/scenes" "$PWD/golden" "$folder/root"
  for entry in grader/*; do ln -s "$PWD/$entry" "$folder/root/grader"; done
  rm "$folder/root/grader/points.json"
  cp grader/points.json "$folder/root/grader"
  ln -s "$1/unpack" "$folder/programs/unpack"
  cp "$1/grade.json" "$folder/programs/grade.json"
  cat >"$folder/programs/grade" <<END
#!/bin/bash
for word; do case \$word in --name=*) echo "\${word#--name=}" >>'$folder/judged' ;; esac; done
exec '$1/grade' --config '$folder/programs/grade.json' "\$@"
END
  chmod +x "$folder/programs/grade"
  python3 - "$folder" <<'END'
import json, sys
path = sys.argv[1] + "/programs/grade.json"
config = json.load(open(path))
config["work"] = sys.argv[1] + "/work"
config["root"] = sys.argv[1] + "/root"
json.dump(config, open(path, "w"))
END
}

# grade_class OUT [STEP] ARGUMENTS...: runs the program with seed 7. STEP: plan, or empty for all steps.
grade_class() {
  local out=$1 step=()
  shift
  [ "${1:-}" != plan ] || { step=(plan); shift; }
  "${grader:?}/grade_class" "${step[@]}" "$folder/class" --out "$folder/$out" --seed 7 --not-isolated \
    --config "$folder/programs/grade.json" "$@" -- hit_sphere --no-pictures >"$folder/said" 2>&1
}

# judged_once: no submission was judged twice; empties the log.
judged_once() {
  local twice
  twice=$(sort "$folder/judged" | uniq -d)
  [ -z "$twice" ] || complain "judged twice: $twice"
  rm -f "$folder/judged"
}

# same_table A B: the tables of the two folders are equal, and so is what is alike.
same_table() {
  diff "$folder/$1/class.csv" "$folder/$2/class.csv" >&2 || complain "the table of $2 is not that of $1"
  diff -r "$folder/$1/likeness" "$folder/$2/likeness" >&2 && diff "$folder/$1/likeness.html" "$folder/$2/likeness.html" >&2 ||
    complain "$2 finds other files alike than $1"
}

# same_reports A B: every report in the two folders is equal, byte by byte, except for times. What only says how the class was
# cut and run may differ.
same_reports() {
  python3 - "$folder/$1" "$folder/$2" <<'END' || complain "the reports of $2 are not those of $1"
import os, re, sys, zipfile
OF_THE_RUN = re.compile(r"plan\.json|claims|joblog|engine\.log|(slurm|unpacked)/.*")
TIMES = re.compile(rb'"seconds": ?[0-9.e+-]+|[0-9.]+ s(econds)?\b')
def reports(folder):
    all = {}
    for top, _, files in os.walk(folder):
        for file in files:
            path = os.path.relpath(os.path.join(top, file), folder)
            if OF_THE_RUN.fullmatch(path): continue
            if path.endswith(".zip"):
                packed = zipfile.ZipFile(os.path.join(top, file))
                all.update({path + ":" + name: packed.read(name) for name in packed.namelist()})
            else:
                all[path] = open(os.path.join(top, file), "rb").read()
    return {path: TIMES.sub(b"TIME", text) if re.search(r"(json|html)$", path) else text for path, text in all.items()}
a, b = map(reports, sys.argv[1:])
assert set(a) == set(b) and len(a) > 8, set(a) ^ set(b)
differ = sorted(path for path in a if a[path] != b[path])
for path in differ:
    at = next((i for i, (x, y) in enumerate(zip(a[path], b[path])) if x != y), 0)
    print(path, a[path][max(0, at - 60):at + 60], b[path][max(0, at - 60):at + 60], sep="\n  ")
sys.exit(bool(differ))
END
}
