#!/usr/bin/env bash
# The page of a report, opened in Chromium from a file (WebDriver, W3C 2018): the slider moves the edge of the
# render, a pointer reads pixels, texts stay texts, and the console stays empty. Then the page of a class,
# which sorts its rows.
# page.sh EXAMPLE_PAGE: the program that writes the pages. Skipped (77) if Chromium is missing.
set -euo pipefail

# shellcheck source=tests/fixtures/browser.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../fixtures/browser.sh"
"$1" "$folder"
go "file://$folder/page.html"

viewer="document.getElementById('direct_lights.penumbra').querySelector('.viewer')"
expect 'the page has come to life' <<E2
return document.documentElement.classList.contains('scripted')
  && document.querySelectorAll('.compare.live').length === document.querySelectorAll('.viewer').length
  && document.querySelectorAll('.viewer').length === 5;
E2
expect 'pictures are shown' <<E2
return [...document.images].every((image) => image.complete && image.naturalWidth > 0
  && image.src.startsWith('data:'));
E2
expect 'texts stay texts' <<'E2'
return window.harmed === undefined && document.scripts.length === 1
  && document.body.innerText.includes('<script>window.harmed = 1</' + 'script>')
  && document.body.innerText.includes('{{verdict}}');
E2

before="return getComputedStyle($viewer.querySelector('.layer.render')).clipPath"
expect 'the render ends in the middle at first' <<E2
$before === 'inset(0px 50% 0px 0px)';
E2
script >/dev/null <<E2
for (let each = $viewer; each; each = each.parentElement) if (each.tagName === 'DETAILS') each.open = true;
$viewer.querySelector('.differs').open = true;
$viewer.scrollIntoView();
E2
slider=$(element '[id=\"direct_lights.penumbra\"] .split')
quarter=$(number <<E2
return Math.round($viewer.querySelector('.split').getBoundingClientRect().width / 4);
E2
)
pointer "$slider" "-$quarter" 0 click
expect 'a click on the slider moves the edge of the render to the left' <<E2
const kept = /^inset\(0px ([0-9.]+)% 0px 0px\)\$/.exec(getComputedStyle(
  $viewer.querySelector('.layer.render')).clipPath);
return kept !== null && kept[1] > 70 && kept[1] < 80;
E2
expect 'the line follows it' <<E2
const line = $viewer.querySelector('.divider').getBoundingClientRect();
const stage = $viewer.querySelector('.stage').getBoundingClientRect();
const place = (line.left + line.width / 2 - stage.left) / stage.width;
return place > 0.2 && place < 0.3;
E2

# Pixel (44, 20) of the golden is (0.4 + 0.6 * 20 / 72) * (0.35, 0.4, 0.45), Y its luminance; the render
# is 21 % below it there, give or take 5 %.
stage=$(element '[id=\"direct_lights.penumbra\"] .compare .stage')
offset() {
  number <<E2
const box = $viewer.querySelector('.compare .stage').getBoundingClientRect();
return Math.round($1);
E2
}
pointer "$stage" "$(offset '(44.5 / 96 - 0.5) * box.width')" "$(offset '(20.5 / 72 - 0.5) * box.height')"
expect 'the pixel under the pointer is read' <<E2
const lines = [...$viewer.querySelectorAll('.readout tr')].map(
  (line) => [...line.children].map((cell) => cell.textContent));
const off = parseFloat(lines[3][4].replace('\\u2212', '-'));
return $viewer.querySelector('.where').textContent.startsWith('x 44, y 20 from the top left')
  && lines[2].join(' ') === 'golden 0.198 0.227 0.255 0.223' && off > -50 && off < -1
  && lines[4][4].startsWith('\\u00b1 ');
E2
expect 'and marked in all maps' <<E2
return [...$viewer.querySelectorAll('.stage')].every((stage) => {
  const box = stage.getBoundingClientRect();
  const cross = stage.querySelector('.cross').getBoundingClientRect();
  return Math.abs((cross.left - box.left) / box.width - 44 / 96) < 0.01
    && Math.abs((cross.top - box.top) / box.height - 20 / 72) < 0.01;
});
E2
post "$session/element/$stage/value" "{\"text\": \"\uE014\uE014\uE015\"}" >/dev/null
expect 'arrow keys move it' <<E2
return $viewer.querySelector('.where').textContent.startsWith('x 46, y 21 ');
E2
button=$(element '[id=\"direct_lights.penumbra\"] .cells button')
post "$session/element/$button/click" '{}' >/dev/null
expect 'a block in the list is found' <<E2
return $viewer.querySelector('.where').textContent.startsWith('x 52, y 28 ');
E2

expect 'a picture of two tasks is shown with the other one too, once it is opened' <<'E2'
location.hash = '#adaptive_pixel.two_lights';
return document.querySelectorAll('[data-place]').length === 1;
E2
for _ in $(seq 100); do
  [ "$(number <<<"return document.querySelectorAll('[data-place]').length")" -ne 0 ] || break
  sleep 0.1
done
expect 'and there it lives' <<'E2'
const copy = document.getElementById('adaptive_pixel.two_lights').querySelector('.viewer');
const split = copy.querySelector('.split');
split.value = 30;
split.dispatchEvent(new Event('input'));
copy.querySelector('.stage').dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowLeft'}));
const original = document.getElementById('direct_lights.two_lights').querySelector('.compare');
return copy.checkVisibility() && copy.querySelector('.compare').style.getPropertyValue('--split') === '30%'
  && original.style.getPropertyValue('--split') === '50%'
  && copy.querySelector('.where').textContent.startsWith('x 47, y 36 ');
E2

go "file://$folder/class.html"
expect 'a class of a thousand has a row each' <<'E2'
return document.querySelectorAll('.class tbody tr').length === 1000
  && document.querySelectorAll('.class td.problem').length === 20;
E2
post "$session/window/rect" '{"width": 500, "height": 844}' >/dev/null
expect 'on a phone the table alone is wider than the page' <<'E2'
const table = document.querySelector('.class'), place = table.parentElement;
return document.documentElement.scrollWidth <= innerWidth && place.scrollWidth > place.clientWidth;
E2
post "$session/window/rect" '{"width": 1280, "height": 900}' >/dev/null
expect 'and texts stay texts there' <<'E2'
return window.harmed === undefined && document.scripts.length === 1
  && document.body.innerText.includes('<script>window.harmed = 1</' + 'script>');
E2
expect 'a head that is pressed sorts, once more the other way round, and problems come last' <<'E2'
const head = document.querySelectorAll('.class th button')[2];
const points = () => [...document.querySelectorAll('.class tbody tr')].map(
  (row) => row.querySelector('.problem') ? NaN : Number(row.cells[2].dataset.value));
const rises = (all, turn) => all.every((each, i) => i === 0 || (Number.isNaN(each) ? i >= 980
  : turn * (each - all[i - 1]) >= 0));
head.click();
const first = rises(points(), 1);
head.click();
const rising = head.closest('th').getAttribute('aria-sort');
return first && rises(points(), -1) && rising === 'descending';
E2
expect 'every link is that of its row' <<'E2'
return [...document.querySelectorAll('.class td.name a')].every(
  (link) => link.textContent.includes('end') || link.href.endsWith(
    '/' + encodeURIComponent(link.textContent) + '.html'));
E2

finish_page
