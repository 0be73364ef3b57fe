"use strict";

// Pictures: from linear radiance, or a number per pixel, to the colours of a screen.

const kStops = [[13, 8, 60], [98, 26, 128], [190, 55, 84], [243, 130, 45], [249, 251, 170]];

// The colour at t in 0 .. 1 between the stops.
function ramp(t) {
  const at = Math.min(Math.max(t, 0), 1) * (kStops.length - 1);
  const i = Math.min(Math.floor(at), kStops.length - 2);
  return kStops[i].map((low, c) => low + (at - i) * (kStops[i + 1][c] - low));
}

// Blue is too dark, orange too bright.
function signed_color(t) {
  const size = Math.min(Math.abs(t), 1);
  return (t < 0 ? [33, 102, 172] : [217, 95, 2]).map((c) => 247 + size * (c - 247));
}

// 8 bits for a linear value: a table of the power 1 / 2.2, fine enough for its dark end.
const kGammaSteps = 1 << 14;
const kGamma = Uint8Array.from({ length: kGammaSteps + 1 },
  (_, i) => Math.round(255 * (i / kGammaSteps) ** (1 / 2.2)));

function paint(canvas, width, height, color_of) {
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d");
  const image = context.createImageData(width, height);
  for (let i = 0; i < width * height; ++i) {
    color_of(i, image.data, 4 * i);
    image.data[4 * i + 3] = 255;
  }
  context.putImageData(image, 0, 0);
}

function paint_light(canvas, picture, exposure) {
  const { floats } = picture;
  paint(canvas, picture.width, picture.height, (i, data, at) => {
    for (let c = 0; c < 3; ++c) {
      const value = exposure * floats[3 * i + c];
      data[at + c] = value > 0 ? kGamma[Math.min(Math.round(value * kGammaSteps), kGammaSteps)] : 0;
    }
  });
}

// The range of the numbers, but for the hundredth part at its upper end.
function range_of(floats) {
  const numbers = [];
  for (let i = 0; i < floats.length; i += 3) if (Number.isFinite(floats[i])) numbers.push(floats[i]);
  numbers.sort((a, b) => a - b);
  return [numbers[0] ?? 0, numbers[Math.floor(0.99 * (numbers.length - 1))] ?? 0];
}

function paint_numbers(canvas, picture) {
  const [low, high] = range_of(picture.floats);
  paint(canvas, picture.width, picture.height, (i, data, at) => {
    const value = picture.floats[3 * i];
    const color = Number.isFinite(value) ? ramp((value - low) / (high - low || 1)) : [0, 0, 0];
    for (let c = 0; c < 3; ++c) data[at + c] = color[c];
  });
  return [low, high];
}

// Every primitive has a colour of its own.
function paint_primitives(canvas, picture) {
  paint(canvas, picture.width, picture.height, (i, data, at) => {
    const value = picture.floats[3 * i];
    const hash = Math.imul(value + 1, 2654435761) >>> 0;
    for (let c = 0; c < 3; ++c) data[at + c] = Number.isNaN(value) ? 0 : 60 + ((hash >> (8 * c)) & 127) + 60;
  });
}

// The left part of one picture, and the right part of another.
function joined(left, right, part) {
  const floats = right.floats.slice();
  const edge = Math.round(part * right.width);
  for (let y = 0; y < right.height; ++y) {
    const row = 3 * y * right.width;
    floats.set(left.floats.subarray(row, row + 3 * edge), row);
  }
  return { ...left, floats };
}

const luminance_at = (floats, i) =>
  0.2126 * floats[3 * i] + 0.7152 * floats[3 * i + 1] + 0.0722 * floats[3 * i + 2];

// Relative to the right brightness, and for dark pixels to 4 % of the picture's, as ./run compare.
function paint_difference(canvas, a, b) {
  let sum = 0;
  for (let i = 0; i < b.floats.length / 3; ++i) sum += luminance_at(b.floats, i) || 0;
  const dark = 0.04 * 3 * sum / b.floats.length;
  paint(canvas, a.width, a.height, (i, data, at) => {
    const [mine, right] = [luminance_at(a.floats, i), luminance_at(b.floats, i)];
    const color = signed_color(Object.is(mine, right) ? 0 : (mine - right) / (right + dark));
    for (let c = 0; c < 3; ++c) data[at + c] = color[c];
  });
}

function paint_ramp(canvas, color) {
  paint(canvas, 256, 1, (i, data, at) => color(i / 255).forEach((value, c) => { data[at + c] = value; }));
}
