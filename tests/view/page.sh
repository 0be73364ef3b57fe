#!/usr/bin/env bash
# A person's session with the page of ./run view, which shows a submission with a mistake: the picture, a click, the table, the
# reference beside it, keys, a crash of the tasks, a phone; then a page that was exported, without a server.
# page.sh BUILD. Skipped (77) if Chromium is missing.
set -euo pipefail
# shellcheck source=tests/fixtures/browser.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/browser.sh"
programs=$1/view

cp -r reference "$folder/handed_in"
cp build/mistakes/trace_path/no_cosine/trace_path.cpp "$folder/handed_in/4_global"
"$1/measure/writeup_boxed" build "$folder/handed_in" "$folder/boxed.json" view_boxed.json trace_path
worker=$(sed 's/.*"worker":"\([^"]*\).*/\1/' "$folder/boxed.json")
# As ./run gives the words of --from student.
"$programs/view" --worker "$programs/view_worker.reference" --tasks student --build scripts/ninja.sh "$1" scenes/box_spheres.dae \
  -r 32 24 --pixel 3 4 --export "$folder/pixel.html" >/dev/null
go_to_server "$programs/view" --boxed "$folder/boxed.json" --reference "$programs/view_worker.reference" --mixture trace_path=no_cosine \
  scenes/box_spheres.dae -r 96 72 -s 8 --no-browser
# until WHAT: as expect, but the script on standard input may take a while to become true.
until_true() {
  local words
  words=$(cat)
  for _ in $(seq 300); do
    [ "$(script <<<"$words")" != '{"value":true}' ] || return 0
    sleep 0.1
  done
  expect "$1" <<<"$words"
}

until_true 'samples are added up' <<<"return Number(document.getElementById('stage').dataset.samples) >= 6;"
expect 'the picture is not black' <<'E2'
const canvas = document.getElementById('picture');
const { data } = canvas.getContext('2d').getImageData(0, 0, 96, 72);
return canvas.width === 96 && data.filter((value, i) => i % 4 < 3 && value > 20).length > 10000;
E2
expect 'a small picture shows the whole view of the camera of the course' <<'E2'
const { min, max } = now.scene;
return [0, 1, 2, 3, 4, 5, 6, 7].every((i) => project(now.camera, min.map((low, axis) => ((i >> axis) & 1 ? max[axis] : low))).every((at) => at > 0 && at < 1))
  && document.getElementById('command').textContent !== '';
E2
stage=$(element '#stage')
pointer "$stage" 0 100 click
until_true 'a click traces the paths of the pixel' <<'E2'
return document.querySelectorAll('#own tbody tr').length > 0
  && document.getElementById('pixel').textContent.startsWith('Paths of pixel x 4')
  && !document.getElementById('reference').hidden;
E2
expect 'the parts of each path add up, also those of a mistake' <<'E2'
return now.paths.paths.length === 8
  && now.paths.paths.every((path) => path.one && path.sum.every((c, i) => Math.abs(c - path.traced[i]) <= 1e-9 * c))
  && now.reference.paths.every((path) => path.same && path.findings.length === 0);
E2
script >/dev/null <<<"document.getElementById('red').click();"
expect 'the cell of the mistake is red, with the promise and the command' <<'E2'
return document.querySelectorAll('#own td.broken[data-cell="part"]').length > 0
  && document.querySelectorAll('#reference td.broken').length === 0
  && document.getElementById('findings').textContent.includes('weighs by the cosine')
  && document.getElementById('findings').textContent.includes('./run grade trace_path');
E2
expect 'the first number that differs from the reference is outlined in both tables' <<'E2'
return document.querySelectorAll('#own td.differs').length === 1
  && document.querySelectorAll('#reference td.differs').length === 1
  && document.querySelector('#own td.differs').dataset.cell === 'part';
E2
expect 'before trace_path is written, the table has no words of later parts' <<'E2'
const heads = () => [...document.querySelectorAll('#own thead th')].map((head) => head.textContent).join();
const { unwritten } = now.paths, before = heads();
now.paths.unwritten = ['trace_path'];
show_paths();
const early = heads(), early_rows = document.querySelectorAll('#reference tbody tr').length;
now.paths.unwritten = unwritten;
show_paths();
return early === ',point,n,wo' && early_rows === 1 && before.includes('throughput') && heads() === before;
E2
expect 'and the page begins with normals' <<'E2'
now.has_light = false;
begin_with_normals({ stage: 2, unwritten: ['trace_path'] });
const begun = controls.shown.value;
set('shown', 'light');
return begun === 'normals';
E2
until_true 'the disk of the point holds the lamp, and less light than trace_path returns' <<'E2'
const apart = [...document.querySelectorAll('#disk_balance td.differs')];
return !document.getElementById('disk').hidden && disk.paths === now.paths && disk.own.passes > 5
  && Math.max(...disk.own.floats.subarray(0, disk.own.side ** 2)) > 1
  && apart.length === 1 && apart[0].textContent.endsWith(' times') && apart[0].parentElement.firstChild.textContent === 'trace_path';
