
// The page: asks for pictures and paths, or shows those that it holds.

const data = JSON.parse(document.getElementById("data").textContent);
const by_id = (id) => document.getElementById(id);
const controls = by_id("controls").elements;
const stage = by_id("stage");
const kDefaults = { show: "full", bounce: "1", light_samples: "1", hemisphere: "", survival: "0.7", engine: "task",
  camera: "course", shown: "light" };

const now = {
  scene: data.scene,
  camera: null,  // of the picture that is shown
  view: null,    // an eye that was moved; null: the camera of the file
  pixel: data.pixel ?? null,
  paths: data.paths ?? null,
  reference: data.reference_paths ?? null,
  ray: data.ray ?? null,
  which: -1,  // not chosen yet
  point: 0,
  pictures: {},  // by whom
  asking: 0,     // grows when an older answer is no longer wanted
};

function complain(sentence) {
  by_id("banner").textContent = sentence;
  by_id("banner").hidden = !sentence;
}

async function ask(what, query) {
  const words = new URLSearchParams({ ...query, token: data.token });
  const answer = await fetch(`/${what}?${words}`);
  if (!answer.ok) throw new Error((await answer.text()).trim());
  if (answer.headers.get("Content-Type").startsWith("application/json")) return answer.json();
  const state = JSON.parse(answer.headers.get("X-State"));
  return { ...state, floats: new Float32Array(await answer.arrayBuffer()) };
}

// The settings that differ from the usual ones, as words of a request.
function query() {
  const words = { w: data.settings.w, h: data.settings.h, bounces: controls.bounces.value };
  for (const name of ["seed", "adaptive"]) if (data.settings[name]) words[name] = data.settings[name];
  for (const [name, usual] of Object.entries(kDefaults)) {
    if (name === "bounce" && controls.show.value !== "bounce") continue;
    if (controls[name].value !== usual) words[name] = controls[name].value;
  }
  if (now.view) for (const name of ["eye", "target", "up"]) words[name] = now.view[name].join(",");
  return words;
}

function command() {
  const words = { ...query() };
  const options = [`./run render ${data.scene_file} -f picture.png -r ${words.w} ${words.h} -m ${words.bounces}`];
  if (words.light_samples) options.push(`-l ${words.light_samples}`);
  if (words.hemisphere) options.push("-H");
  for (const name of ["show", "bounce", "survival", "engine", "camera", "seed"]) if (words[name]) options.push(`--${name} ${words[name]}`);
  const [most, ...adaptive] = words.adaptive ? words.adaptive.split(",") : ["64"];
  if (words.adaptive) options.push(`-a ${adaptive.join(" ")}`);
  for (const each of data.from.split("+")) if (each !== "reference") options.push(`--from ${each}`);
  if (data.boxed) return "none, because these are the tasks of a submission";
  return now.view ? "none, because the camera was moved" : `${options.join(" ")} -s ${most}`;
}

// --- the picture ---

function show_picture() {
  const { own, reference } = now.pictures;
  const from = controls.from.value;
  const picture = from === "reference" ? reference : own;
  if (!picture) return;
  const canvas = by_id("picture");
  now.camera = picture.camera;
  stage.style.setProperty("--shape", picture.width / picture.height);
  const kind = controls.shown.value;
  by_id("legend").hidden = kind === "light" || kind === "primitive";
  if (from === "difference" && reference && reference.floats.length === own.floats.length) {
    paint_difference(canvas, own, reference);
  } else if (kind === "primitive" && picture.stage > 1) {
    paint_primitives(canvas, picture);
  } else if (kind !== "light") {
    const [low, high] = paint_numbers(canvas, picture);
    [by_id("low").textContent, by_id("high").textContent] = [shown(low), shown(high)];
  } else {
    paint_light(canvas, picture, controls.show.value === "normals" ? 1 : Number(controls.exposure.value));
  }
  show_lines();
}

