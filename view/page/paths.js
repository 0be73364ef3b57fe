
// The table of a path: a row for each of its points.

function element(name, text, className) {
  const made = document.createElement(name);
  if (text !== undefined) made.textContent = text;
  if (className) made.className = className;
  return made;
}

function shown(value) {
  if (value === undefined || value === null) return "";
  if (typeof value !== "number") return String(value);
  const size = Math.abs(value);
  const text = size === 0 ? "0" : size < 1e-3 || size >= 1e6 ? value.toExponential(2) : value.toPrecision(4);
  return text.replaceAll("-", "\u2212");
}
const column = (v) => (v ? v.map(shown).join("\n") : "");

// What decided that a path goes on, or ends.
function survival_of(bounce, i, path, settings) {
  const last = i === path.bounces.length - 1;
  const drawn = bounce.drawn.map(shown).join(", ");
  if (!bounce.wi) {
    if (i + 1 >= settings.bounces) return "bounce limit";
    return drawn ? `${drawn}:\nends` : "ends";
  }
  const divided = bounce.survival === 1 ? "" : `\n\u00f7 ${shown(bounce.survival)}`;
  return `${drawn ? `${drawn}:\ngoes on` : "goes on"}${divided}${last ? "\nleaves the scene" : ""}`;
}

// The columns: the name of a cell, its head, and its text. Names are those of findings (view/worker/check.h).
const kColumns = [
  ["point", "point", (b) => `${column(b.p)}\nprimitive ${b.primitive}`],
  ["n", "n", (b) => column(b.n)],
  ["wo", "wo", (b) => column(b.wo)],
  ["direct", "direct\nlight", (b) => (b.direct ? column(b.direct.light) : "none")],
  ["throughput", "throughput", (b) => column(b.throughput)],
  ["part", "part", (b) => column(b.part)],
  ["survival", "roulette", (b, i, path, settings) => survival_of(b, i, path, settings)],
  ["wi", "wi", (b) => column(b.wi)],
  ["local", "wi,\nlocal", (b) => column(b.local)],
  ["f", "f", (b) => column(b.f)],
  ["cos", "cos", (b) => shown(b.cos)],
  ["pdf", "pdf", (b) => shown(b.pdf)],
];

// The numbers of a cell, for comparing; in the order in which the task comes to know them.
const kOrder = ["p", "primitive", "n", "wo", "direct", "drawn", "f", "cos", "pdf", "local", "wi", "throughput", "part"];
const kCellOf = { p: "point", primitive: "point", drawn: "survival" };

function numbers_of(bounce, name) {
  const value = name === "direct" ? bounce.direct && bounce.direct.light : bounce[name];
  return value === undefined || value === null ? [] : [value].flat();
}

function are_close(a, b) {
  return a.length === b.length && a.every((value, i) => {
    const other = b[i];
    if (typeof value !== "number" || typeof other !== "number") return value === other;
    return Math.abs(value - other) <= 1e-6 * Math.max(Math.abs(value), Math.abs(other), 1e-6);
  });
}

// The first number in which two paths differ: {bounce, cell}; null if they do not.
function first_difference(a, b) {
  for (let i = 0; i < Math.max(a.bounces.length, b.bounces.length); ++i) {
    const [mine, right] = [a.bounces[i], b.bounces[i]];
    if (!mine || !right) return { bounce: Math.max(i, 1), cell: "wi" };
    const name = kOrder.find((each) => !are_close(numbers_of(mine, each), numbers_of(right, each)));
    if (name) return { bounce: i + 1, cell: kCellOf[name] ?? name };
  }
  return null;
}

// The columns and the points that say something, before trace_path is written and after.
const has_paths = (unwritten) => !unwritten.includes("trace_path");
const columns_of = (unwritten) => (has_paths(unwritten) ? kColumns : kColumns.slice(0, 3));
const first_point_of = (path) => ({ ...path, bounces: path.bounces.slice(0, 1).map(({ p, primitive, n, wo }) => ({ p, primitive, n, wo, drawn: [] })) });

// `choose` is called with the number of the point whose row was pressed.
function fill_table(table, columns, path, settings, chosen, difference, choose) {
  const head = element("tr");
  head.append(element("th", ""), ...columns.map(([, title]) => element("th", title)));
  const rows = path.bounces.map((bounce, i) => {
    const row = element("tr", undefined, i === chosen ? "current" : "");
    row.append(element("th", String(i + 1)));
    for (const [name, , text] of columns) {
      const cell = element("td", text(bounce, i, path, settings));
      cell.dataset.cell = name;
      const broken = path.findings.find((each) => each.bounce === i + 1 && each.cell === name);
      if (broken) {
        cell.classList.add("broken");
        cell.title = `${broken.task}: ${broken.promise.replaceAll("_", " ")}`;
      }
      if (difference && difference.bounce === i + 1 && difference.cell === name) cell.classList.add("differs");
      row.append(cell);
    }
    row.addEventListener("click", () => choose(i));
    return row;
  });
  const [thead, tbody] = [element("thead"), element("tbody")];
  thead.append(head);
  tbody.append(...rows);
  table.replaceChildren(...(rows.length ? [thead, tbody] : []));
}

function fill_draws(table, bounce) {
  const head = element("tr");
  const titles = ["from", "wi", "distance", "radiance", "cos", "pdf", "seen"];
  head.append(...titles.map((title) => element("th", title)));
  const rows = (bounce && bounce.direct ? bounce.direct.draws : []).map((draw) => {
    const row = element("tr");
    const by = draw.hit < 0 ? "" : ` by primitive ${draw.hit}`;
    const from = draw.light < 0 ? (draw.hit < 0 ? "the sky" : `primitive ${draw.hit}`) : `light ${draw.light}`;
    const seen = !draw.traced ? "not looked for" : draw.light < 0 ? "" : draw.hidden ? `hidden${by}` : "visible";
    for (const text of [from, column(draw.wi), shown(draw.distance), column(draw.radiance), shown(draw.cos), shown(draw.pdf), seen]) {
      row.append(element("td", text));
    }
    return row;
  });
  table.replaceChildren(head, ...rows);
}

function sentence_of_sum(path, unwritten) {
  const missing = unwritten.length ? `; not written yet: ${unwritten.join(", ")}` : "";
  if (!path.bounces.length) return [`The ray meets nothing${missing}.`, "note"];
  if (!has_paths(unwritten)) return [`The ray meets primitive ${path.bounces[0].primitive}${missing}.`, "note"];
  const [sum, traced] = [path.sum, path.traced].map((c) => c.map(shown).join(", "));
  if (!path.one) return ["The task does not walk one path here, so its parts cannot be told apart.", ""];
  if (path.same) return [`The parts add up to what trace_path returned, bit for bit: ${traced}.`, "same"];
  const off = Math.max(...path.sum.map((c, i) => Math.abs(c - path.traced[i])));
  const size = Math.max(...path.traced.map(Math.abs));
  return off <= 1e-5 * size ? [`The parts add up to what trace_path returned, but for rounding: ${traced}. The task rounds in an order of its own `
    + "(a recursion multiplies the sum of all later points), so whether they agree bit for bit cannot be told.", "same"]
    : [`The parts add up to ${sum}; trace_path returned ${traced}.`, "fault"];
}

function finding_line(finding) {
  const line = element("li");
  const place = finding.bounce > 0 ? `point ${finding.bounce}, ${finding.cell}` : finding.cell;
  line.append(`${place}: ${finding.text}. This breaks \u201c${finding.promise.replaceAll("_", " ")}\u201d `,
    element("code", `./run grade ${finding.task}`, "command"));
  return line;
}
