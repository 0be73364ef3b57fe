"use strict";

// Pixels of a picture, fetched as a script when they are first asked for: that works from a file too.
const waiting = {};
function firstlight_data(name, kind, text) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  const n = bytes.length / 4;
  const values = new Float32Array(kind === "film" ? 3 * n : n);
  for (let i = 0; i < n; ++i) {
    if (kind !== "film") {
      values[i] = view.getFloat32(4 * i, true);
      continue;
    }
    const bits = view.getUint32(4 * i, true);
    const scale = 2 ** ((bits >>> 27) - 24);
    values[3 * i] = (bits & 511) * scale;
    values[3 * i + 1] = ((bits >>> 9) & 511) * scale;
    values[3 * i + 2] = ((bits >>> 18) & 511) * scale;
  }
  waiting[name].resolve(values);
}
function pixels_of(name) {
  if (!waiting[name]) {
    const entry = (waiting[name] = {});
    entry.promise = new Promise((resolve, reject) => {
      entry.resolve = (values) => { entry.values = values; resolve(values); };
      const script = document.createElement("script");
      script.src = `figures/${name}.js`;
      script.onerror = () => reject(new Error(`${script.src} is not there`));
      document.head.append(script);
    });
  }
  return waiting[name].promise;
}
const known_pixels = (name) => waiting[name] && waiting[name].values;

// The error of each picture, from the figure's table: a line with a point for each, on a scale of powers. Nothing without
// at least three errors.
function draw_curve(figure, pictures) {
  const table = figure.querySelector("table");
  const column = table ? [...table.tHead.rows[0].cells].findIndex((cell) => cell.textContent === "error") : -1;
  if (column < 0) return null;
  const errors = pictures.map((picture) => {
    const row = [...table.tBodies[0].rows].find((each) => each.cells[0].textContent === picture.label);
    return row ? parseFloat(row.cells[column].textContent) : NaN;
  });
  if (pictures.length < 3 || !errors.every((error) => error > 0)) return null;
  const logs = errors.map(Math.log), [low, high] = [Math.min(...logs), Math.max(...logs)];
  if (low === high) return null;
  const made = (name, attributes, text) => {
    const each = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) each.setAttribute(key, value);
    if (text) each.textContent = text;
    return each;
  };
  const points = logs.map((log, i) => [20 + (560 * i) / (logs.length - 1), 20 + (60 * (high - log)) / (high - low)]);
  const picture = made("svg", { viewBox: "0 0 600 110", class: "curve", role: "img", "aria-label": "the error of each picture; the table has the numbers" });
  picture.append(made("polyline", { points: points.map((each) => each.join()).join(" ") }));
  points.forEach(([x, y], i) => {
    picture.append(made("circle", { cx: x, cy: y, r: 5 }), made("text", { x, y: y - 10 }, `${errors[i]} %`), made("text", { x, y: 104 }, pictures[i].label));
  });
  return picture;
}
