
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
  depth: null,   // the distances of surfaces from a camera
  view: null,    // an eye that was moved; null: the camera of the file
  pixel: data.pixel ?? null,
  paths: data.paths ?? null,
  reference: data.reference_paths ?? null,
  ray: data.ray ?? null,
  which: -1,  // not chosen yet
  point: 0,
  pictures: {},  // by whom
  pointer: null, // the pixel below it
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
  const kind = answer.headers.get("Content-Type");
  if (kind.startsWith("application/json")) return answer.json();
  if (kind === "image/x-exr") return { file: await answer.blob() };
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
  for (const each of data.from.split("+")) options.push(`--from ${each}`); // a handout takes the learner's files by default
  if (data.boxed) return "none, because these are the tasks of a submission";
  return now.view ? "none, because the camera was moved" : `${options.join(" ")} -s ${most}`;
}

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

const is_same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

// The map of distances of a camera, if it is known.
const depth_of = (camera) => (now.depth && is_same(now.depth.camera, camera) ? now.depth : null);

// Asks for it, for the lines over the picture.
async function find_depth() {
  const { camera } = now;
  if (!data.live || !now.paths || !camera || depth_of(camera)) return;
  const words = query();
  delete words.shown;
  now.depth = { camera, ...await ask("depth", words) };
  show_lines();
}

function show_picture() {
  const { own, reference } = now.pictures;
  const from = controls.from.value;
  const picture = chosen_picture();
  by_id("beside").hidden = from !== "both";
  if (!picture) return;
  const canvas = by_id("picture");
  now.camera = picture.camera;
  document.body.style.setProperty("--shape", picture.width / picture.height);
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
  const picture = chosen_picture();
  const pixel = now.pointer ?? now.pixel;
  if (!pixel || !picture) return "";
  const [x, y] = pixel;
  const i = 3 * ((picture.height - 1 - y) * picture.width + x);
  const value = picture.floats.subarray(i, controls.shown.value === "light" ? i + 3 : i + 1);
  return ` \u00b7 x ${x}, y ${y}: ${Array.from(value, shown).join(", ")}`;
}

function show_status() {
  if (now.pictures.own) by_id("status").textContent = status_of(now.pictures.own) + value_under_pointer();
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
      show_status();
      show_bad(own);
      if (own.stage > 1) await find_depth();
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
    await new Promise((resolve) => { setTimeout(resolve, 200); });
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
  const camera = now.camera && { ...now.camera, depth: depth_of(now.camera) };
  const tests = by_id("ray").hidden ? 0 : Number(by_id("test").value);
  if (tests > 0 && camera) draw_tests(context, camera, now.ray, tests);
  else if (now.tree && camera) draw_boxes(context, camera, now.tree.nodes, Number(by_id("level").value));
  if (path && camera && now.scene) {
    const size = Math.hypot(...plus(now.scene.max, now.scene.min, -1));
    draw_path(context, camera, path, now.paths.shapes, size);
    if (now.has_frame && path.bounces[now.point]) draw_frame(context, camera, path.bounces[now.point], 0.05 * size);
  }
  if (controls.from.value === "both" && now.pictures.reference) {
    const x = by_id("split").value / 100;
    for (const [style, size] of [["#000", 3], ["#fff", 1]]) draw_ends(context, [[x, 0], [x, 1]], style, size, []);
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
    await find_depth();
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

function next_point(step) {
  const last = now.paths.paths[now.which].bounces.length - 1;
  choose_point(Math.max(Math.min(now.point + step, last), 0));
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
  const unwritten = paths.unwritten.length ? `; not written yet: ${paths.unwritten.join(", ")}` : "";
  const nothing = `The ray meets nothing${unwritten}.`;
  by_id("sum").textContent = path.bounces.length ? sentence + emitted : nothing;
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

async function load_scene() {
  const words = query();
  delete words.shown;
  now.scene = await ask("scene", words);
}

function save(blob, name) {
  const link = element("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}

// The light itself, or the numbers of a false colour; by these tasks, unless the picture is by the reference.
async function save_exr() {
  const words = controls.from.value === "reference" ? { ...query(), from: "reference" } : query();
  try {
    const { file } = await ask("exr", words);
    save(file, "picture.exr");
  } catch (error) {
    complain(error.message);
  }
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
    show_picture();
    stage.dataset.ready = "yes";
  }
  const image = new Image();
  image.addEventListener("load", () => {
    const canvas = by_id("picture");
    [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
    document.body.style.setProperty("--shape", canvas.width / canvas.height);
    canvas.getContext("2d").drawImage(image, 0, 0);
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
  by_id("save").addEventListener("click", () => by_id("picture").toBlob((blob) => save(blob, "picture.png")));
  by_id("save_exr").addEventListener("click", save_exr);
  by_id("split").addEventListener("input", show_picture);
  load_scene().then(improve).then(undefined, (error) => complain(error.message));
  walk();
  if (data.watched) watch_saves();
}

begin();
