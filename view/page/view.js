
// The page: asks for pictures and paths, or shows those that it holds.

const data = JSON.parse(document.getElementById("data").textContent);
const by_id = (id) => document.getElementById(id);
const controls = by_id("controls").elements;
const stage = by_id("stage");
const kDefaults = { show: "full", light_samples: "1", hemisphere: "", survival: "0.7", engine: "task", camera: "course",
  shown: "light" };

const now = {
  scene: data.scene,
  camera: null,  // of the picture that is shown
  depth: null,   // the distances of surfaces from a camera
  view: null,    // an eye that was moved; null: the camera of the file
  pixel: data.pixel ?? null,
  pixel_from: {}, // words of the camera through which it was chosen
  paths: data.paths ?? null,
  reference: data.reference_paths ?? null,
  ray: data.ray ?? null,
  which: -1,  // not chosen yet; counts from the first path that is known
  first: 0,   // that is wanted
  point: 0,
  pictures: {},  // that are shown, by whom
  latest: {},    // the last answers
  kind: "light", // of the pictures that are shown
  pointer: null, // the pixel below it
  asking: 0,     // grows when an older answer is no longer wanted
};

// --- the picture ---

const with_floats = (numbers) => ({ ...numbers,
  floats: new Float32Array(Uint8Array.from(atob(numbers.base64), (c) => c.charCodeAt(0)).buffer) });

// The picture by these tasks, the reference, or both; the part of both to the left is by these tasks.
function chosen_picture() {
  const { own, reference } = now.pictures;
  const from = controls.from.value;
  if (from === "reference") return reference;
  return from === "both" && reference && reference.stage > 1 ? joined(own, reference, by_id("split").value / 100) : own;
}

function show_legend(color, low, high) {
  paint_ramp(by_id("ramp"), color);
  [by_id("low").textContent, by_id("high").textContent] = [low, high];
}

function show_picture() {
  const { own, reference } = now.pictures;
  const from = controls.from.value;
  const picture = chosen_picture();
  by_id("beside").hidden = from !== "both";
  if (!picture) return;
  const canvas = by_id("picture");
  now.camera = picture.camera;
  const { kind } = now;
  by_id("legend").hidden = from !== "difference" && (kind === "light" || kind === "primitive");
  if (from === "difference" && reference) {
    paint_difference(canvas, own, reference);
    show_legend((t) => signed_color(2 * t - 1), "\u2212100 %", "+100 %");
  } else if (kind === "primitive" && picture.stage > 1) {
    paint_primitives(canvas, picture);
  } else if (kind !== "light") {
    show_legend(ramp, ...paint_numbers(canvas, picture).map(shown));
  } else {
    paint_light(canvas, picture, controls.shown.value === "normals" ? 1 : 2 ** controls.exposure.value);
  }
  fit_stage();
  show_lines();
}

// Pixels with samples that were not finite: a button goes there.
function show_bad(state) {
  by_id("bad").replaceChildren(...state.bad.map(([x, y]) => {
    const button = element("button", `${x}, ${y}`);
    button.type = "button";
    button.addEventListener("click", () => {
      choose_pixel([x, y]);
      walk();
    });
    return button;
  }));
}

function status_of(state) {
  const rays = state.rays / Math.max(state.seconds, 1e-9);
  const words = [`${state.samples} samples per pixel`, `${shown(rays / 1e6)} M rays per second`, `${state.seconds.toFixed(1)} s`];
  if (state.unwritten.length) words.push(`not written yet: ${state.unwritten.join(", ")}`);
  if (state.not_finite) words.push(`${state.not_finite} samples were not finite`);
  if (state.note) words.push(state.note);
  return words.join(" \u00b7 ");
}