// Pixels with samples that were not finite: a button goes there.
function show_bad(state) {
  by_id("bad").replaceChildren(...state.bad.map(([x, y]) => {
    const button = element("button", `${x}, ${y}`);
    button.type = "button";
    button.addEventListener("click", () => {
      now.pixel = [x, y];
      now.which = -1;
      walk();
    });
    return button;
  }));
}

function status_of(state) {
  const rays = state.rays / Math.max(state.seconds, 1e-9);
  const words = [`${state.samples} samples per pixel`, `${shown(rays / 1e6)} M rays per second`, `${state.seconds.toFixed(1)} s`,
    `engine ${state.engine}`];
  if (state.unwritten.length) words.push(`not written yet: ${state.unwritten.join(", ")}`);
  if (state.not_finite) words.push(`${state.not_finite} samples were not finite`);
  if (state.note) words.push(state.note);
  return words.join(" \u00b7 ");
}

function value_under_pointer() {
  const picture = now.pictures[controls.from.value === "reference" ? "reference" : "own"];
  if (!now.pixel || !picture) return "";
  const [x, y] = now.pixel;
  const i = 3 * ((picture.height - 1 - y) * picture.width + x);
  const value = picture.floats.subarray(i, controls.shown.value === "light" ? i + 3 : i + 1);
  return ` \u00b7 x ${x}, y ${y}: ${Array.from(value, shown).join(", ")}`;
}

// Asks for better pictures until there are none, or other ones are wanted.
async function improve() {
  if (!data.live) return;
  const turn = ++now.asking;
  by_id("command").textContent = command();
  let goes_on = true;
  while (goes_on && turn === now.asking) {
    try {
      const words = query();
      const own = await ask("picture", words);
      const wants_reference = controls.from.value !== "" && own.stage > 1;
      const reference = wants_reference ? await ask("picture", { ...words, from: "reference" }) : null;
      if (turn !== now.asking) return;
      now.pictures = { own, reference };
      complain("");
      show_picture();
      by_id("status").textContent = status_of(own) + value_under_pointer();
      show_bad(own);
      stage.dataset.samples = own.samples;
      goes_on = own.goes_on;
    } catch (error) {
      if (turn === now.asking) complain(`${error.message.replace(/[.]?$/, ".")} The page goes on with the next change.`);
      return;
    }
    await new Promise((resolve) => { setTimeout(resolve, document.hidden ? 1000 : 0); });
  }
}

// After a save, the tasks are compiled and the page goes on with them.
async function watch_saves() {
  let known = 0;
  for (;;) {
    await new Promise((resolve) => { setTimeout(resolve, 500); });
    const { saves, error } = await ask("saved", {}).catch(() => ({ saves: known, error: "" }));
    if (saves === known) continue;
    known = saves;
    complain(error);
    if (error) continue;
    if (now.tree) show_tree().then(show_tree);
    improve();
    walk();
  }
}

// --- lines over it ---

function show_lines() {
  const canvas = by_id("lines");
  const box = by_id("picture").getBoundingClientRect();
  canvas.width = Math.round(box.width * devicePixelRatio);
  canvas.height = Math.round(box.height * devicePixelRatio);
  const context = canvas.getContext("2d");
  const path = now.paths && now.paths.paths[now.which];
  const camera = now.camera;
  const tests = by_id("ray").hidden ? 0 : Number(by_id("test").value);
  if (tests > 0 && camera) draw_tests(context, camera, now.ray, tests);
  else if (now.tree && camera) draw_boxes(context, camera, now.tree.nodes, Number(by_id("level").value));
  if (path && camera && now.scene) {
    const size = Math.hypot(...plus(now.scene.max, now.scene.min, -1));
    draw_path(context, camera, path, size);
    if (now.has_frame && path.bounces[now.point]) draw_frame(context, camera, path.bounces[now.point], 0.05 * size);
  }
  if (!now.pixel) return;
  const [x, y] = now.pixel;
  const [w, h] = [canvas.width / data.settings.w, canvas.height / data.settings.h];
  for (const [style, size] of [["#000", 3], ["#fff", 1]]) {
    context.strokeStyle = style;
    context.lineWidth = size * devicePixelRatio;
    context.setLineDash([]);
    context.strokeRect(x * w - 2, (data.settings.h - 1 - y) * h - 2, w + 4, h + 4);
  }
}

