
// All samples of the pixel: their values as bars, and their paths in the picture.

const brightness_of = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

// The mean of the first n values, and half of its 95 % interval, for every n.
function running(values) {
  let [mean, squares] = [0, 0];
  return values.map((value, i) => {
    const distance = value - mean;
    mean += distance / (i + 1);
    squares += distance * (value - mean);
    return { mean, half: i > 0 ? 1.96 * Math.sqrt(squares / i / (i + 1)) : Infinity };
  });
}

// The most samples, the batch and the tolerance of adaptive sampling, as the word of a request.
const words_of_adaptive = () => ["most", "batch", "tolerance"].map((name) => controls[name].value).join(",");

function begin_adaptive() {
  if (!data.settings.adaptive) return;
  const words = data.settings.adaptive.split(",");
  ["most", "batch", "tolerance"].forEach((name, i) => { controls[name].value = words[i]; });
  controls.is_adaptive.checked = true;
}

// The upper end of the bars: fireflies are cut off, so that the others can be seen.
function top_of(values) {
  const sorted = values.filter(Number.isFinite).sort((a, b) => a - b);
  const usual = 4 * (sorted[Math.floor(0.9 * (sorted.length - 1))] ?? 0);
  const most = sorted.at(-1) ?? 0;
  return (usual > 0 ? Math.min(usual, most) : most) || 1;
}

const brightnesses = () => now.paths.values.map((value) => (value.every(Number.isFinite) ? brightness_of(value) : NaN));

function draw_bars(context, values, top, colors) {
  const { width, height } = context.canvas;
  const step = width / values.length;
  values.forEach((value, i) => {
    const is_cut = !(value <= top);
    const chosen = i === now.paths.first + now.which;
    context.fillStyle = is_cut ? colors.cut : chosen ? colors.chosen : colors.bar;
    const part = is_cut ? 1 : Math.max(value, 0) / top;
    const size = Math.max(part * height, devicePixelRatio);
    context.fillRect(i * step, height - size, Math.max(step - (step > 4 ? devicePixelRatio : 0), 1), size);
    if (chosen) {
      context.fillStyle = colors.chosen;
      context.fillRect(i * step, height - 4 * devicePixelRatio, Math.max(step, 3 * devicePixelRatio), 4 * devicePixelRatio);
    }
  });
}

function draw_mean(context, steps, top, color) {
  const { width, height } = context.canvas;
  const place = (i, value) => [((i + 0.5) * width) / steps.length, height * (1 - Math.min(Math.max(value / top, -0.05), 1.05))];
  context.beginPath();
  steps.forEach(({ mean, half }, i) => context.lineTo(...place(i, mean + Math.min(half, 1e30))));
  for (let i = steps.length - 1; i >= 0; --i) context.lineTo(...place(i, steps[i].mean - Math.min(steps[i].half, 1e30)));
  context.fillStyle = color;
  context.globalAlpha = 0.22;
  context.fill();
  context.globalAlpha = 1;
  context.beginPath();
  steps.forEach(({ mean }, i) => context.lineTo(...place(i, mean)));
  context.strokeStyle = color;
  context.lineWidth = 2 * devicePixelRatio;
  context.stroke();
}

// The interval that the tolerance allows around the mean, the ends of the batches, and where adaptive_pixel stopped.
function draw_adaptive(context, steps, top, { batch, tolerance, stopped }, color) {
  const { width, height } = context.canvas;
  const { mean } = steps.at(-1);
  const line = (x0, y0, x1, y1, dash) => {
    context.setLineDash(dash.map((length) => length * devicePixelRatio));
    context.beginPath();
    context.moveTo(x0, y0);
    context.lineTo(x1, y1);
    context.stroke();
  };
  context.strokeStyle = color;
  context.lineWidth = 1.5 * devicePixelRatio;
  for (const side of [-1, 1]) {
    const y = height * (1 - (mean * (1 + side * tolerance)) / top);
    line(0, y, width, y, [5, 4]);
  }
  const at = (n) => (n * width) / steps.length;
  for (let n = batch; n <= steps.length; n += batch) line(at(n), height, at(n), 0.86 * height, []);
  context.lineWidth = 3 * devicePixelRatio;
  const x = Math.min(at(stopped), width - 1.5 * devicePixelRatio);
  line(x, 0, x, height, []);
  context.setLineDash([]);
}

