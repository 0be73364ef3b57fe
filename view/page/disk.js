
// The directions above a point as a disk: the light that arrives there, and those that the tasks draw.

// `own` and `reference` are answers of /disk; `of` says of which point, and `turn` grows when older answers are no longer wanted.
const disk = { own: null, reference: null, of: "", paths: null, turn: 0 };

// The layers of an answer (view/worker/disk.h), each with a number per cell.
const kLayers = { emission: 0, other: 3, f: 6, pdf: 9, by_bsdf: 10, by_direct: 11 };

const cell_of = (answer, layer, i) => answer.floats[layer * answer.side ** 2 + i];
const color_of = (answer, layer, i) => [0, 1, 2].map((c) => cell_of(answer, layer + c, i));

// What a way to show the disk shows of a cell: a colour, or a density.
const kShadings = {
  emission: (answer, i) => color_of(answer, kLayers.emission, i),
  all: (answer, i) => plus(color_of(answer, kLayers.emission, i), color_of(answer, kLayers.other, i)),
  reflected: (answer, i) => kShadings.all(answer, i).map((c, channel) => Math.PI * c * color_of(answer, kLayers.f, i)[channel]),
  pdf: (answer, i) => cell_of(answer, kLayers.pdf, i),
  by_bsdf: (answer, i) => cell_of(answer, kLayers.by_bsdf, i),
  by_direct: (answer, i) => cell_of(answer, kLayers.by_direct, i),
};
const is_density = (shading) => ["pdf", "by_bsdf", "by_direct"].includes(shading);

// Whether a cell lies in the disk.
function is_inside(side, i) {
  const at = (k) => (2 * (k + 0.5)) / side - 1;
  return Math.hypot(at(i % side), at(Math.floor(i / side))) <= 1;
}

// Of a density, the end of the colours: four times the even one, or for lights nearly the largest.
function most_of(answer, shading) {
  if (shading !== "by_direct") return 4 / Math.PI;
  const numbers = Array.from({ length: answer.side ** 2 }, (_, i) => kShadings[shading](answer, i)).filter((value) => value > 0);
  numbers.sort((a, b) => a - b);
  return Math.max(numbers[Math.floor(0.9 * numbers.length)] ?? 0, 1 / Math.PI);
}

function paint_shading(canvas, answer, shading) {
  const exposure = 2 ** controls.exposure.value;
  const most = is_density(shading) ? most_of(answer, shading) : 1;
  paint(canvas, answer.side, answer.side, (i, bytes, at) => {
    const value = kShadings[shading](answer, i);
    const color = is_density(shading) ? ramp(value / most)
      : value.map((c) => 255 * Math.min(Math.max(exposure * c, 0), 1) ** (1 / 2.2));
    for (let c = 0; c < 3; ++c) bytes[at + c] = color[c];
  });
}

// A place of the disk, in pixels of the canvas; the disk leaves a margin.
const kMargin = 0.06;
const on_canvas = (canvas, x, y) =>
  [x, -y].map((value) => canvas.width * (0.5 + (0.5 - kMargin) * value));

function draw_dot(context, [x, y, z, kind], color, size) {
  const [left, top] = on_canvas(context.canvas, x, y);
  const cross_out = (style, width) => {
    context.strokeStyle = style;
    context.lineWidth = width;
    context.beginPath();
    for (const side of [-1, 1]) {
      context.moveTo(left - size, top - side * size);
      context.lineTo(left + size, top + side * size);
    }
    context.stroke();
  };
  if (!(z > 0) || kind === 1) {  // below the surface, or nothing comes from there
    cross_out("rgb(0 0 0 / 0.7)", 0.9 * size);
    cross_out(z > 0 ? "#ff8a80" : "#ff2a1a", 0.5 * size);
    return;
  }
  context.beginPath();
  context.arc(left, top, 0.8 * size, 0, 7);
  context.lineWidth = 0.35 * size;
  context.strokeStyle = kind === 2 ? color : "rgb(0 0 0 / 0.75)";
  context.fillStyle = color;
  if (kind !== 2) context.fill();
  context.stroke();
}

// The chosen path's own direction.
function draw_way(context, local) {
  const [left, top] = on_canvas(context.canvas, local[0], local[1]);
  for (const [style, width] of [["#000", 5], ["#ffd84a", 2.5]]) {
    context.beginPath();
    context.strokeStyle = style;
    context.lineWidth = width * devicePixelRatio;
    context.arc(left, top, 7 * devicePixelRatio, 0, 7);
    context.stroke();
  }
}

