#!/usr/bin/env bash
# Runs the steps of the workflows for GitHub and GitLab, as they stand in the files of the handout, in the folder of a handout:
# the table is in the summary or in the log, and the page is where the platform looks for it.
# workflows.sh BUILD [HANDOUT]: without HANDOUT, in a folder in which ./run is the grader of BUILD.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
python3 -c 'import yaml' 2>/dev/null || { echo 'SKIPPED: python3-yaml is missing (scripts/packages.txt)'; exit 77; }
build=$1 handout=${2:-$folder/handout}
if [ $# -eq 1 ]; then
  mkdir -p "$handout/.github/workflows" "$handout/student/1_rays"
  cp scripts/editions/ci/github.yml "$handout/.github/workflows/grade.yml"
  cp scripts/editions/ci/gitlab.yml "$handout/.gitlab-ci.yml"
  cp student/1_rays/hit_sphere.cpp "$handout/student/1_rays"
  printf '#!/bin/sh\nshift\nexec "%s" hit_sphere --no-pictures "$@"\n' "$build/grader/grade" >"$handout/run"
  chmod +x "$handout/run"
fi

# part FILE PATH: prints what a file has at a path, such as jobs/grade/steps; a list gets a line for each.
part() {
  python3 - "$@" <<'PYTHON'
import sys, yaml
found = yaml.load(open(sys.argv[1]), yaml.BaseLoader)
for name in sys.argv[2].split("/"):
    found = [each[name] for each in found if name in each] if isinstance(found, list) else found[name]
print("\n".join(found) if isinstance(found, list) else found)
PYTHON
}

# job STATUS SHELL ...: runs the script on standard input as the platform does, without the variables of this shell, with that exit status;
# $folder/said is its log.
job() {
  local status=$1 got=0
  rm -f "$folder/summary" "$handout/"{report.html,report.xml,table.txt}
  cat >"$folder/step"
  [ -s "$folder/step" ] || complain 'the workflow has no steps'
  (cd "$handout" && env -i PATH=/usr/bin:/bin HOME="$folder" GITHUB_STEP_SUMMARY="$folder/summary" "${@:2}" "$folder/step" >"$folder/said" 2>&1 </dev/null) || got=$?
  [ "$got" -eq "$status" ] || complain "the job ended with $got, not $status: $(cat "$folder/step" "$folder/said")"
}

github=$handout/.github/workflows/grade.yml gitlab=$handout/.gitlab-ci.yml
job 1 bash --noprofile --norc -eo pipefail < <(part "$github" jobs/grade/steps/run)
grep -qE '1\.4 +hit_sphere +not attempted +0/' "$folder/summary" || complain "the summary has no table: $(cat "$folder/summary" "$folder/said")"
[ "$(grep -c '^```$' "$folder/summary")" = 2 ] || complain 'the table would be shown as running text'
page=$(part "$github" jobs/grade/steps/with/path)
grep -q '</html>' "$handout/$page" || complain 'the artefact of GitHub is no page'

job 1 bash -e < <(part "$gitlab" grade/script)
grep -qE '1\.4 +hit_sphere +not attempted +0/' "$folder/said" || complain "the log has no table: $(cat "$folder/said")"
grep -q '</html>' "$handout/$(part "$gitlab" grade/artifacts/paths)" || complain 'the artefact of GitLab is no page'
grep -q '<testcase' "$handout/$(part "$gitlab" grade/artifacts/reports/junit)" || complain 'GitLab gets no tests'

# What is right is green.
cp -r reference/*_* "$handout/student"
job 0 bash --noprofile --norc -eo pipefail < <(part "$github" jobs/grade/steps/run)
job 0 bash -e < <(part "$gitlab" grade/script)
[ $# -eq 1 ] || git -C "$handout" checkout --quiet student
rm -f "$handout/"{report.html,report.xml,table.txt}
finish