function adaptive_of_page() {
  const [most, batch, tolerance] = (now.paths.adaptive || "").split(",").map(Number);
  return batch ? { most, batch, tolerance, stopped: now.paths.samples } : null;
}

const as_percent = (value) => `${Number((100 * value).toPrecision(2))} %`;

function samples_in_words(values, steps, adaptive) {
  const { mean, half } = steps.at(-1);
  const width = Number.isFinite(half) && mean > 0 ? `, \u00b1 ${as_percent(half / mean)} with 95 %` : "";
  const sentence = `${values.length} samples, mean luminance ${shown(mean)}${width}.`;
  if (!adaptive) return sentence;
  const before = steps[adaptive.stopped - adaptive.batch - 1];
  const so_far = before && before.mean > 0 ? ` After ${adaptive.stopped - adaptive.batch} it was \u00b1 ${as_percent(before.half / before.mean)}.` : "";
  const other = now.reference ? ` The reference stopped after ${now.reference.samples}.` : "";
  return `adaptive_pixel stopped after ${adaptive.stopped} of at most ${adaptive.most}, batch ${adaptive.batch}, tolerance ${as_percent(adaptive.tolerance)}. ${sentence}${so_far}${other}`;
}

function show_samples() {
  const { paths } = now;
  by_id("samples").hidden = !paths || paths.values.length < 2 || !has_paths(paths.unwritten);
  if (by_id("samples").hidden) return;
  const canvas = by_id("strip");
  canvas.width = Math.round(canvas.clientWidth * devicePixelRatio);
  canvas.height = Math.round(canvas.clientHeight * devicePixelRatio);
  const context = canvas.getContext("2d");
  const values = brightnesses(), steps = running(values.map((value) => value || 0)), top = top_of(values);
  const adaptive = adaptive_of_page();
  const style = getComputedStyle(document.body);
  const color = (name) => style.getPropertyValue(name).trim();
  draw_bars(context, values, top, { bar: color("--muted"), chosen: color("--link"), cut: "#d95f02" });
  draw_mean(context, steps, top, color("--link"));
  if (adaptive) draw_adaptive(context, steps, top, adaptive, color("--fault"));
  const words = samples_in_words(values, steps, adaptive);
  const cut = values.filter((value) => !(value <= top)).length;
  by_id("samples_say").textContent = words + (cut ? ` ${cut} bars (orange) go beyond the top, ${shown(top)}.` : "");
  canvas.setAttribute("aria-label", `A bar for each sample. ${by_id("samples_say").textContent} Arrow keys choose a sample`);
}

// Shows the path of a sample of the pixel. The calls of 64 samples are known at a time.
async function choose_sample(sample) {
  const count = now.paths ? now.paths.values.length : 0;
  if (count === 0) return;
  const i = ((sample % count) + count) % count;
  const { first, paths } = now.paths;
  now.point = 0;
  if (i < first || i >= first + paths.length) {
    if (!data.live) return;
    now.first = 64 * Math.floor(i / 64);
    now.which = i - now.first;
    await walk();
    return;
  }
  now.which = i - first;
  show_paths();
}

// The other paths of the pixel, faint.
function draw_all_paths(context, camera, { paths }, which) {
  if (!by_id("all_paths").checked) return;
  paths.forEach(({ bounces }, i) => {
    if (i === which) return;
    for (let k = 0; k + 1 < bounces.length; ++k) {
      const ends = project_line(camera, bounces[k].p, bounces[k + 1].p);
      if (ends) draw_ends(context, ends, "rgb(255 216 74 / 0.35)", 1.2, []);
    }
  });
}

function begin_samples() {
  const strip = by_id("strip");
  strip.addEventListener("click", (event) => {
    const box = strip.getBoundingClientRect();
    choose_sample(Math.floor(((event.clientX - box.left) / box.width) * now.paths.values.length));
  });
  strip.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!step) return;
    choose_sample(now.paths.first + now.which + step);
    event.preventDefault();
  });
  by_id("brightest").addEventListener("click", () => {
    const values = brightnesses().map((value) => (Number.isNaN(value) ? Infinity : value));
    choose_sample(values.indexOf(Math.max(...values)));
  });
  by_id("all_paths").addEventListener("change", show_lines);
  window.addEventListener("resize", show_samples);
}