function draw_axes(context) {
  const size = devicePixelRatio;
  context.font = `bold ${11 * size}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (const [x, y, label, color] of [[1.07, 0, "x", "#ff5a4d"], [0, 1.07, "y", "#3fae5a"]]) {
    context.fillStyle = color;
    context.fillText(label, ...on_canvas(context.canvas, x, y));
  }
}

function draw_disk(canvas, answer, local) {
  const side = Math.round(canvas.clientWidth * devicePixelRatio) || 320;
  [canvas.width, canvas.height] = [side, side];
  const context = canvas.getContext("2d");
  const cells = document.createElement("canvas");
  paint_shading(cells, answer, by_id("disk_shown").value);
  const [left, top] = on_canvas(canvas, -1, 1), [right] = on_canvas(canvas, 1, 1);
  context.save();
  context.beginPath();
  context.arc(side / 2, side / 2, (right - left) / 2, 0, 7);
  context.clip();
  context.drawImage(cells, left, top, right - left, right - left);
  context.restore();
  context.strokeStyle = "#888";
  context.lineWidth = devicePixelRatio;
  context.stroke();
  const size = 3 * devicePixelRatio;
  if (by_id("dots_direct").checked) for (const dot of answer.by_direct.dots.slice(0, 200)) draw_dot(context, dot, "#52d273", size);
  if (by_id("dots_bsdf").checked) for (const dot of answer.by_bsdf.dots.slice(0, 200)) draw_dot(context, [...dot.slice(0, 3), 0], "#6fb7ff", size);
  if (local) draw_way(context, local);
  draw_axes(context);
}

// Whether two means differ by more than chance explains.
function is_apart([a, error_a], [b, error_b]) {
  if (![a, b, error_a, error_b].every((value) => typeof value === "number")) return false;
  return Math.abs(a - b) > 5 * Math.hypot(error_a, error_b) + 0.005 * Math.max(Math.abs(a), Math.abs(b));
}

const rounded = (value, digits) => (typeof value === "number" ? String(Number(value.toPrecision(digits))) : shown(value));

// What the disk reflects, and what the task returned, each as a bar.
function balance_cells({ disk: seen, returned }, most) {
  const cells = [seen, returned].map(([mean, error], i) => {
    const width = i > 0 && typeof error === "number" ? ` \u00b1 ${rounded(2 * error, 2)}` : "";
    const made = element("td", rounded(mean, 4) + width, "bar");
    made.style.setProperty("--part", `${(100 * mean) / most}%`);
    return made;
  });
  if (is_apart(seen, returned)) {
    cells[1].classList.add("differs");
    cells[1].append(element("strong", ` ${rounded(returned[0] / seen[0], 3)} times`));
  }
  return cells;
}

const percent = (part, all) => `${rounded((100 * part) / Math.max(all, 1), 2)} %`;

// A row for each task, with two columns for each answer.
function fill_balance(table, answers) {
  const row = (name, cells) => {
    const made = element("tr");
    made.append(element("th", name), ...cells);
    return made;
  };
  const rows = [row("", answers.flatMap(() => [element("th", "disk"), element("th", "returned")]))];
  const balance = (task, of) => {
    if (!answers.every((answer) => of(answer)?.disk[2] > 0)) return;
    const most = Math.max(...answers.flatMap((answer) => [of(answer).disk[0], of(answer).returned[0]]), 1e-30);
    rows.push(row(task, answers.flatMap((answer) => balance_cells(of(answer), most))));
  };
  balance(answers[0].task, (answer) => answer.direct);
  balance("trace_path", (answer) => answer.all);
  const fact = (task, text_of, is_odd) => rows.push(row(task, answers.map((answer) => {
    const cell = element("td", text_of(answer), is_odd(answer) ? "differs" : "");
    cell.colSpan = 2;
    return cell;
  })));
  fact("diffuse_pdf", (answer) => `adds up to ${rounded(answer.pdf_sum, 4)}`, (answer) => !(Math.abs(answer.pdf_sum - 1) < 0.01));
  const below = (drawn) => `${percent(drawn.below, drawn.count)} below`;
  // By chance it is about 4 divided by the root of their number.
  const is_elsewhere = (answer) => answer.elsewhere > 0.02 + 8 / Math.sqrt(answer.by_bsdf.count);
  fact("diffuse_sample", (answer) => `${percent(answer.elsewhere, 1)} misplaced${answer.by_bsdf.below ? `, ${below(answer.by_bsdf)}` : ""}`,
    is_elsewhere);
  const is_below = (answer) => answer.task === "direct_hemisphere" && answer.by_direct.below > 0;
  if (answers.some(is_below)) fact("direct_hemisphere", (answer) => below(answer.by_direct), is_below);
  table.replaceChildren(...rows);
}

function disk_in_words(answer) {
  const words = ({ disk: seen, returned }, task) => `the disk reflects ${shown(seen[0])}, ${task} returns ${shown(returned[0])}`;
  return `Disk of directions; ${words(answer.direct, answer.task)}${answer.all ? `; of all light ${words(answer.all, "trace_path")}` : ""}`;
}

// Before trace_path is written, the first point has a disk, if the functions of part 3 are.
const is_written = (answer) => !["diffuse_bsdf", answer.task].some((task) => answer.unwritten?.includes(task));

function show_disk() {
  const path = now.paths && now.paths.paths[now.which];
  const bounce = path && path.bounces[disk.point];
  by_id("disk").hidden = !disk.own || !bounce || !is_written(disk.own);
  if (by_id("disk").hidden) return;
  by_id("disk_point").textContent = `${disk.point + 1} of path ${now.paths.first + now.which + 1}`;
  by_id("disk_reference").hidden = by_id("disk_by").hidden = !disk.reference;
  const beside = now.reference && now.reference.paths[now.which]?.bounces[disk.point];
  for (const [name, answer, from] of [["own", disk.own, bounce], ["reference", disk.reference, beside]]) {
    if (!answer) continue;
    const canvas = by_id(`disk_${name}_picture`);
    canvas.setAttribute("aria-label", disk_in_words(answer));
    draw_disk(canvas, answer, from && from.local);
  }
  fill_balance(by_id("disk_balance"), [disk.own, disk.reference].filter(Boolean));
  const shading = by_id("disk_shown").value;
  by_id("disk_legend").hidden = !is_density(shading);
  by_id("disk_most").textContent = is_density(shading) ? `${shown(most_of(disk.own, shading))} and more; cos / \u03c0 is ${shown(1 / Math.PI)} everywhere` : "";
}

// The direction under the pointer.
function say_direction(event, answer) {
  const box = event.target.getBoundingClientRect();
  const at = (value, low, size) => ((value - low) / size - 0.5) / (0.5 - kMargin);
  const [x, y] = [at(event.clientX, box.left, box.width), -at(event.clientY, box.top, box.height)];
  if (!answer || Math.hypot(x, y) > 1) return;
  const cell = (value) => Math.min(Math.floor(((value + 1) / 2) * answer.side), answer.side - 1);
  const value = kShadings[by_id("disk_shown").value](answer, cell(-y) * answer.side + cell(x));
  by_id("disk_says").textContent = `wi ${[x, y, Math.sqrt(1 - x * x - y * y)].map((c) => c.toFixed(2)).join(", ")}: ${[value].flat().map(shown).join(", ")}`;
}

// Asks for the disk of the chosen point until it is complete, or another one is wanted.
async function improve_disk() {
  const path = now.paths && now.paths.paths[now.which];
  const bounce = path && path.bounces[now.point];
  if (!data.live) {
    if (disk.own && now.paths.first + now.which === data.disk.path && now.point === data.disk.point) show_disk();
    else by_id("disk").hidden = true;
    return;
  }
  if (!bounce) {
    by_id("disk").hidden = true;
    ++disk.turn;
    disk.of = "";  // it begins anew
    return;
  }
  const words = { ...without(query(), ["shown", "adaptive", "show", "bounce", ...kEyeWords]), met: bounce.met.join(","), point: now.point };
  const of = JSON.stringify(words);
  if (disk.of === of && disk.paths === now.paths) return show_disk();
  const turn = ++disk.turn;
  Object.assign(disk, { of, paths: now.paths });
  const { point } = now;
  for (let goes_on = true; goes_on;) {
    try {
      const own = await ask("disk", words);
      const reference = data.reference ? await ask("disk", { ...words, from: "reference" }) : null;
      if (turn !== disk.turn) return;
      Object.assign(disk, { own, reference, point });
      show_disk();
      by_id("disk").dataset.passes = own.passes;
      goes_on = is_written(own) && (own.goes_on || Boolean(reference?.goes_on));
    } catch {
      return;  // the banner has said why
    }
    // The first samples of the picture come first.
    const pause = Number(stage.dataset.samples ?? 0) < 2 ? 400 : 60;
    await new Promise((resolve) => { setTimeout(resolve, document.hidden ? 1000 : pause); });
    if (turn !== disk.turn) return;
  }
}

function begin_disk() {
  for (const name of ["disk_shown", "dots_bsdf", "dots_direct"]) by_id(name).addEventListener("change", show_disk);
  for (const name of ["own", "reference"]) {
    by_id(`disk_${name}_picture`).addEventListener("pointermove", (event) => say_direction(event, disk[name]));
  }
  paint_ramp(by_id("disk_ramp"), ramp);
  window.addEventListener("resize", show_disk);
  if (!data.live && data.disk) {
    Object.assign(disk, { own: with_floats(data.disk.own), point: data.disk.point,
      reference: data.disk.reference ? with_floats(data.disk.reference) : null });
  }
}