function value_under_pointer() {
  const picture = chosen_picture();
  const pixel = now.pointer ?? (is_pixel_here() ? now.pixel : null);
  if (!pixel || !picture) return "";
  const [x, y] = pixel;
  const i = 3 * ((picture.height - 1 - y) * picture.width + x);
  const value = ({ floats }) => Array.from(floats.subarray(i, now.kind === "light" ? i + 3 : i + 1), shown).join(", ");
  const { own, reference } = now.pictures;
  const values = controls.from.value === "difference" && reference ? `${value(own)}, the reference ${value(reference)}` : value(picture);
  return `x ${x}, y ${y}: ${values}`;
}

function show_status() {
  const { own } = now.latest;
  if (!own) return;
  by_id("status").textContent = `${status_of(own)}\n${value_under_pointer()}`;
  by_id("engine").textContent = own.engine === controls.engine.value ? "" : `in use: ${own.engine}`;
}

// Before trace_path is written there is no light to see: the page begins with normals.
function begin_with_normals({ stage: of, unwritten }) {
  if (now.has_light || of < 2) return;
  now.has_light = true;
  if (!has_paths(unwritten) && controls.shown.value === "light" && !data.settings.show) set("shown", "normals");
}

// --- lines over it ---

function show_lines() {
  const canvas = by_id("lines");
  canvas.width = Math.round(canvas.clientWidth * devicePixelRatio);
  canvas.height = Math.round((canvas.width * by_id("picture").height) / by_id("picture").width);
  const context = canvas.getContext("2d");
  const { times } = zoomed;
  context.setTransform(times, 0, 0, times, -times * zoomed.x * canvas.width, -times * zoomed.y * canvas.height);
  const picture = chosen_picture();
  if (picture) draw_numbers(context, picture);
  const path = now.paths && now.paths.paths[now.which];
  const camera = now.camera && { ...now.camera, depth: depth_of(now.camera) };
  const tests = by_id("ray").hidden ? 0 : Number(by_id("test").value);
  if (tests > 0 && camera) draw_tests(context, camera, now.ray, tests);
  else if (now.tree && camera) draw_boxes(context, camera, now.tree.nodes, Number(by_id("level").value));
  if (path && camera && now.scene) {
    const size = Math.hypot(...plus(now.scene.max, now.scene.min, -1));
    draw_all_paths(context, camera, now.paths, now.which);
    draw_path(context, camera, path, now.paths.shapes, size);
    if (now.has_frame && path.bounces[now.point]) draw_frame(context, camera, path.bounces[now.point], 0.05 * size);
  }
  if (controls.from.value === "both" && now.pictures.reference) {
    const x = by_id("split").value / 100;
    for (const [style, size] of [["#000", 3], ["#fff", 1]]) draw_ends(context, [[x, 0], [x, 1]], style, size, []);
  }
  if (!is_pixel_here()) return;
  const [x, y] = now.pixel;
  const [w, h] = [canvas.width / data.settings.w, canvas.height / data.settings.h];
  for (const [style, size] of [["#000", 3], ["#fff", 1]]) {
    context.strokeStyle = style;
    context.lineWidth = size * pen();
    context.setLineDash([]);
    const margin = 2 * pen();
    context.strokeRect(x * w - margin, (data.settings.h - 1 - y) * h - margin, w + 2 * margin, h + 2 * margin);
  }
}

// --- the paths of a pixel ---

function choose_pixel(pixel) {
  now.pixel = pixel;
  now.pixel_from = words_of_eye();
  now.which = -1;
}

// Returns whether the pixel is one of the picture that is shown: its camera may have been turned since.
const is_pixel_here = () => now.pixel !== null && is_same(now.pixel_from, words_of_eye());

function choose_path(which) {
  if (now.paths) choose_sample(now.paths.first + which);
}

function show_reference(path) {
  const whole = now.reference && now.reference.paths[now.which];
  const points_of = (each) => (has_paths(now.paths.unwritten) ? each : first_point_of(each));
  const beside = whole && points_of(whole);
  by_id("reference").hidden = by_id("reference_title").hidden = by_id("difference").hidden = !beside;
  if (!beside) return null;
  const difference = first_difference(points_of(path), beside);
  fill_table(by_id("reference"), columns_of(now.paths.unwritten), beside, data.settings, now.point, difference, choose_point);
  by_id("difference").textContent = difference
    ? `The first number that differs is outlined: point ${difference.bounce}, ${difference.cell}.`
    : "No number differs.";
  return difference;
}

