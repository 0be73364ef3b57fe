
// Questions to the server, and what the page says while it has no answer.

const kPatience = 5000;  // ms

// The sentence of each kind of question that failed or has no answer yet. It stays until such a question is answered.
const troubles = new Map();

function show_troubles() {
  const sentences = [...new Set(troubles.values())].join(" ");
  const banner = by_id("banner");
  banner.hidden = !sentences;
  if (banner.textContent !== sentences) banner.textContent = sentences;
}

function complain(what, sentence) {
  if (sentence) troubles.set(what, sentence);
  else troubles.delete(what);
  show_troubles();
}

// What was asked for once, and not again with every change, is forgotten with the next change.
function forget_single_troubles() {
  for (const what of ["exr", "tree", "ray", "depth", "disk", "scene"]) complain(what, "");
}

const without = (words, names) => Object.fromEntries(Object.entries(words).filter(([name]) => !names.includes(name)));

async function read(answer) {
  const kind = answer.headers.get("Content-Type");
  if (kind.startsWith("application/json")) return answer.json();
  if (kind === "image/x-exr") return { file: await answer.blob() };
  const state = JSON.parse(answer.headers.get("X-State"));
  return { ...state, floats: new Float32Array(await answer.arrayBuffer()) };
}

// Throws if there is no answer; then the banner has said why.
async function ask(what, query) {
  const words = new URLSearchParams({ ...query, token: data.token });
  const waiting = setTimeout(() => complain(what, `The tasks have given no answer for ${kPatience / 1000} s, as in an endless loop.`), kPatience);
  try {
    const answer = await fetch(`/${what}?${words}`);
    if (!answer.ok) {
      const sentence = (await answer.text()).trim().replace(/[.]?$/, ".");
      throw new Error(answer.status === 503 ? `${sentence} The page goes on with the next change.` : sentence);
    }
    const known = await read(answer);
    complain(what, "");
    return known;
  } catch (error) {
    complain(what, error instanceof TypeError ? "./run view has ended, or cannot be reached. Start it again." : error.message);
    throw error;
  } finally {
    clearTimeout(waiting);
  }
}

// Returns a function that runs `run`, but never twice at the same time: what is wanted meanwhile is one more run at the end.
function one_at_a_time(run) {
  let running = null, again = false;
  const repeat = async () => {
    do {
      again = false;
      await run();
    } while (again);
  };
  return () => {
    again = true;
    running ??= repeat().finally(() => { running = null; });
    return running;
  };
}

const kEyeWords = ["camera", "eye", "target", "up"];

// The words of a request that say from where the scene is seen.
function words_of_eye() {
  const words = {};
  if (controls.camera.value !== kDefaults.camera) words.camera = controls.camera.value;
  if (now.view) for (const name of ["eye", "target", "up"]) words[name] = now.view[name].join(",");
  return words;
}

// The settings that differ from the usual ones, as words of a request.
function query() {
  const words = { w: data.settings.w, h: data.settings.h, bounces: controls.bounces.value, ...words_of_eye() };
  for (const name of ["seed", "whole"]) if (data.settings[name]) words[name] = data.settings[name];
  if (controls.is_adaptive.checked) words.adaptive = words_of_adaptive();
  for (const [name, usual] of Object.entries(kDefaults)) {
    if (name !== "camera" && controls[name].value !== usual) words[name] = controls[name].value;
  }
  if (words.show === "bounce") words.bounce = words.bounces;
  return words.shown === "normals" ? { ...without(words, ["shown"]), show: "normals" } : words;
}

// The same for the paths and the ray of the pixel: as the scene was seen when it was chosen.
function query_of_pixel() {
  return { ...without(query(), ["shown", ...kEyeWords]), ...now.pixel_from, x: now.pixel[0], y: now.pixel[1] };
}

function command() {
  const words = query();
  // As in view/worker/settings.cpp.
  const scale = words.whole && !words.camera ? Math.max(1, 480 / words.w, 360 / words.h) : 1;
  const [w, h] = [words.w, words.h].map((side) => Math.round(scale * side));
  const options = [`./run render ${data.scene_file} -f picture.png -r ${w} ${h} -m ${words.bounces}`];
  if (words.light_samples) options.push(`-l ${words.light_samples}`);
  if (words.hemisphere) options.push("-H");
  for (const name of ["show", "bounce", "survival", "engine", "camera", "seed"]) if (words[name]) options.push(`--${name} ${words[name]}`);
  const [most, ...adaptive] = words.adaptive ? words.adaptive.split(",") : ["64"];
  if (words.adaptive) options.push(`-a ${adaptive.join(" ")}`);
  for (const each of data.from.split("+")) options.push(`--from ${each}`); // a handout takes the learner's files by default
  if (data.boxed) return "none, because these are the tasks of a submission";
  return now.view ? "none, because the camera was moved" : `${options.join(" ")} -s ${most}`;
}

