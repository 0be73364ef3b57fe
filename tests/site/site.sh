#!/usr/bin/env bash
# The site of ./run site, made twice: the same bytes; its links; every page opened, in light and in dark; each live figure dragged, and
# its numbers compared with the same calls compiled for this machine. site.sh LIVE_CALLS. Skipped (77) if Chromium or emscripten is missing.
set -euo pipefail
live_calls=$1
# shellcheck source=tests/fixtures/browser.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/browser.sh"
command -v em++ >/dev/null || { echo 'SKIPPED: emscripten is missing (scripts/packages.txt)'; exit 77; }

./run site "$folder/site" >/dev/null
./run site "$folder/again" >/dev/null
diff -rq "$folder/site" "$folder/again" || complain 'the site has other bytes when it is made again'
python3 tests/site/pages.py "$folder/site" >"$folder/pages" || complain 'a page is wrong'

# drag ELEMENT X0 Y0 X1 Y1: with the pointer, in pixels from the middle.
drag() {
  local origin="\"origin\": {\"element-6066-11e4-a52e-4f735466cecf\": \"$1\"}"
  post "$session/actions" "{\"actions\": [{\"type\": \"pointer\", \"id\": \"mouse\", \"actions\": [
    {\"type\": \"pointerMove\", \"duration\": 0, \"x\": $2, \"y\": $3, $origin}, {\"type\": \"pointerDown\", \"button\": 0},
    {\"type\": \"pointerMove\", \"duration\": 100, \"x\": $4, \"y\": $5, $origin}, {\"type\": \"pointerUp\", \"button\": 0}]}]}" >/dev/null
}
# until_true WHAT: the script on standard input becomes true.
until_true() {
  local words
  words=$(cat)
  for _ in $(seq 100); do
    [ "$(script <<<"$words")" != '{"value":true}' ] || return 0
    sleep 0.1
  done
  expect "$1" <<<"$words"
}
# look: what the figure `name` shows, as a number.
look() {
  number <<<"return [...document.querySelector('#live-$name canvas').toDataURL()].reduce((sum, letter) => (sum * 31 + letter.charCodeAt(0)) % 1000003, 0);"
}
# scheme light | dark: what the reader's system asks for.
scheme() {
  post "$session/goog/cdp/execute" "{\"cmd\": \"Emulation.setEmulatedMedia\",
    \"params\": {\"features\": [{\"name\": \"prefers-color-scheme\", \"value\": \"$1\"}]}}" >/dev/null
}

figures=0
while IFS= read -r page; do
  go "file://$page"
  for light in dark light; do
    scheme $light
    expect "$page: texts stand out when it is $light" < <(grep -v '^//' tests/site/contrast.js)
  done
  for name in $(sed -n 's/.*data-figure="\([a-z_]*\)".*/\1/p' "$page"); do
    figures=$((figures + 1))
    until_true "$page: $name is drawn" <<<"return document.documentElement.dataset.live === 'ready' && document.querySelector('#live-$name').dataset.drawn >= 1;"
    script >/dev/null <<<"document.querySelector('#live-$name canvas').scrollIntoView({ block: 'center' });"
    before=$(look)
    # The tree is built, not dragged.
    if [ "$name" = tree ]; then
      script >/dev/null <<<"const slider = document.querySelector('#live-tree input'); slider.value = 5; slider.dispatchEvent(new Event('input'));"
    else
      canvas=$(element "#live-$name canvas")
      drag "$canvas" -150 40 -100 -20
    fi
    for _ in $(seq 50); do [ "$(look)" = "$before" ] || break; sleep 0.1; done
    [ "$(look)" != "$before" ] || complain "$name looks the same after a drag"
    script >"$folder/calls.json" <<<"return JSON.stringify(Object.fromEntries(Object.entries(live.calls).map(([name, { given, answer }]) => [name, { given, answer: [...answer] }])));"
    python3 tests/site/compare.py "$live_calls" "$folder/calls.json" || complain "$name shows other numbers than the reference"
    expect "$name: each slider and button has a name" <<<"return [...document.querySelectorAll('#live-$name input')].every((input) => input.labels.length === 1) && document.querySelector('#live-$name canvas').getAttribute('aria-label').length > 10;"
  done
done <"$folder/pages"
expected=$(grep -c '"name"' site/figures.json)
[ "$figures" -eq "$expected" ] || complain "$figures of $expected figures are on the pages"
finish_page