E2
pointer "$(element '#strip')" 4 0 click
until_true 'a click on a bar chooses the path of the sample' <<'E2'
return now.which === 4 && document.getElementById('which').value === '5' && document.getElementById('samples_say').textContent.startsWith('8 samples');
E2
script >/dev/null <<<"document.getElementById('red').click();"
points=$(element '#points')
post "$session/element/$points/value" '{"text": "\uE015"}' >/dev/null
expect 'an arrow key in the table chooses another point' <<'E2'
const current = [...document.querySelectorAll('#own tbody tr')].findIndex((row) => row.classList.contains('current'));
return now.point === current && current === Math.min(1, now.paths.paths[now.which].bounces.length - 1);
E2
expect 'all surfaces of the paths are there, and the points lie on them' <<'E2'
return now.paths.paths.every((path) => path.bounces.every((bounce) => {
  const [a, b, c] = now.paths.shapes[bounce.primitive];
  const off = c ? dot(unit(cross(plus(b, a, -1), plus(c, a, -1))), plus(bounce.p, a, -1)) : Math.hypot(...plus(bounce.p, a, -1)) - b;
  return Math.abs(off) < 1e-6;
}));
E2
until_true 'a point behind a surface is hidden, one on it or before it is not' <<'E2'
const camera = { ...now.camera, depth: depth_of(now.camera) };
const at = (p, part) => plus(camera.position, plus(p, camera.position, -1), part);
return camera.depth && now.paths.paths.every(({ bounces: [first] }) =>
  !is_hidden(camera, at(first.p, 0.9)) && !is_hidden(camera, first.p) && is_hidden(camera, at(first.p, 1.3)));
E2
expect 'hidden parts of lines are dashed, and edges are drawn in white' <<'E2'
const { prototype } = CanvasRenderingContext2D, { setLineDash, stroke } = prototype;
const drawn = new Set();
prototype.setLineDash = function (dash) { this.dash = dash.map((length) => length / devicePixelRatio).join(); setLineDash.call(this, dash); };
prototype.stroke = function () { drawn.add(`${this.dash} ${this.strokeStyle}`); stroke.call(this); };
show_lines();
const camera = { ...now.camera, depth: depth_of(now.camera) }, { p } = now.paths.paths[now.which].bounces[0];
const at = (part) => plus(camera.position, plus(p, camera.position, -1), part);
draw_line(document.getElementById('lines').getContext('2d'), camera, at(0.8), at(1.5), '#abcdef');
Object.assign(prototype, { setLineDash, stroke });
return [' #ffffff', ' #abcdef', '2,4 #abcdef'].every((each) => drawn.has(each)) || [...drawn].join('; ');
E2
expect 'the picture can be saved as .exr' <<'E2'
const saved = new Promise((resolve) => { HTMLAnchorElement.prototype.click = function () { resolve(this); }; });
document.getElementById('save_exr').click();
return saved.then((link) => { delete HTMLAnchorElement.prototype.click; return link.download === 'picture.exr'; });
E2
pointer "$stage" 20 -30
expect 'below the picture stands the value under the pointer' <<'E2'
const [x, y] = now.pointer;
return JSON.stringify(now.pointer) !== JSON.stringify(now.pixel)
  && document.getElementById('status').textContent.includes(`x ${x}, y ${y}: `);
E2
keys() { post "$session/element/$stage/value" "{\"text\": \"$1\"}" >/dev/null; }
expect 'keys choose another path' <<'E2'
const before = now.which;
document.getElementById('stage').dispatchEvent(new KeyboardEvent('keydown', { key: ']', bubbles: true }));
return now.which === (before + 1) % 8;
E2
keys '\uE014\uE014\uE007'
until_true 'arrow keys and Enter trace the paths of another pixel' <<'E2'
return now.paths.x === now.pixel[0] && document.getElementById('pixel').textContent.includes(`x ${now.pixel[0]},`);
E2
keys 'z'
pointer "$stage" 20 -30
expect 'Z enlarges around the marked pixel or the pointer, and the pointer still names the pixel below it' <<'E2'
const box = document.getElementById('picture').getBoundingClientRect(), seen = stage.getBoundingClientRect();
const [x, y] = now.pointer, middle = [seen.left + seen.width / 2 + 20, seen.top + seen.height / 2 - 30];
return zoomed.times === 2 && Math.abs(box.width / seen.width - 2) < 0.01 && box.left <= seen.left && box.right >= seen.right
  && x === Math.floor((96 * (middle[0] - box.left)) / box.width) && y === 71 - Math.floor((72 * (middle[1] - box.top)) / box.height);
