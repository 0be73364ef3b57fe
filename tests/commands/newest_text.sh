#!/usr/bin/env bash
# newest_text.sh BUILD: tests that commands run the learner's files of this folder, as they are now. Nothing that was built for another folder
# is used, and a file that is saved while it is compiled is compiled again. BUILD is a build of the project; the commands run in a small tree, in
# which cmake and the compiler are scripts of the test.
# shellcheck disable=SC2016,SC2015
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
tree=$folder/tree task=student/1_rays/hit_sphere.cpp bin=$folder/bin
export PATH=$bin:$PATH

# In the real build, whatever is compiled from a learner's file depends on its text.
python3 - "$1/build.ninja" <<'END' || complain "an object does not depend on the text of the learner's file"
import re, sys
objects = re.findall(r"^build (\S+[.]o): (.*(?:/student/\S+|recorded/\w+[.]student)[.]cpp .*)$", open(sys.argv[1]).read(), re.M)
bad = [name for name, needs in objects if not re.search(r" saved/\d_\w+/\w+", needs)]
print(len(objects), "objects of learners' files; without their text:", bad)
sys.exit(len(bad) > 0 or len(objects) < 24)
END

# The compiler makes a program that prints the text of the task. The file $folder/during is a command that it runs when it has read the text.
mkdir -p "$bin"
cat >"$folder/compile" <<END
#!/bin/bash
text=\$(cat "\$2")
[ ! -e $folder/during ] || { mv $folder/during $folder/now; . $folder/now; sleep 0.05; }
case \$text in '#!'*) ;; *) text="#!/bin/sh
echo '  a promise'
echo '\$text'" ;; esac
echo "\$text" >"\$1"
chmod +x "\$1"
END
# The view starts the program of the tasks.
printf '#!/bin/sh\nwhile [ "$1" != --worker ]; do shift; done\nexec "$2"\n' >"$folder/view"
cat >"$bin/cmake" <<END
#!/bin/bash
while [ \$# -gt 0 ]; do
  case \$1 in -S) source=\$2; shift ;; --preset) preset=\$2; shift ;; esac
  shift
done
[ -n "\${preset-}" ] || exec /usr/bin/cmake "\$@"
cd "\$source" && mkdir -p build/\$preset/{saved/1_rays,pt,view,measure,grader} && cd build/\$preset
echo "CMAKE_HOME_DIRECTORY:INTERNAL=\$source" >CMakeCache.txt
: >saved/1_rays/hit_sphere
{
  printf 'rule compile\n  command = $folder/compile \$out \$in\nbuild build.ninja: phony\nbuild view/view: compile $folder/view\nbuild view: phony view/view\n'
  for program in pt/render view/view_worker.student measure/accuracy.student grader/check.hit_sphere.student grader/check.hit_sphere.sanitized; do
    echo "build \$program: compile ../../$task | saved/1_rays/hit_sphere"
    echo "build \${program##*/}: phony \$program"
  done
} >build.ninja
END
chmod +x "$folder/compile" "$bin/cmake"

mkdir -p "$tree/docs" "$tree/grader/check/language" "$tree/grader/tasks/hit_sphere" "$tree/pt/tasks" "$tree/student/1_rays" "$tree/build"
cp -r run scripts CMakePresets.json "$tree"
cp docs/help.txt "$tree/docs"
cp grader/tasks/hit_sphere/task.json "$tree/grader/tasks/hit_sphere"
cp pt/tasks/hit_sphere.h "$tree/pt/tasks"
printf '#!/bin/sh\nexec "$1"\n' >"$tree/grader/check/language/debug.sh"
chmod +x "$tree/grader/check/language/debug.sh"
# No package is missing here.
for uses in 'student class' 'test'; do touch "$tree/build/packages.$(. scripts/setup.sh && root=$PWD packages_for "$uses" | cksum | cut -d' ' -f1)"; done

commands=('render scene.dae -f a.png' 'cheapest scene.dae' 'debug hit_sphere' 'grade hit_sphere --from student'
  'grade hit_sphere --from student --sanitize' 'view scene.dae')
# says TEXT FOLDER COMMAND: the command in the folder runs a program of this text.
says() {
  local said
  # shellcheck disable=SC2086
  said=$("$2/run" $3 2>"$folder/errors" </dev/null) || true
  case $'\n'$said$'\n' in *$'\n'"$1"$'\n'*) ;; *) complain "$2: ./run $3 says '$said', not '$1': $(cat "$folder/errors")" ;; esac
}

