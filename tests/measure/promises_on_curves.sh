#!/usr/bin/env bash
# Every right solution keeps the promises that its task's curves show, at all places and with all cases.
# promises_on_curves.sh STABILITY: the program.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
"$1" --out "$folder" >"$folder/text"
python3 - "$folder/stability.json" <<'END'
import json, os, sys

# With their own roulette, so few paths are long that their mean and its error are not measurable.
RARE = {("many_bounces", name) for name in
        ("survival_three_tenths", "survival_eight_tenths",
         "survival_by_luminance", "survival_by_throughput", "survival_by_albedo")}

problems, promises = [], 0
for chart in json.load(open(sys.argv[1]))["charts"]:
    promises += len(chart["promised"])
    for broken in chart["broken"]:
        right = f'grader/tasks/{chart["slug"]}/right/{broken["id"]}.cpp'
        if (chart["name"], broken["id"]) in RARE:
            continue
        if not broken["bonus"] and (broken["id"] == "reference" or os.path.exists(right)):
            problems.append(f'{chart["slug"]}.{chart["name"]}: {broken["id"]} at {broken["place"]:g}')
if promises < 20:
    problems.append(f"only {promises} promises")
sys.exit("\n".join(["promises that right solutions break on curves:"] + problems) if problems else 0)
END
