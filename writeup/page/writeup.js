"use strict";

function element(name, text, className) {
  const made = document.createElement(name);
  if (text !== undefined) made.textContent = text;
  if (className) made.className = className;
  return made;
}
function button(text, action) {
  const made = element("button", text);
  made.type = "button";
  made.addEventListener("click", action);
  return made;
}
function shown(value) {
  if (value === 0 || Number.isInteger(value)) return String(value);
  return Math.abs(value) < 0.001 ? value.toExponential(1) : value.toPrecision(3);
}

// A group of pictures with one zoom, one place, one exposure.
class Group {
  constructor(root) {
    this.root = root;
    this.figure = root.closest(".figure");
    this.pictures = [...root.querySelectorAll(".picture[data-file]")].map((picture) => ({
      ...picture.dataset, width: Number(picture.dataset.width), height: Number(picture.dataset.height),
      label: picture.querySelector("strong").textContent, stages: [picture.querySelector(".stage")],
    }));
    if (this.pictures.length === 0) return;
    this.zoom = 1; this.x = 0; this.y = 0; this.stops = 0; this.mode = "all"; this.first = 0;
    this.at = null;
    this.readout = element("p", "", "readout");
    this.root.after(this.readout);
    this.make_tools();
    for (const picture of this.pictures) for (const stage of picture.stages) this.listen(stage);
  }

  can_stack() {
    const [first] = this.pictures;
    return this.root.dataset.flip === "true" && this.pictures.length > 1
      && this.pictures.every((p) => p.width === first.width && p.height === first.height);
  }

  make_tools() {
    this.tools = element("div", undefined, "tools");
    this.buttons = {};
    const mode = (name, text) => {
      this.buttons[name] = button(text, () => this.show(name));
      this.tools.append(this.buttons[name]);
    };
    if (this.can_stack()) {
      mode("all", "side by side");
      mode("slider", "slider");
      mode("flip", this.pictures.length > 2 ? "steps" : "flip");
    }
    this.tools.append(button("+", () => this.zoom_by(2)), button("\u2212", () => this.zoom_by(0.5)));
    this.tools.children[this.tools.children.length - 2].setAttribute("aria-label", "zoom in");
    this.tools.lastChild.setAttribute("aria-label", "zoom out");
    if (this.pictures.some((p) => p.kind === "film")) {
      const label = element("label", "exposure");
      this.exposure = element("input");
      Object.assign(this.exposure, { type: "range", min: -4, max: 6, step: 0.5, value: 0 });
      this.exposure.addEventListener("input", () => this.expose(Number(this.exposure.value)));
      this.stop_text = element("span", "0");
      label.append(this.exposure, this.stop_text);
      this.tools.append(label);
    }
    this.root.before(this.tools);
    this.show("all");
  }

  // All pictures in one place: a slider between two, or one after the other.
  make_compare() {
    this.compare = element("div", undefined, "compare");
    const stage = element("div", undefined, "stage");
    this.layers = this.pictures.map((picture) => {
      const layer = element("div", undefined, "layer");
      const image = element("img");
      Object.assign(image, { src: `figures/${picture.file}.png`, alt: picture.label, width: picture.width, height: picture.height });
      layer.append(image);
      stage.append(layer);
      picture.stages.push(layer);
      return layer;
    });
    this.line = element("div", undefined, "line");
    stage.append(this.line);
    this.names = element("div", undefined, "names");
    this.split = element("input");
    Object.assign(this.split, { type: "range", min: 0, max: 100, value: 50 });
    this.split.setAttribute("aria-label", "how much of the left picture is shown");
    this.split.addEventListener("input", () => this.compare.style.setProperty("--split", `${this.split.value}%`));
    this.choices = [0, 1].map((side) => {
      const select = element("select");
      select.setAttribute("aria-label", side ? "right picture" : "left picture");
      this.pictures.forEach((picture, i) => select.append(new Option(picture.label, i)));
      select.value = side ? this.pictures.length - 1 : 0;
      select.addEventListener("change", () => this.arrange());
      return select;
    });
    this.next = button("next", () => this.turn());
    this.step = element("input");
    Object.assign(this.step, { type: "range", min: 0, max: this.pictures.length - 1, step: 1 });
    this.step.setAttribute("aria-label", "which picture is shown");
    this.step.addEventListener("input", () => { this.first = Number(this.step.value); this.arrange(); });
    this.curve = draw_curve(this.figure, this.pictures);
    this.compare.append(stage, this.split, this.step, this.names, ...(this.curve ? [this.curve] : []));
    this.root.before(this.compare);
    this.listen(stage);
    this.paint();
  }