number=0
save() { number=$((number + 1)) && echo "text $number" >"$1/$task"; }
save "$tree"
for command in "${commands[@]}"; do
  # shellcheck disable=SC2086
  says "text $number" "$tree" "$command"
  save "$tree"
  says "text $number" "$tree" "$command"
  # Saved while it is compiled.
  save "$tree"
  number=$((number + 1))
  echo "echo text $number >$tree/$task" >"$folder/during"
  says "text $number" "$tree" "$command"
  # Half a file is saved while it is compiled, and then the text of before.
  save "$tree"
  echo "cp $tree/$task $folder/before; echo half >$tree/$task; sleep 0.05; cp $folder/before $tree/$task" >"$folder/during"
  says "text $number" "$tree" "$command"
  # An older version comes back, with its old time.
  cp -p "$tree/$task" "$folder/older"
  save "$tree"
  says "text $number" "$tree" "$command"
  cp -p "$folder/older" "$tree/$task"
  says "$(cat "$folder/older")" "$tree" "$command"
  # Ctrl-C during a compile, after a save.
  save "$tree"
  number=$((number + 1))
  echo "echo text $number >$tree/$task; sleep 0.05; printf '#!/bin/sh\necho stale\n' >\"\$1\"; chmod +x \"\$1\"; kill -INT 0" >"$folder/during"
  # shellcheck disable=SC2086
  (set -m; "$tree/run" $command >/dev/null 2>&1 </dev/null) || true
  says "text $number" "$tree" "$command"
done

# The copy of a folder, a moved one, a second one, one with a space: each runs its own file, and says once that it builds.
made='was made for the folder'
copies() { # copies FOLDER WORDS: tests a folder with foreign files in build/
  save "$1"
  says "text $number" "$1" 'render scene.dae -f a.png'
  grep -qF "$made $2, and this folder is $1" "$folder/errors" || complain "$1: it does not say so: $(cat "$folder/errors")"
  says "text $number" "$1" 'render scene.dae -f a.png'
  [ ! -s "$folder/errors" ] || complain "$1: said twice: $(cat "$folder/errors")"
}
says "$(cat "$tree/$task")" "$tree" 'render scene.dae -f a.png'
text=$(cat "$tree/$task")
cp -r "$tree" "$folder/copy"
copies "$folder/copy" "$tree"
cp -a "$tree" "$folder/a copy"
copies "$folder/a copy" "$tree"
says "$text" "$tree" 'render scene.dae -f a.png'
[ ! -s "$folder/errors" ] || complain "the first folder builds again: $(cat "$folder/errors")"
mv "$folder/copy" "$folder/moved"
copies "$folder/moved" "$folder/copy"
# Another folder in the place where this one was made.
cp -a "$tree" "$folder/copy"
copies "$folder/copy" "$tree"
says "$(cat "$folder/moved/$task")" "$folder/moved" 'render scene.dae -f a.png'
# Copied while the first one builds.
save "$tree"
echo "rm -rf $folder/half; cp -r $tree $folder/half" >"$folder/during"
says "text $number" "$tree" 'render scene.dae -f a.png'
copies "$folder/half" "$tree"
# By a link it is the same folder, and nothing is built again.
ln -s "$tree" "$folder/link"
says "$(cat "$tree/$task")" "$folder/link" 'render scene.dae -f a.png'
[ ! -s "$folder/errors" ] || complain "a link is another folder: $(cat "$folder/errors")"
# Mounted in another place.
if unshare -m true 2>/dev/null; then
  mkdir "$folder/mounted"
  save "$tree"
  said=$(unshare -m bash -c "mount --bind '$tree' '$folder/mounted' && '$folder/mounted/run' render scene.dae -f a.png" 2>"$folder/errors") || true
  [ "${said##*$'\n'}" = "text $number" ] && grep -qF "$made $tree" "$folder/errors" || complain "mounted: it says '$said', $(cat "$folder/errors")"
fi
# What is kept goes with it, and a list of figures does not show the other folder's.
mkdir -p "$tree/build/writeup"
touch "$tree/build/writeup/kept"
rm -rf "$folder/copy"
cp -r "$tree" "$folder/copy"
says "$(cat "$folder/copy/$task")" "$folder/copy" 'render scene.dae -f a.png'
[ ! -e "$folder/copy/build/writeup" ] || complain "kept results of another folder are left"

finish
