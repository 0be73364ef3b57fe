"use strict";

// 16-bit floats, little-endian, in base64, as numbers.
function halves(text) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  const numbers = new Array(bytes.length / 2);
  for (let i = 0; i < numbers.length; ++i) {
    const bits = view.getUint16(2 * i, true);
    const exponent = (bits >> 10) & 31;
    const fraction = bits & 1023;
    const size = exponent === 31 ? (fraction ? NaN : Infinity)
      : exponent === 0 ? fraction * 2 ** -24 : (1024 + fraction) * 2 ** (exponent - 25);
    numbers[i] = bits & 0x8000 ? -size : size;
  }
  return numbers;
}

function integers(text) {
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const view = new DataView(bytes.buffer);
  return Array.from({ length: bytes.length / 4 }, (_, i) => view.getInt32(4 * i, true));
}

function shown(value) {
  if (Number.isNaN(value)) return "not a number";
  if (!Number.isFinite(value)) return value > 0 ? "over 65504" : "below \u221265504";
  if (Number.isInteger(value)) return String(value).replace("-", "\u2212");
  return (Math.abs(value) < 0.001 ? value.toExponential(1) : value.toPrecision(3)).replace("-", "\u2212");
}

function percent(ratio) {
  if (!Number.isFinite(ratio)) return "\u2013";
  if (ratio > 10) return "> +1000 %";
  return `${ratio < 0 ? "\u2212" : "+"}${(100 * Math.abs(ratio)).toFixed(1)} %`;
}

const luminance = (c) => 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
const relative = (a, b, dark) => a === b ? 0 : (a - b) / (Math.abs(b) + dark);

// dark_of, as pt/image/compare.h has it.
function dark_of(rgb) {
  let sum = 0, count = 0;
  for (let i = 0; i < rgb.length; i += 3) {
    const y = luminance(rgb.slice(i, i + 3));
    if (Number.isFinite(y)) [sum, count] = [sum + y, count + 1];
  }
  return count ? 0.04 * sum / count : 0;
}

function element(name, text, className) {
  const made = document.createElement(name);
  if (text !== undefined) made.textContent = text;
  if (className) made.className = className;
  return made;
}

function row(label, values) {
  const line = element("tr");
  line.append(element("th", label), ...values.map((value) => element("td", value, "number")));
  return line;
}

// Returns the function that makes a table of the numbers at a pixel; it decodes them on its first
// call.
function reader(viewer) {
  const data = viewer.dataset;
  const film = data.kind === "film";
  let render, golden, noise, dark;
  // A small page has no values of pixels.
  if (!data.render) return () => "";
  return (index) => {
    if (!render) {
      const decode = film ? halves : integers;
      [render, golden] = [decode(data.render), decode(data.golden)];
      noise = data.noise ? halves(data.noise) : null;
      dark = film ? dark_of(golden) : 0;
    }
    const at = (numbers) => {
      if (!film) return [numbers[index]];
      const rgb = numbers.slice(3 * index, 3 * index + 3);
      return [...rgb, luminance(rgb)];
    };
    const [a, b] = [at(render), at(golden)];
    const table = element("table");
    table.append(row("", film ? ["R", "G", "B", "Y"] : ["samples"]), row("render", a.map(shown)),
      row("golden", b.map(shown)),
      row("off by", a.map((value, i) => percent(film ? relative(value, b[i], dark) : value / b[i] - 1))));
    if (noise) {
      const spread = noise[index] / (Math.abs(b[3]) + dark);
      table.append(row("noise", ["", "", "", `\u00b1 ${percent(spread).slice(1)}`]));
    }
    return table;
  };
}

const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

// `follow` gets the events of the pointer, and `move` the pixels to the right and down that an arrow key asks for.
function listen(stage, follow, move) {
  stage.tabIndex = 0;
  stage.setAttribute("role", "group");
  stage.setAttribute("aria-label", "Picture; arrow keys move the pixel that is read");
  stage.addEventListener("pointermove", follow);
  stage.addEventListener("pointerdown", follow);
  stage.addEventListener("keydown", (event) => {
    const step = steps[event.key];
    if (!step) return;
    event.preventDefault();
    const length = event.shiftKey ? 8 : 1;
    move(length * step[0], length * step[1]);
  });
}

// The slider moves the line between render and golden.
function split_by_slider(compare, slider) {
  const move = () => compare.style.setProperty("--split", `${slider.value}%`);
  slider.addEventListener("input", move);
  move();
}

function bring_to_life(viewer) {
  const width = Number(viewer.dataset.width);
  const height = Number(viewer.dataset.height);
  const read = reader(viewer);
  const readout = viewer.querySelector(".readout");
  const crosses = viewer.querySelectorAll(".cross");
  const compare = viewer.querySelector(".compare");
  let [x, y] = [width >> 1, height >> 1];

  function point_at(new_x, new_y) {
    x = Math.min(Math.max(new_x, 0), width - 1);
    y = Math.min(Math.max(new_y, 0), height - 1);
    for (const cross of crosses) {
      cross.classList.add("shown");
      cross.style.left = `${(100 * x) / width}%`;
      cross.style.top = `${(100 * y) / height}%`;
      cross.style.width = `${100 / width}%`;
      cross.style.height = `${100 / height}%`;
    }
    const where = element("p", `x ${x}, y ${y} from the top left `, "where");
    where.append(element("span", `(y ${height - 1 - y} in the tasks)`, "hint"));
    readout.replaceChildren(where, read(y * width + x));
  }

  function follow(event) {
    const box = event.currentTarget.getBoundingClientRect();
    point_at(Math.floor(((event.clientX - box.left) / box.width) * width),
      Math.floor(((event.clientY - box.top) / box.height) * height));
  }

  for (const stage of viewer.querySelectorAll(".stage")) {
    listen(stage, follow, (right, down) => point_at(x + right, y + down));
  }
  for (const button of viewer.querySelectorAll(".cells button")) {
    button.addEventListener("click", () => {
      point_at(Number(button.dataset.x), Number(button.dataset.y));
      compare.scrollIntoView({ block: "nearest" });
    });
  }
  split_by_slider(compare, viewer.querySelector(".split"));
  compare.classList.add("live");
}

// A picture that judges several tasks is in the page once. With the others it is shown while they are open.
function show_where_opened(reference) {
  const fold = reference.closest("details");
  const show = () => {
    if (!fold.open || !reference.parentElement) return;
    const original = document.getElementById(reference.dataset.place);
    for (const viewer of original.querySelectorAll(".viewer")) {
      const copy = viewer.cloneNode(true);
      reference.before(copy);
      bring_to_life(copy);
    }
    reference.remove();
  };
  fold.addEventListener("toggle", show);
  show();
}

// A link to something folded away unfolds it.
function unfold() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  for (let each = target; each; each = each.parentElement) {
    if (each.tagName === "DETAILS") each.open = true;
  }
  if (target) target.scrollIntoView();
}

document.documentElement.classList.add("scripted");
document.querySelectorAll(".viewer").forEach(bring_to_life);
document.querySelectorAll(".same").forEach(show_where_opened);
window.addEventListener("hashchange", unfold);
if (location.hash) unfold();