function choose_point(i) {
  now.point = i;
  now.has_frame = true;
  show_paths();
}

function next_point(step) {
  const last = now.paths.paths[now.which].bounces.length - 1;
  choose_point(Math.max(Math.min(now.point + step, last), 0));
}

// A task that calls none.
function show_no_paths() {
  if (!now.paths) return;
  by_id("findings").replaceChildren(...now.paths.findings.map(finding_line));
  by_id("hint").hidden = false;
  by_id("pixel").textContent = `Pixel x ${now.paths.x}, y ${now.paths.y}: no path was traced`;
  by_id("hint").textContent = now.paths.unwritten.length ? `Not written yet: ${now.paths.unwritten.join(", ")}.` : "";
}

function show_paths() {
  const { paths } = now;
  const path = paths && paths.paths[now.which];
  by_id("walked").hidden = !path;
  show_lines();
  improve_disk();
  if (!path) return show_no_paths();
  by_id("hint").hidden = true;
  by_id("pixel").textContent = `Paths of pixel x ${paths.x}, y ${paths.y}: mean ${paths.mean.map(shown).join(", ")}`;
  by_id("which").value = paths.first + now.which + 1;
  by_id("which").max = paths.values.length;
  by_id("of").textContent = `of ${paths.values.length}`;
  show_samples();
  by_id("red").hidden = !paths.paths.some((each) => each.findings.length);
  const [sentence, kind] = sentence_of_sum(path, paths.unwritten);
  const emitted = path.emission.some((c) => c > 0) ? ` The surface also emits ${path.emission.map(shown).join(", ")} towards the camera.` : "";
  by_id("sum").textContent = sentence + emitted;
  by_id("sum").className = kind;
  by_id("findings").replaceChildren(...[...paths.findings, ...path.findings].map(finding_line));
  const difference = show_reference(path);
  by_id("own_title").textContent = data.from === "reference" ? "" : `By ${data.from}`;
  fill_table(by_id("own"), columns_of(paths.unwritten), path, data.settings, now.point, difference, choose_point);
  fill_draws(by_id("lights"), path.bounces[now.point]);
}

// The path to begin with, and its point.
function show_first_red() {
  const { paths } = now.paths;
  now.which = Math.max(paths.findIndex((path) => path.findings.length), 0);
  const found = paths.length ? paths[now.which].findings[0] : null;
  now.point = found ? Math.max(found.bounce - 1, 0) : 0;
}

function next_red() {
  const { paths } = now.paths;
  for (let i = 1; i <= paths.length; ++i) {
    const which = (now.which + i) % paths.length;
    if (paths[which].findings.length) return choose_path(which);
  }
}