  show(mode) {
    this.mode = mode;
    for (const [name, each] of Object.entries(this.buttons)) each.setAttribute("aria-pressed", String(name === mode));
    if (mode !== "all" && !this.compare) this.make_compare();
    if (this.compare) this.compare.hidden = mode === "all";
    this.root.hidden = mode !== "all";
    this.root.style.display = mode === "all" ? "" : "none";
    if (mode !== "all") this.arrange();
  }

  arrange() {
    const slider = this.mode === "slider";
    this.split.hidden = this.line.hidden = !slider;
    this.split.style.display = slider ? "" : "none";
    this.step.hidden = slider;
    this.step.style.display = slider ? "none" : "";
    this.step.value = this.first;
    this.step.setAttribute("aria-valuetext", this.pictures[this.first].label);
    if (this.curve) {
      this.curve.style.display = slider ? "none" : "";
      this.curve.querySelectorAll("circle").forEach((dot, i) => dot.classList.toggle("here", i === this.first));
    }
    const [left, right] = this.choices.map((choice) => Number(choice.value));
    this.layers.forEach((layer, i) => {
      layer.hidden = slider ? i !== left && i !== right : i !== this.first;
      layer.classList.toggle("over", slider && i === left && left !== right);
      layer.style.zIndex = slider && i === left ? 1 : 0;
    });
    this.line.style.zIndex = 2;
    this.names.replaceChildren(...(slider ? this.choices
      : [element("strong", `${this.pictures[this.first].label} (${this.first + 1} of ${this.pictures.length})`), this.next]));
  }

  turn() {
    if (!this.can_stack()) return;
    if (this.mode === "flip") this.first = (this.first + 1) % this.pictures.length;
    this.show("flip");
  }

  zoom_by(factor, px = 0.5, py = 0.5) {
    const zoom = Math.min(Math.max(this.zoom * factor, 1), 32);
    // The point under the pointer stays where it is.
    this.x = px - ((px - this.x) * zoom) / this.zoom;
    this.y = py - ((py - this.y) * zoom) / this.zoom;
    this.zoom = zoom;
    this.place();
  }

  place() {
    this.x = Math.min(0, Math.max(this.x, 1 - this.zoom));
    this.y = Math.min(0, Math.max(this.y, 1 - this.zoom));
    for (const target of [this.root, this.compare]) {
      if (!target) continue;
      target.style.setProperty("--zoom", this.zoom);
      target.style.setProperty("--x", `${100 * this.x}%`);
      target.style.setProperty("--y", `${100 * this.y}%`);
      target.classList.toggle("zoomed", this.zoom > 1);
    }
    this.mark();
  }

  async expose(stops) {
    this.stops = Math.min(Math.max(stops, -4), 6);
    this.exposure.value = this.stops;
    this.stop_text.textContent = (this.stops > 0 ? "+" : "") + String(this.stops).replace("-", "\u2212");
    await Promise.all(this.pictures.filter((p) => p.kind === "film").map((p) => pixels_of(p.file)));
    this.paint();
  }

  paint() {
    const factor = 2 ** this.stops;
    for (const picture of this.pictures) {
      const values = known_pixels(picture.file);
      if (picture.kind !== "film" || !values) continue;
      for (const stage of picture.stages) {
        let canvas = stage.querySelector("canvas");
        if (this.stops === 0) { if (canvas) canvas.remove(); continue; }
        if (!canvas) { canvas = element("canvas"); stage.querySelector("img").after(canvas); }
        canvas.width = picture.width;
        canvas.height = picture.height;
        const context = canvas.getContext("2d");
        const image = context.createImageData(picture.width, picture.height);
        for (let i = 0, j = 0; i < values.length; ++i, ++j) {
          image.data[j] = 255 * Math.min(values[i] * factor, 1) ** (1 / 2.2) + 0.5;
          if (i % 3 === 2) image.data[++j] = 255;
        }
        context.putImageData(image, 0, 0);
      }
    }
  }

