// What the live figures have in common: calls of the reference, a canvas with handles to drag, sliders. A figure's own script calls
// live.figure(name, make); make builds it from the parts below and returns the function that draws it.
'use strict';
const live = (() => {
  const made = {};
  let reference;

  // Calls a function of site/live with numbers. `calls` keeps the last call of each, for tests.
  const calls = {};
  function ask(name, ...given) {
    const numbers = given.flat();
    reference.HEAPF64.set(numbers, reference._numbers_in(numbers.length) / 8);
    const size = reference[`_live_${name}`]();
    const at = reference._numbers_out() / 8;
    const answer = reference.HEAPF64.slice(at, at + size);
    calls[name] = { given: numbers, answer };
    return answer;
  }

  function element(name, into, properties = {}) {
    const made = Object.assign(document.createElement(name), properties);
    into.append(made);
    return made;
  }

  // Colours of the page by name; to ask the page for each line of a figure takes longer than to draw it.
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const colors = new Map();
  dark.addEventListener('change', () => colors.clear());
  function color(name) {
    if (!colors.has(name)) colors.set(name, getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim());
    return colors.get(name);
  }

  class Figure {
    constructor(root) {
      this.root = root;
      this.stage = root.querySelector('.stage');
      this.redraw = this.redraw.bind(this);
    }

    // A canvas whose drawing has `width` x `height` units.
    canvas(width, height, label) {
      const canvas = element('canvas', this.stage, { width, height });
      canvas.setAttribute('role', 'img');
      canvas.setAttribute('aria-label', label);
      canvas.classList.add('still');
      const resize = () => {
        const scale = Math.max(1, canvas.clientWidth * devicePixelRatio / width);
        canvas.width = Math.round(width * scale);
        canvas.height = Math.round(height * scale);
        canvas.getContext('2d').setTransform(scale, 0, 0, scale, 0, 0);
        this.redraw();
      };
      canvas.units = { width, height };
      new ResizeObserver(resize).observe(canvas);
      return canvas;
    }

    // Lets fingers, mouse and arrow keys drag: move(x, y) gets the place in units of the canvas; start(x, y), if there is one, the place
    // where it began. With arrow keys, place() says where the handle is.
    drag(canvas, place, move, start) {
      const { width, height } = canvas.units;
      canvas.tabIndex = 0;
      canvas.classList.remove('still');
      canvas.setAttribute('role', 'application');
      const at = (event) => {
        const box = canvas.getBoundingClientRect();
        return [(event.clientX - box.left) / box.width * width, (event.clientY - box.top) / box.height * height];
      };
      canvas.addEventListener('pointerdown', (event) => {
        canvas.setPointerCapture(event.pointerId);
        if (start) start(...at(event));
        move(...at(event));
        this.redraw();
      });
      canvas.addEventListener('pointermove', (event) => {
        if (!canvas.hasPointerCapture(event.pointerId)) return;
        move(...at(event));
        this.redraw();
      });
      const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
      canvas.addEventListener('keydown', (event) => {
        const step = steps[event.key];
        if (!step) return;
        event.preventDefault();
        const [x, y] = place();
        move(x + step[0] * width / 60, y + step[1] * height / 60);
        this.redraw();
      });
    }

    tools() {
      this.toolbar ??= element('div', this.stage, { className: 'tools' });
      return this.toolbar;
    }

    // A slider; `value` is its number. shown(number) is the text beside it.
    slider(name, min, max, step, value, shown = (number) => number) {
      const label = element('label', this.tools(), { textContent: name });
      const input = element('input', label, { type: 'range', min, max, step, value });
      const output = element('output', label);
      const slider = {
        get value() { return Number(input.value); },
        set(value) { input.value = value; show(); },
      };
      const show = () => { output.textContent = shown(slider.value); };
      input.addEventListener('input', () => { show(); this.redraw(true); });
      show();
      return slider;
    }

    button(name, press) {
      const button = element('button', this.tools(), { type: 'button', textContent: name });
      button.addEventListener('click', () => { press(button); this.redraw(true); });
      return button;
    }

    // The sentence with the numbers.
    says() {
      const line = element('p', this.stage, { className: 'says' });
      return (text) => { if (line.textContent !== text) line.textContent = text; };
    }

    // Draws before the next picture of the screen, once.
    redraw(changed) {
      this.changed = this.changed || changed === true;
      if (this.waiting || !this.draw) return;
      this.waiting = true;
      requestAnimationFrame(() => {
        const changed = this.changed;
        this.waiting = this.changed = false;
        this.draw(changed);
        this.root.dataset.drawn = Number(this.root.dataset.drawn ?? 0) + 1;
      });
    }
  }

  // A view of the room, as site/live/light.cpp reads it.
  function view(changes = {}) {
    const all = { lamp: 0.6, yaw: 0, pitch: 0, width: 160, height: 120, from: 0, to: 5, lights: 1, hemisphere: 0, survival: 0.7, normals: 0, ...changes };
    return [all.lamp, all.yaw, all.pitch, all.width, all.height, all.from, all.to, all.lights, all.hemisphere, all.survival, all.normals];
  }

  // A picture that gets better, a few rows at a time, so that the page stays quick. ask(row, rows) returns colours of rows.
  class Growing {
    constructor(width, height, rows) {
      this.width = width;
      this.height = height;
      this.rows = rows;
      this.canvas = Object.assign(document.createElement('canvas'), { width, height });
      this.image = new ImageData(width, height);
      this.restart();
    }

    restart() {
      this.sum = new Float64Array(this.width * this.height * 3);
      this.samples = 0;
      this.row = 0;
    }

    // Works for some milliseconds; at least until each pixel has a sample.
    work(milliseconds) {
      const end = performance.now() + milliseconds;
      do {
        const rows = Math.min(Math.ceil(1000 / this.width), this.height - this.row);
        const colors = this.rows(this.row, rows, this.samples + 1);
        const first = this.row * this.width * 3;
        for (let i = 0; i < colors.length; ++i) this.sum[first + i] += colors[i];
        this.paint(rows);
        this.row += rows;
        if (this.row === this.height) {
          this.row = 0;
          ++this.samples;
        }
      } while (this.samples === 0 || performance.now() < end);
      this.canvas.getContext('2d').putImageData(this.image, 0, 0);
    }

    paint(rows) {
      for (let y = this.row; y < this.row + rows; ++y) {
        for (let x = 0; x < this.width; ++x) {
          const from = (y * this.width + x) * 3, to = ((this.height - 1 - y) * this.width + x) * 4;
          for (let c = 0; c < 3; ++c) this.image.data[to + c] = shade(this.sum[from + c] / (this.samples + 1));
          this.image.data[to + 3] = 255;
        }
      }
    }
  }

  // Radiance as a byte: L^(1/2.2), as the pictures of the course.
  const shade = (light) => 255 * Math.min(1, Math.max(0, light)) ** (1 / 2.2);
  const css = (r, g, b) => `rgb(${Math.round(shade(r))} ${Math.round(shade(g))} ${Math.round(shade(b))})`;

  function line(pen, x0, y0, x1, y1, name, width = 2) {
    pen.strokeStyle = color(name);
    pen.lineWidth = width;
    pen.beginPath();
    pen.moveTo(x0, y0);
    pen.lineTo(x1, y1);
    pen.stroke();
  }
  function dot(pen, x, y, name, radius = 5) {
    pen.fillStyle = color(name);
    pen.beginPath();
    pen.arc(x, y, radius, 0, 2 * Math.PI);
    pen.fill();
  }
  function text(pen, words, x, y, name = 'ink', align = 'left') {
    pen.fillStyle = color(name);
    // On a phone the drawing is small, and its words are not quite as small.
    pen.font = `${14 * Math.min(1.4, Math.max(1, 640 / pen.canvas.clientWidth))}px system-ui, sans-serif`;
    pen.textAlign = align;
    pen.fillText(words, x, y);
  }

  // The mean of a list, and the standard deviation of one of its numbers.
  function statistics(list) {
    const mean = list.reduce((sum, each) => sum + each, 0) / list.length;
    return { mean, deviation: Math.sqrt(list.reduce((sum, each) => sum + (each - mean) ** 2, 0) / (list.length - 1)) };
  }
  // The mean of the first numbers of a list against how many they are, across `width`; height(mean) is where it is drawn.
  function running_mean(pen, list, left, width, height, name) {
    let sum = 0;
    pen.strokeStyle = color(name);
    pen.lineWidth = 2;
    pen.beginPath();
    list.forEach((each, i) => {
      sum += each;
      pen.lineTo(left + width * (i + 1) / list.length, height(sum / (i + 1)));
    });
    pen.stroke();
  }

  function stills() {
    for (const root of document.querySelectorAll('figure.live[data-figure]')) {
      const stage = root.querySelector('.stage');
      if (stage) stage.replaceChildren(Object.assign(new Image(), { src: root.dataset.still, alt: root.dataset.alt, className: 'still' }));
    }
  }

  async function start() {
    try {
      reference = await Reference();
    } catch {
      stills();
      return;
    }
    for (const root of document.querySelectorAll('figure.live[data-figure]')) {
      const figure = new Figure(root);
      figure.draw = made[root.dataset.figure](figure);
      figure.redraw(true);
      dark.addEventListener('change', () => figure.redraw());
    }
    document.documentElement.dataset.live = 'ready';
  }
  addEventListener('DOMContentLoaded', start);

  return { ask, calls, color, css, dot, figure: (name, make) => { made[name] = make; }, Growing, line, running_mean, shade, statistics, text, view };
})();