function save(blob, name) {
  const link = element("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}

// A page without a server: its picture is a file in it.
function show_export() {
  by_id("controls").hidden = true;
  by_id("controls").style.display = "none";
  by_id("count").disabled = true;
  by_id("status").textContent = "This page was written by ./run view --export; it holds one picture and the paths of one pixel.";
  by_id("command").textContent = command();
  if (data.numbers) {
    now.pictures.own = with_floats(data.numbers);
    now.kind = data.settings.shown;
    show_picture();
    stage.dataset.ready = "yes";
  }
  const image = new Image();
  image.addEventListener("load", () => {
    const canvas = by_id("picture");
    [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
    canvas.getContext("2d").drawImage(image, 0, 0);
    fit_stage();
    now.camera = now.scene.camera;
    now.depth = { camera: now.camera, ...with_floats(data.depth) };
    show_lines();
    stage.dataset.ready = "yes";
  });
  if (data.picture) image.src = data.picture;
  show_first_red();
  show_paths();
  find_ray();
}

// What the controls beside their values say.
function show_settings() {
  const { show, bounces, exposure } = controls;
  controls.shown.querySelector("[value=samples]").hidden = !controls.is_adaptive.checked;
  const k = bounces.value;
  bounces.disabled = show.value === "direct";
  by_id("bounced").textContent = { full: `up to ${k}`, direct: "1", indirect: `2 to ${k}`, bounce: `only ${k}` }[show.value];
  for (const group of by_id("controls").querySelectorAll("details")) {
    const is_adaptive = controls.is_adaptive.checked && group.contains(controls.is_adaptive);
    const is_changed = is_adaptive || Object.entries(kDefaults).some(([name, usual]) => controls[name].value !== usual && group.contains(controls[name]));
    group.firstElementChild.classList.toggle("changed", is_changed);
    group.firstElementChild.title = is_changed ? "It has settings that are not the usual ones." : "";
  }
  by_id("stops").textContent = `\u00d7 ${Number((2 ** exposure.value).toPrecision(3))}`;
}

function change_settings() {
  if (controls.show.value === "indirect") controls.bounces.value = Math.max(controls.bounces.value, 2);
  data.settings.bounces = controls.bounces.value;
  show_settings();
  improve();
}

function change_exposure(step) {
  controls.exposure.value = Number(controls.exposure.value) + step;
  show_settings();
  show_picture();
  show_disk();
}

const kMinBounces = 10;  // at the end of the slider

// The settings that the page begins with.
function begin_controls() {
  const { settings } = data;
  controls.bounces.max = Math.max(settings.bounces, kMinBounces);
  controls.bounces.value = settings.bounce ?? settings.bounces;
  for (const name of Object.keys(kDefaults)) {
    const control = settings[name] === "normals" ? controls.shown : controls[name];
    control.value = settings[name] ?? control.value;
  }
  begin_adaptive();
  show_settings();
}

function begin() {
  by_id("title").textContent = `${data.scene_file}, by ${data.from}`;
  document.title = `${data.scene_file}, by ${data.from}`;
  begin_controls();
  by_id("count").value = data.settings.samples;
  document.querySelector(".beside").hidden = !data.reference;
  now.pixel_from = words_of_eye();
  begin_samples();
  begin_disk();
  document.addEventListener("keydown", on_key);
  window.addEventListener("resize", () => {
    fit_stage();
    show_lines();
  });
  by_id("previous").addEventListener("click", () => choose_path(now.which - 1));
  by_id("next").addEventListener("click", () => choose_path(now.which + 1));
  by_id("red").addEventListener("click", next_red);
  by_id("which").addEventListener("change", () => choose_sample(Number(by_id("which").value) - 1));
  by_id("test").addEventListener("input", () => show_test(0));
  if (!data.live) return show_export();
  listen_to_pointer();
  by_id("count").addEventListener("change", () => {
    now.which = -1;
    walk();
  });
  by_id("controls").addEventListener("change", ({ target }) => {
    if (target.name === "zoom") return zoom_to(Number(target.value), place_to_zoom());
    show_settings();
    if (target.name === "camera") return go_home();
    if (target.name !== "exposure") change_settings();
    if (!["exposure", "shown", "from"].includes(target.name)) walk();
  });
  by_id("controls").addEventListener("input", ({ target }) => {
    if (target.name === "exposure") change_exposure(0);
    if (target.name === "bounces") change_settings();
  });
  by_id("controls").addEventListener("submit", (event) => event.preventDefault());
  by_id("home").addEventListener("click", go_home);
  by_id("show_tree").addEventListener("click", show_tree);
  by_id("level").addEventListener("input", () => show_level(0));
  by_id("save").addEventListener("click", () => by_id("picture").toBlob((blob) => save(blob, "picture.png")));
  by_id("save_exr").addEventListener("click", save_exr);
  by_id("split").addEventListener("input", show_picture);
  load_scene().then(improve, () => {});
  walk();
  if (data.watched) watch_saves();
}

begin();