const is_same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

// --- the picture ---

const is_beside = () => ["both", "difference"].includes(controls.from.value);

// Better pictures. Two that are shown beside each other begin together, the one that is ahead waits, and they are shown at the end of
// the last stage that both have finished: so the same tasks make the same picture at every moment.
async function better_pictures(words, { own, reference }) {
  if (controls.from.value === "") return { own: await ask("picture", words), reference: null };
  const beside = is_beside();
  const wanted = beside ? { ...words, beside: 1 } : words;
  const is_ahead = (mine, other) => beside && mine && mine.whole && mine.stage > (other ? other.stage : 0);
  if (!is_ahead(own, reference)) own = await ask("picture", wanted);
  if (!is_ahead(reference, own)) reference = await ask("picture", { ...wanted, from: "reference" });
  return { own, reference };
}

const can_be_shown = ({ own, reference }) =>
  !is_beside() || (reference && own.stage > 1 && own.whole && reference.whole && own.stage === reference.stage);

// Returns whether there are better ones still.
async function show_better_pictures(turn) {
  const words = query();
  const latest = await better_pictures(words, now.latest).catch(() => null);
  const is_wanted = turn === now.asking;
  if (!latest) return false;
  // Of a camera that has gone on a picture is shown too, or nothing would be seen while it turns.
  if (!is_wanted && !is_same(without(query(), kEyeWords), without(words, kEyeWords))) return false;
  if (is_wanted) now.latest = latest;
  if (can_be_shown(latest)) {
    now.pictures = latest;
    now.kind = words.shown ?? "light";  // normals are light, too
    show_picture();
  }
  show_status();
  show_bad(latest.own);
  if (is_wanted && latest.own.stage > 1) await find_depth();
  stage.dataset.samples = latest.own.samples;
  begin_with_normals(latest.own);
  return latest.own.goes_on;
}

let is_improving = false;

async function improve_until_done() {
  if (is_improving) return;
  is_improving = true;
  try {
    for (;;) {
      const turn = now.asking;
      const goes_on = await show_better_pictures(turn);
      if (!goes_on && turn === now.asking) return;
      await new Promise((resolve) => { setTimeout(resolve, document.hidden ? 1000 : 0); });
    }
  } finally {
    is_improving = false;
  }
}

// Asks for better pictures, until there are none; first for another one, because something has changed.
function improve() {
  if (!data.live) return;
  ++now.asking;
  now.latest = {};
  forget_single_troubles();
  by_id("command").textContent = command();
  improve_until_done();
}

// The map of distances of a camera, if it is known.
const depth_of = (camera) => (now.depth && is_same(now.depth.camera, camera) ? now.depth : null);

// Asks for it, for the lines over the picture.
async function find_depth() {
  const { camera } = now;
  if (!data.live || !now.paths || !camera || depth_of(camera)) return;
  const depth = await ask("depth", without(query(), ["shown"])).catch(() => null);
  if (!depth) return;
  now.depth = { camera, ...depth };
  show_lines();
}

async function load_scene() {
  now.scene = await ask("scene", without(query(), ["shown"]));
}

// After a save, the tasks are compiled and the page goes on with them.
async function watch_saves() {
  let known = 0;
  for (;;) {
    await new Promise((resolve) => { setTimeout(resolve, 200); });
    const { saves, error } = await ask("saved", {}).catch(() => ({ saves: known, error: "" }));
    if (saves === known) continue;
    known = saves;
    complain("compile", error);
    if (error) continue;
    if (now.tree) show_tree().then(show_tree);
    improve();
    walk();
  }
}

// --- the paths of a pixel ---

const walk = one_at_a_time(async () => {
  if (!data.live || !now.pixel) return;
  by_id("paths").setAttribute("aria-busy", "true");
  if (now.which < 0) now.first = 0;
  const words = { ...query_of_pixel(), samples: by_id("count").value, first: now.first };
  try {
    const paths = await ask("paths", words);
    const reference = data.reference ? await ask("paths", { ...words, from: "reference" }) : null;
    [now.paths, now.reference] = [paths, reference];
    if (now.which < 0) show_first_red();
    now.which = Math.max(Math.min(now.which, now.paths.paths.length - 1), 0);
    show_paths();
    await find_ray();
    await find_depth();
  } catch {
    // the banner has said it
  }
  by_id("paths").removeAttribute("aria-busy");
});

// The light itself, or the numbers of a false colour; by these tasks, unless the picture is by the reference.
async function save_exr() {
  const words = controls.from.value === "reference" ? { ...query(), from: "reference" } : query();
  try {
    const { file } = await ask("exr", words);
    save(file, "picture.exr");
  } catch {
    // the banner has said it
  }
}