async function show_tree() {
  if (now.tree) {
    now.tree = null;
  } else {
    try {
      now.tree = await ask("tree", query());
      now.other_tree = data.reference ? await ask("tree", { ...query(), from: "reference" }) : null;
    } catch (error) {
      complain(error.message);
    }
  }
  by_id("tree").hidden = !now.tree;
  if (now.tree) by_id("level").max = now.tree.depth;
  await find_ray();
  show_level(0);
}

// The ray through the middle of the pixel, while the tree is shown. A page without a server has it from the start.
async function find_ray() {
  if (data.live) now.ray = null;
  try {
    if (now.tree && now.pixel) now.ray = await ask("ray", { ...query(), x: now.pixel[0], y: now.pixel[1] });
  } catch (error) {
    complain(error.message);
  }
  by_id("ray").hidden = !now.ray || now.ray.tests.length === 0;
  by_id("test").max = now.ray ? now.ray.tests.length : 0;
  show_test(-Number(by_id("test").value));
}

function says_of(test) {
  const level = test.level === undefined ? "not a box of the tree" : `level ${test.level}`;
  if (!test.t) return `${level}, missed`;
  const between = `${level}, t ${shown(test.t[0])} to ${shown(test.t[1])}`;
  if (!test.opened) return `${between}, not opened`;
  const met = ([primitive, t]) => `${primitive} ${t === null ? "missed" : `at t ${shown(t)}`}`;
  return test.primitives ? `${between}, primitives ${test.primitives.map(met).join(", ")}` : `${between}, opened`;
}

function show_test(step) {
  if (now.ray) {
    const { tests, boxes, primitives } = now.ray;
    by_id("test").value = Number(by_id("test").value) + step;
    const count = Number(by_id("test").value);
    by_id("test_says").textContent = count > 0 ? `${count} of ${boxes}: ${says_of(tests[count - 1])}`
      : `${boxes} boxes and ${primitives} primitives for the ray through the middle of the pixel`;
  }
  show_lines();
}

function show_level(step) {
  if (now.tree) {
    by_id("level").value = Number(by_id("level").value) + step;
    const says = (tree) => `${tree.count} nodes, ${tree.depth + 1} levels, ${tree.leaves} leaves of at most ${tree.largest}; `
      + `by areas ${shown(tree.boxes)} boxes and ${shown(tree.primitives)} primitives per ray`;
    const beside = now.other_tree ? `. The reference: ${says(now.other_tree)}` : "";
    by_id("level_says").textContent = `${by_id("level").value}: ${says(now.tree)}${beside}`;
  }
  show_lines();
}

// --- the paths of a pixel ---

async function walk() {
  if (!data.live || !now.pixel) return;
  by_id("paths").setAttribute("aria-busy", "true");
  const words = { ...query(), x: now.pixel[0], y: now.pixel[1], samples: by_id("count").value };
  delete words.shown;
  try {
    now.paths = await ask("paths", words);
    now.reference = data.reference ? await ask("paths", { ...words, from: "reference" }) : null;
    if (now.which < 0) show_first_red();
    now.which = Math.min(now.which, now.paths.paths.length - 1);
    await find_ray();
    complain("");
  } catch (error) {
    complain(error.message);
  }
  by_id("paths").removeAttribute("aria-busy");
  show_paths();
}

function choose_path(which) {
  const count = now.paths ? now.paths.paths.length : 0;
  if (count === 0) return;
  now.which = (which + count) % count;
  now.point = 0;
  show_paths();
}

