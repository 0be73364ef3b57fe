
// Keys and pointer.

function move_eye(change) {
  if (!data.live || !now.scene) return;
  now.view = change(now.view ?? eye_of(now.scene));
  improve();
}

function set(name, value) {
  controls[name].value = value;
  if (name === "show" && controls.shown.value === "normals") controls.shown.value = "light";
  change_settings();
}

// The next of the false colours that can be chosen.
function next_colours(step) {
  const words = Array.from(controls.shown.options).filter((option) => !option.hidden).map((option) => option.value);
  set("shown", words[(words.indexOf(controls.shown.value) + step + words.length) % words.length]);
}

const kMoves = { a: [-1, 0], d: [1, 0], w: [0, 1], s: [0, -1] };
const kArrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const kShows = { 1: "full", 2: "direct", 3: "indirect", 4: "bounce" };
const kColours = { 5: "normals", l: "light", b: "boxes", v: "deviation" };

function move_pixel([right, up], length) {
  const [w, h] = [Number(data.settings.w), Number(data.settings.h)];
  const [x, y] = now.pixel ?? [w >> 1, h >> 1];
  const { which } = now;
  choose_pixel([Math.min(Math.max(x + length * right, 0), w - 1), Math.min(Math.max(y + length * up, 0), h - 1)]);
  now.which = which;  // of the paths that are shown until Enter
  keep_in_sight(now.pixel);
  show_lines();
  show_status();
}

function on_key(event) {
  if (event.target.matches("input:not([type=checkbox]), select") || event.ctrlKey || event.metaKey || event.altKey) return;
  const key = event.key.toLowerCase();
  if (kMoves[key]) {
    const [right, up] = kMoves[key];
    move_eye((view) => (event.shiftKey ? moved(view, 0.05 * right, 0.05 * up) : orbit(view, -0.1 * right, -0.1 * up)));
  } else if (key === "+" || key === "-") move_eye((view) => closer(view, key === "+" ? 0.9 : 1 / 0.9));
  else if (key === "r") go_home();
  else if (key === "z") zoom_by(event.shiftKey ? -1 : 1);
  else if (key === "e" && data.live) change_exposure(event.shiftKey ? -0.5 : 0.5);
  else if (key === "t" && data.live) show_tree();
  else if (key === "m") by_id("all_paths").click();
  else if (key === "," || key === ".") show_level(key === "," ? -1 : 1);
  else if (key === "n" || key === "p") show_test(key === "n" ? 1 : -1);
  else if (key === "[" || key === "]") choose_path(now.which + (key === "[" ? -1 : 1));
  else if (data.live && kShows[key]) set("show", kShows[key]);
  else if (data.live && kColours[key]) set("shown", kColours[key]);
  else if (key === "f" && data.live) next_colours(event.shiftKey ? -1 : 1);
  else if (key === "c" && data.live && data.reference) set("from", controls.from.value === "both" ? "" : "both");
  else if (event.target === by_id("points") && kArrows[event.key]?.[1]) next_point(-kArrows[event.key][1]);
  else if (event.target === stage && kArrows[event.key] && data.live) move_pixel(kArrows[event.key], event.shiftKey ? 8 : 1);
  else if (event.target === stage && event.key === "Enter") {
    now.which = -1;
    walk();
  }
  else return;
  event.preventDefault();
}

function go_home() {
  now.view = null;
  if (data.live) load_scene().then(improve, () => {});
}

function pixel_at(event) {
  const box = stage.getBoundingClientRect();
  const pixel = (part, corner, pixels) => Math.min(Math.max(Math.floor((corner + part / zoomed.times) * pixels), 0), pixels - 1);
  return [pixel((event.clientX - box.left) / box.width, zoomed.x, data.settings.w),
    data.settings.h - 1 - pixel((event.clientY - box.top) / box.height, zoomed.y, data.settings.h)];
}

function listen_to_pointer() {
  let from = null, is_drag = false;
  stage.addEventListener("pointerdown", (event) => {
    from = [event.clientX, event.clientY];
    is_drag = false;
    stage.setPointerCapture(event.pointerId);
  });
  stage.addEventListener("pointerleave", () => {
    now.pointer = null;
    show_status();
  });
  stage.addEventListener("pointermove", (event) => {
    now.pointer = pixel_at(event);
    show_status();
    if (!from) return;
    const [right, down] = [event.clientX - from[0], event.clientY - from[1]];
    if (!is_drag && Math.hypot(right, down) < 4) return;
    is_drag = true;
    from = [event.clientX, event.clientY];
    const size = stage.clientWidth;
    if (zoomed.times > 1) return pan(-right / size, -down / stage.clientHeight);
    move_eye((view) => (event.shiftKey ? moved(view, -right / size, down / size)
      : orbit(view, (4 * right) / size, (-4 * down) / size)));
  });
  stage.addEventListener("pointerup", (event) => {
    if (from && !is_drag && data.live) {
      choose_pixel(pixel_at(event));
      walk();
    }
    from = null;
  });
  stage.addEventListener("wheel", (event) => {
    if (!data.live) return;
    event.preventDefault();
    if (zoomed.times > 1 || event.ctrlKey) zoom_by(event.deltaY < 0 ? 1 : -1);
    else move_eye((view) => closer(view, event.deltaY < 0 ? 0.9 : 1 / 0.9));
  }, { passive: false });
}