  pixel_at(event, stage) {
    const box = stage.getBoundingClientRect();
    const [px, py] = [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
    return [(px - this.x) / this.zoom, (py - this.y) / this.zoom];
  }

  listen(stage) {
    stage.tabIndex = 0;
    stage.setAttribute("role", "group");
    stage.setAttribute("aria-label", "Picture; the keys are at the foot of the page");
    let last = null;
    stage.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && this.zoom === 1) return;
      event.preventDefault();
      const box = stage.getBoundingClientRect();
      this.zoom_by(event.deltaY < 0 ? 1.25 : 0.8, (event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
    }, { passive: false });
    stage.addEventListener("pointerdown", (event) => { last = [event.clientX, event.clientY]; });
    stage.addEventListener("pointermove", (event) => {
      const [u, v] = this.pixel_at(event, stage);
      this.read(u, v);
      if (!last || event.buttons !== 1) return;
      const box = stage.getBoundingClientRect();
      if (this.zoom > 1) {
        this.x += (event.clientX - last[0]) / box.width;
        this.y += (event.clientY - last[1]) / box.height;
        this.place();
      } else if (this.mode === "slider" && this.compare.contains(stage)) {
        this.split.value = (100 * (event.clientX - box.left)) / box.width;
        this.split.dispatchEvent(new Event("input"));
      }
      last = [event.clientX, event.clientY];
    });
    stage.addEventListener("keydown", (event) => this.key(event));
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const { width, height } = this.pictures[0];
    if (steps[event.key]) {
      const [x, y] = this.at ?? [width >> 1, height >> 1];
      this.read((x + steps[event.key][0] + 0.5) / width, (y + steps[event.key][1] + 0.5) / height);
    } else if (event.key === "+" || event.key === "=") this.zoom_by(2);
    else if (event.key === "-") this.zoom_by(0.5);
    else if (event.key === "]" && this.exposure) this.expose(this.stops + 0.5);
    else if (event.key === "[" && this.exposure) this.expose(this.stops - 0.5);
    else if (event.key === "f") this.turn();
    else if (event.key === "0") {
      this.zoom_by(0);
      if (this.exposure) this.expose(0);
      this.show("all");
    } else return;
    event.preventDefault();
  }

  async read(u, v) {
    const { width, height } = this.pictures[0];
    const x = Math.min(Math.max(Math.floor(u * width), 0), width - 1);
    const y = Math.min(Math.max(Math.floor(v * height), 0), height - 1);
    if (this.at && this.at[0] === x && this.at[1] === y) return;
    this.at = [x, y];
    this.mark();
    await Promise.all(this.pictures.map((p) => pixels_of(p.file)));
    if (this.at[0] !== x || this.at[1] !== y) return;
    const longest = Math.max(...this.pictures.map((p) => p.label.length));
    const lines = this.pictures.map((p) => {
      const [px, py] = [Math.floor(((x + 0.5) / width) * p.width), Math.floor(((y + 0.5) / height) * p.height)];
      const i = py * p.width + px, values = known_pixels(p.file);
      const numbers = p.kind === "film" ? [...values.slice(3 * i, 3 * i + 3)] : [values[i]];
      return `${p.label.padEnd(longest)}  ${numbers.map((n) => shown(n).padStart(8)).join(" ")}`;
    });
    this.readout.textContent = [`x ${x}, y ${y} from the top left`, ...lines].join("\n");
  }

  mark() {
    if (!this.at) return;
    const { width, height } = this.pictures[0];
    for (const picture of this.pictures) {
      for (const stage of picture.stages) {
        let cross = stage.querySelector(".cross");
        if (!cross) { cross = element("div", undefined, "cross shown"); stage.append(cross); }
        cross.style.left = `${100 * (this.x + (this.zoom * this.at[0]) / width)}%`;
        cross.style.top = `${100 * (this.y + (this.zoom * this.at[1]) / height)}%`;
        cross.style.width = `${(100 * this.zoom) / width}%`;
        cross.style.height = `${(100 * this.zoom) / height}%`;
      }
    }
  }
}

for (const root of document.querySelectorAll(".group")) new Group(root);
document.documentElement.classList.add("scripted");