function show_reference(path) {
  const beside = now.reference && now.reference.paths[now.which];
  by_id("reference").hidden = by_id("reference_title").hidden = by_id("difference").hidden = !beside;
  if (!beside) return null;
  const difference = first_difference(path, beside);
  fill_table(by_id("reference"), beside, data.settings, now.point, difference, choose_point);
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

function show_paths() {
  const { paths, pixel } = now;
  const path = paths && paths.paths[now.which];
  by_id("walked").hidden = !path;
  show_lines();
  if (!path) return;
  by_id("hint").hidden = true;
  by_id("pixel").textContent = `Paths of pixel x ${pixel[0]}, y ${pixel[1]}: mean ${paths.mean.map(shown).join(", ")}`;
  by_id("which").value = now.which + 1;
  by_id("which").max = paths.paths.length;
  by_id("of").textContent = `of ${paths.paths.length}`;
  by_id("red").hidden = !paths.paths.some((each) => each.findings.length);
  const [sentence, kind] = sentence_of_sum(path);
  const emitted = path.emission.some((c) => c > 0) ? ` The surface also emits ${path.emission.map(shown).join(", ")} towards the camera.` : "";
  by_id("sum").textContent = path.bounces.length ? sentence + emitted : "The ray meets nothing.";
  by_id("sum").className = path.bounces.length ? kind : "note";
  by_id("findings").replaceChildren(...[...paths.findings, ...path.findings].map(finding_line));
  const difference = show_reference(path);
  by_id("own_title").textContent = data.from === "reference" ? "" : `By ${data.from}`;
  fill_table(by_id("own"), path, data.settings, now.point, difference, choose_point);
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

// --- keys and pointer ---

function move_eye(change) {
  if (!data.live || !now.scene) return;
  now.view = change(now.view ?? eye_of(now.scene));
  improve();
}

function set(name, value) {
  controls[name].value = value;
  improve();
}

const kMoves = { a: [-1, 0], d: [1, 0], w: [0, 1], s: [0, -1] };
const kArrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const kShows = { 1: "full", 2: "direct", 3: "indirect", 4: "bounce", 5: "normals" };
const kColours = { l: "light", b: "boxes", v: "deviation" };

function move_pixel([right, up], length) {
  const [w, h] = [Number(data.settings.w), Number(data.settings.h)];
  const [x, y] = now.pixel ?? [w >> 1, h >> 1];
  now.pixel = [Math.min(Math.max(x + length * right, 0), w - 1), Math.min(Math.max(y + length * up, 0), h - 1)];
  show_lines();
}

function on_key(event) {
  if (event.target.matches("input, select") || event.ctrlKey || event.metaKey || event.altKey) return;
  const key = event.key.toLowerCase();
  if (kMoves[key]) {
    const [right, up] = kMoves[key];
    move_eye((view) => (event.shiftKey ? moved(view, 0.05 * right, 0.05 * up) : orbit(view, -0.1 * right, -0.1 * up)));
  } else if (key === "+" || key === "-") move_eye((view) => closer(view, key === "+" ? 0.9 : 1 / 0.9));
  else if (key === "r") go_home();
  else if (key === "t" && data.live) show_tree();
  else if (key === "," || key === ".") show_level(key === "," ? -1 : 1);
  else if (key === "n" || key === "p") show_test(key === "n" ? 1 : -1);
  else if (key === "[" || key === "]") choose_path(now.which + (key === "[" ? -1 : 1));
  else if (data.live && kShows[key]) set("show", kShows[key]);
  else if (data.live && kColours[key]) set("shown", kColours[key]);
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
  if (data.live) load_scene().then(improve);
}

function pixel_at(event) {
  const box = stage.getBoundingClientRect();
  const part = (at, from, size, pixels) => Math.min(Math.max(Math.floor(((at - from) / size) * pixels), 0), pixels - 1);
  return [part(event.clientX, box.left, box.width, data.settings.w),
    data.settings.h - 1 - part(event.clientY, box.top, box.height, data.settings.h)];
}

function listen_to_pointer() {
  let from = null, is_drag = false;
  stage.addEventListener("pointerdown", (event) => {
    from = [event.clientX, event.clientY];
    is_drag = false;
    stage.setPointerCapture(event.pointerId);
  });
  stage.addEventListener("pointermove", (event) => {
    if (!from) return;
    const [right, down] = [event.clientX - from[0], event.clientY - from[1]];
    if (!is_drag && Math.hypot(right, down) < 4) return;
    is_drag = true;
    from = [event.clientX, event.clientY];
    const size = stage.clientWidth;
    move_eye((view) => (event.shiftKey ? moved(view, -right / size, down / size)
      : orbit(view, (4 * right) / size, (-4 * down) / size)));
  });
  stage.addEventListener("pointerup", (event) => {
    if (from && !is_drag && data.live) {
      now.pixel = pixel_at(event);
      now.which = -1;
      walk();
    }
    from = null;
  });
  stage.addEventListener("wheel", (event) => {
    if (!data.live) return;
    event.preventDefault();
    move_eye((view) => closer(view, event.deltaY < 0 ? 0.9 : 1 / 0.9));
  }, { passive: false });
}

async function load_scene() {
  const words = query();
  delete words.shown;
  now.scene = await ask("scene", words);
}

function save() {
  by_id("picture").toBlob((blob) => {
    const link = element("a");
    link.href = URL.createObjectURL(blob);
    link.download = "picture.png";
    link.click();
    URL.revokeObjectURL(link.href);
  });
}

// A page without a server: its picture is a file in it.
function show_export() {
  by_id("controls").hidden = true;
  by_id("controls").style.display = "none";
  by_id("count").disabled = true;
  by_id("status").textContent = "This page was written by ./run view --export; it holds one picture and the paths of one pixel.";
  by_id("command").textContent = command();
  if (data.numbers) {
    const bytes = Uint8Array.from(atob(data.numbers.base64), (c) => c.charCodeAt(0));
    now.pictures.own = { ...data.numbers, floats: new Float32Array(bytes.buffer) };
    show_picture();
    stage.dataset.ready = "yes";
  }
  const image = new Image();
  image.addEventListener("load", () => {
    const canvas = by_id("picture");
    [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
    stage.style.setProperty("--shape", canvas.width / canvas.height);
    canvas.getContext("2d").drawImage(image, 0, 0);
    now.camera = now.scene.camera;
    show_lines();
    stage.dataset.ready = "yes";
  });
  if (data.picture) image.src = data.picture;
  show_first_red();
  show_paths();
  find_ray();
}

function begin() {
  by_id("title").textContent = `${data.scene_file}, by ${data.from}`;
  document.title = `${data.scene_file}, by ${data.from}`;
  for (const name of ["bounces", ...Object.keys(kDefaults)]) {
    if (data.settings[name]) controls[name].value = data.settings[name];
  }
  controls.shown.querySelector("[value=samples]").hidden = !data.settings.adaptive;
  by_id("count").value = data.settings.samples;
  document.querySelector(".beside").hidden = !data.reference;
  paint_ramp(by_id("ramp"));
  document.addEventListener("keydown", on_key);
  window.addEventListener("resize", show_lines);
  by_id("previous").addEventListener("click", () => choose_path(now.which - 1));
  by_id("next").addEventListener("click", () => choose_path(now.which + 1));
  by_id("red").addEventListener("click", next_red);
  by_id("which").addEventListener("change", () => choose_path(Number(by_id("which").value) - 1));
  by_id("test").addEventListener("input", () => show_test(0));
  if (!data.live) return show_export();
  listen_to_pointer();
  by_id("count").addEventListener("change", walk);
  by_id("controls").addEventListener("change", (event) => {
    if (event.target.name === "exposure") return show_picture();
    data.settings.bounces = controls.bounces.value;
    if (event.target.name === "camera") return go_home();
    improve();
    if (event.target.name !== "shown" && event.target.name !== "from") walk();
  });
  by_id("controls").addEventListener("submit", (event) => event.preventDefault());
  by_id("home").addEventListener("click", go_home);
  by_id("show_tree").addEventListener("click", show_tree);
  by_id("level").addEventListener("input", () => show_level(0));
  by_id("save").addEventListener("click", save);
  load_scene().then(improve).then(undefined, (error) => complain(error.message));
  walk();
  if (data.watched) watch_saves();
}

begin();