E2
keys 'Z'
expect 'Shift and Z make it smaller again' <<<"return zoomed.times === 1 && zoomed.x === 0 && zoomed.y === 0;"
keys 'd'
until_true 'D turns the camera; the square of the pixel goes, its paths stay' <<'E2'
return now.view !== null && JSON.stringify(now.camera.position) !== JSON.stringify(now.scene.camera.position)
  && !is_pixel_here() && now.paths.x === now.pixel[0] && !('eye' in query_of_pixel());
E2
keys 'r'
until_true 'R brings the camera of the file back, and the square' <<'E2'
return now.view === null && is_pixel_here() && JSON.stringify(now.camera.position) === JSON.stringify(now.scene.camera.position);
E2
keys 'b'
until_true 'B shows the boxes tested, with a legend' <<'E2'
return !document.getElementById('legend').hidden && Number(document.getElementById('high').textContent) > 1;
E2
keys 'f'
until_true 'F shows the next of the colours' <<'E2'
return document.querySelector('[name=shown]').value === 'primitives' && now.pictures.own.samples > 0;
E2
keys 'lc'
until_true 'C puts the reference to the right of the slider' <<'E2'
const { own, reference } = now.pictures;
if (document.getElementById('beside').hidden || !reference || reference.stage < 2 || controls.shown.value !== 'light') return false;
document.getElementById('split').value = 25;
const both = chosen_picture().floats;
return both.every((value, i) => Object.is(value, (Math.floor(i / 3) % 96 < 24 ? own : reference).floats[i]))
  && both.some((value, i) => value !== own.floats[i]);
E2
# The mistake is in the bounces: the direct light is by equal code.
script >/dev/null <<'E2'
const { prototype } = CanvasRenderingContext2D, { putImageData } = prototype, { own } = now.pictures;
window.differences = new Map();
prototype.putImageData = function (image, ...at) {
  putImageData.call(this, image, ...at);
  if (image.width !== 96 || controls.from.value !== 'difference' || now.pictures.own === own) return;
  const count = image.data.filter((value) => value !== 247 && value !== 255).length, { samples } = now.pictures.own;
  window.differences.set(samples, Math.max(count, window.differences.get(samples) ?? 0));
};
controls.from.value = 'difference';
set('show', 'direct');
E2
until_true 'the difference of equal code is zero at every moment' <<'E2'
return window.differences.size > 3 && [...window.differences.values()].every((count) => count === 0);
E2
script >/dev/null <<<"window.differences.clear(); set('show', 'full');"
until_true 'and not zero where a mistake makes one' <<<"return [...window.differences.values()].some((count) => count > 1000);"
script >/dev/null <<<"set('from', 'both');"
keys 'c'
until_true 'C again hides it' <<<"return document.getElementById('beside').hidden;"
keys 'm'
until_true 'M hides the other paths' <<<"return !document.getElementById('all_paths').checked;"
script >/dev/null <<'E2'
controls.is_adaptive.checked = true;
controls.is_adaptive.dispatchEvent(new Event('change', { bubbles: true }));
E2
until_true 'with adaptive sampling, the samples are those of adaptive_pixel' <<'E2'
return now.paths.samples % 32 === 0 && now.paths.values.length === now.paths.samples && now.paths.paths.length === Math.min(64, now.paths.samples)
  && document.getElementById('samples_say').textContent.startsWith(`adaptive_pixel stopped after ${now.paths.samples} of`);
E2
script >/dev/null <<'E2'
controls.is_adaptive.checked = false;
controls.is_adaptive.dispatchEvent(new Event('change', { bubbles: true }));
E2
until_true 'and without it those that were asked for' <<<"return now.paths.values.length === 8;"
keys 't'
until_true 'T shows the tree, and the boxes that hit_bvh tests for the ray of the pixel' <<'E2'
return Boolean(now.tree) && !document.getElementById('ray').hidden && now.ray.tests.length > 4
  && Number(document.getElementById('test').max) === now.ray.tests.length;
E2
keys 'nnp'
until_true 'N and P step through them' <<'E2'
const tests = now.ray.tests;
return document.getElementById('test').value === '1' && document.getElementById('test_says').textContent.startsWith(`1 of ${now.ray.boxes}: level ${tests[0].level}`)
  && tests.every((test) => !test.opened || test.t) && tests.some((test) => test.primitives && test.primitives.some(([, t]) => t === now.ray.t));
E2
keys 't'
until_true 'T hides the tree again' <<<"return !now.tree && document.getElementById('ray').hidden;"
expect 'the row that was pressed has its frame' <<'E2'
document.querySelector('#own tbody tr').click();
const [point] = now.paths.paths[now.which].bounces;
return now.has_frame && Math.abs(dot(point.x, point.y)) < 1e-9 && Math.abs(dot(cross(point.x, point.y), point.n) - 1) < 1e-9;
E2
boxed=$(pgrep -n -f "^$worker ")
if ! grep -q '"tier":"C"' "$folder/boxed.json" && ! grep -q '^Seccomp:.*2$' "/proc/$boxed/status"; then
  complain 'the tasks of a submission run outside a box'
fi
kill -SEGV "$boxed"  # while it improves the picture
until_true 'a crash of the tasks is a sentence' <<'E2'
const banner = document.getElementById('banner');
return !banner.hidden && banner.textContent.includes('the tasks crashed: signal 11');
E2
keys 'l\uE007'
until_true 'and the page goes on with them' <<'E2'
return document.getElementById('banner').hidden && now.paths.paths.length === 8;
E2
post "$session/window/rect" '{"width": 500, "height": 844}' >/dev/null
expect 'on a phone only the tables are wider than the page' <<'E2'
return document.documentElement.scrollWidth <= innerWidth;
E2

# A save makes another program of the tasks; one of them never answers.
go about:blank
kill "$server"
mkdir "$folder/build" "$folder/tasks"
worker=$folder/build/view_worker.reference
cp "$programs/view_worker.reference" "$folder/right"
cp "$folder/right" "$worker"
printf '#!/bin/sh\nexec sleep 1000\n' >"$folder/endless"
chmod +x "$folder/endless"
cat >"$folder/build/build.ninja" <<'E2'
rule compile
  command = cp "../$$(cat $in)" $out.new && mv $out.new $out
build view_worker.reference: compile ../tasks/task.cpp
E2
printf 'exec ninja -C "$@"\n' >"$folder/ninja"
echo right >"$folder/tasks/task.cpp"
go_to_server "$programs/view" --worker "$worker" --tasks "$folder/tasks" --build "$folder/ninja" "$folder/build" \
  scenes/box_spheres.dae -r 96 72 -s 8 --pixel 48 20 --no-browser
until_true 'the page of one that is watched' <<<"return now.paths !== null && now.pictures.own && now.pictures.own.samples > 0;"
echo endless >"$folder/tasks/task.cpp"
until_true 'an endless loop is told' <<'E2'
const banner = document.getElementById('banner');
if (!banner.hidden) window.moments = [...(window.moments ?? []), banner.textContent.includes('no answer for 5 s, as in an endless loop')];
return window.moments !== undefined;
E2
until_true 'and it stays' <<'E2'
const banner = document.getElementById('banner');
window.moments.push(!banner.hidden && banner.textContent.includes('no answer for 5 s, as in an endless loop'));
return window.moments.length > 10;
E2
expect 'at every moment' <<<"return window.moments.every((moment) => moment);"
echo right >"$folder/tasks/task.cpp"
until_true 'the next save is shown at once' <<'E2'
return document.getElementById('banner').hidden && now.latest.own && now.latest.own.samples > 0;
E2

go about:blank
kill "$server"
wait "$server" || true
go_to_server "$programs/view" --worker "$programs/view_worker.student" --reference "$programs/view_worker.reference" scenes/box_spheres.dae -r 96 72 --no-browser
pointer "$(element '#stage')" 0 40 click
until_true 'a stub breaks no promise' <<'E2'
return now.paths !== null && now.paths.unwritten.includes('estimate_pixel') && document.querySelectorAll('#findings li, td.broken').length === 0
  && document.getElementById('disk').hidden && document.getElementById('samples').hidden;
E2

"$programs/view" --worker "$programs/view_worker.reference" scenes/box_spheres.dae -r 96 72 -s 4 --pixel 48 20 \
  --export "$folder/export.html" >/dev/null
go "file://$folder/export.html"
until_true 'an exported page shows its picture and its paths without a server' <<'E2'
return document.getElementById('stage').dataset.ready === 'yes' && document.getElementById('picture').width === 96
  && document.querySelectorAll('#own tbody tr').length > 0 && document.getElementById('sum').className === 'same'
  && !document.getElementById('ray').hidden && !document.getElementById('samples').hidden && !document.getElementById('disk').hidden
  && document.getElementById('disk_own_picture').width > 100 && disk.own.direct.disk[2] > 1 && depth_of(now.camera).floats.length === 96 * 72;
E2
# The refused answer of the crash is in the console; nothing else is.
script >/dev/null <<<''
post "$session/se/log" '{"type": "browser"}' | grep -o '"message":"[^"]*"' | grep -v '503' >"$folder/console" &&
  complain "the console says $(cat "$folder/console")"
finish
