
// The camera, and lines in the scene.

const plus = (a, b, s = 1) => a.map((value, i) => value + s * b[i]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, s) => a.map((value) => value * s);
const unit = (a) => scaled(a, 1 / Math.hypot(...a));

function turned(v, axis, angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return plus(plus(scaled(v, c), cross(axis, v), s), axis, dot(axis, v) * (1 - c));
}

// An eye of a camera of the file, that can be moved: it looks at the middle of the scene, or near it.
function eye_of(scene) {
  const { camera } = scene;
  const middle = scaled(plus(scene.min, scene.max), 0.5);
  const ahead = Math.max(dot(plus(camera.position, middle, -1), camera.z),
    1e-3 * Math.hypot(...plus(scene.max, scene.min, -1)));
  return { eye: camera.position, target: plus(camera.position, camera.z, -ahead), up: camera.y };
}

// Turns the eye around its target, by angles to the right and up.
function orbit(view, right, up) {
  const back = plus(view.eye, view.target, -1);
  const x = unit(cross(view.up, back));
  const around = turned(back, unit(view.up), -right);
  const over = turned(around, turned(x, unit(view.up), -right), -up);
  // Not over the pole.
  const is_upright = Math.abs(dot(unit(over), unit(view.up))) < 0.998;
  return { ...view, eye: plus(view.target, is_upright ? over : around) };
}

function moved(view, right, up) {
  const back = plus(view.eye, view.target, -1);
  const x = unit(cross(view.up, back));
  const y = unit(cross(back, x));
  const by = plus(scaled(x, right * Math.hypot(...back)), y, up * Math.hypot(...back));
  return { ...view, eye: plus(view.eye, by), target: plus(view.target, by) };
}

function closer(view, factor) {
  return { ...view, eye: plus(view.target, plus(view.eye, view.target, -1), factor) };
}

// Where a point is in the picture, in 0 .. 1 from the top left; null if it is behind the camera.
function project(camera, p) {
  const d = plus(p, camera.position, -1);
  const z = -dot(d, camera.z);
  if (!(z > 1e-9)) return null;
  const half = (degrees) => Math.tan((degrees * Math.PI) / 360);
  return [0.5 + dot(d, camera.x) / (2 * z * half(camera.hfov)),
    0.5 - dot(d, camera.y) / (2 * z * half(camera.vfov))];
}

// The part of a line in front of the camera, projected.
function project_line(camera, a, b) {
  const [za, zb] = [a, b].map((p) => -dot(plus(p, camera.position, -1), camera.z));
  const near = 1e-6 * Math.max(Math.abs(za), Math.abs(zb));
  if (za <= near && zb <= near) return null;
  const cut = (p, q, zp, zq) => (zp > near ? p : plus(p, plus(q, p, -1), (near * 2 - zp) / (zq - zp)));
  const ends = [project(camera, cut(a, b, za, zb)), project(camera, cut(b, a, zb, za))];
  return ends.includes(null) ? null : ends;
}

// Returns whether a surface hides a point from the camera, by its map of distances (none: nothing is hidden). The largest of nine
// neighbours decides, so that a point on a slanted surface is not hidden by it.
function is_hidden(camera, p) {
  const at = camera.depth && project(camera, p);
  if (!at) return false;
  const { width, height, floats } = camera.depth;
  const [x, y] = [Math.floor(at[0] * width), Math.floor(at[1] * height)];
  let most = -1;
  for (let j = Math.max(y - 1, 0); j <= Math.min(y + 1, height - 1); ++j) {
    for (let i = Math.max(x - 1, 0); i <= Math.min(x + 1, width - 1); ++i) most = Math.max(most, floats[j * width + i]);
  }
  return most >= 0 && Math.hypot(...plus(p, camera.position, -1)) > 1.002 * most;
}

// A line in parts that are seen or hidden as a whole: [from, to, whether it is hidden].
function parts_of(camera, a, b, steps) {
  const parts = [];
  for (let i = 0; i < steps; ++i) {
    const at = (k) => plus(a, plus(b, a, -1), k / steps);
    const hidden = is_hidden(camera, at(i + 0.5));
    if (parts.length && parts.at(-1)[2] === hidden) parts.at(-1)[1] = at(i + 1);
    else parts.push([at(i), at(i + 1), hidden]);
  }
  return parts;
}

function draw_ends(context, ends, style, size, dash) {
  const { width, height } = context.canvas;
  context.beginPath();
  context.setLineDash(dash.map((length) => length * pen()));
  context.strokeStyle = style;
  context.lineWidth = size * pen();
  context.moveTo(ends[0][0] * width, ends[0][1] * height);
  context.lineTo(ends[1][0] * width, ends[1][1] * height);
  context.stroke();
}

// What is hidden is thin and has short dashes.
function draw_line(context, camera, a, b, color, dashed = false) {
  for (const [from, to, hidden] of parts_of(camera, a, b, 64)) {
    const ends = project_line(camera, from, to);
    if (!ends) continue;
    const dash = hidden ? [2, 4] : dashed ? [6, 5] : [];
    draw_ends(context, ends, "rgb(0 0 0 / 0.7)", hidden ? 2.5 : 4, dash);
    draw_ends(context, ends, color, hidden ? 1.2 : 2, dash);
  }
}

// The edges of a triangle, or three circles around a sphere.
function draw_shape(context, camera, shape) {
  const edges = [];
  if (shape.length === 3) {
    shape.forEach((corner, i) => edges.push(...parts_of(camera, corner, shape[(i + 1) % 3], 32)));
  } else {
    const [center, radius] = shape;
    const kSteps = 48;
    for (let axis = 0; axis < 3; ++axis) {
      const on_circle = (k) => center.map((value, i) => {
        const angle = (2 * Math.PI * k) / kSteps;
        return value + radius * (i === axis ? 0 : i === (axis + 1) % 3 ? Math.cos(angle) : Math.sin(angle));
      });
      for (let k = 0; k < kSteps; ++k) edges.push(...parts_of(camera, on_circle(k), on_circle(k + 1), 1));
    }
  }
  for (const [from, to, hidden] of edges) {
    const ends = project_line(camera, from, to);
    if (ends) draw_ends(context, ends, hidden ? "rgb(255 255 255 / 0.6)" : "#fff", 1, hidden ? [2, 4] : []);
  }
}

function draw_box(context, camera, [low, high], color, size, dashed = false) {
  const corner = (i) => [0, 1, 2].map((axis) => ((i >> axis) & 1 ? high : low)[axis]);
  context.setLineDash(dashed ? [4, 4] : []);
  context.strokeStyle = color;
  context.lineWidth = size * pen();
  context.beginPath();
  for (let i = 0; i < 8; ++i) {
    for (const bit of [1, 2, 4]) {
      const ends = i & bit ? null : project_line(camera, corner(i), corner(i | bit));
      if (!ends) continue;
      context.moveTo(ends[0][0] * context.canvas.width, ends[0][1] * context.canvas.height);
      context.lineTo(ends[1][0] * context.canvas.width, ends[1][1] * context.canvas.height);
    }
  }
  context.stroke();
}

// The boxes of one level of a tree: left children blue, right ones orange, leaves with thicker lines.
function draw_boxes(context, camera, nodes, level) {
  for (const [low, high, at, side, primitives] of nodes) {
    if (at === level) draw_box(context, camera, [low, high], side ? "#ff9f40" : "#6fb7ff", primitives > 0 ? 2.5 : 1.2);
  }
}

// The boxes that a ray tests, up to one of them: those that were missed are dashed, those that were entered and not opened grey.
function draw_tests(context, camera, ray, count) {
  ray.tests.slice(0, count).forEach((test, i) => {
    const color = !test.t ? "#ff5a4d" : !test.opened ? "#b8b8b8" : test.primitives ? "#ff9f40" : "#6fb7ff";
    draw_box(context, camera, [test.low, test.high], color, i === count - 1 ? 3 : 1.2, !test.t);
  });
  const ends = ray.tests.map((test) => (test.t ? test.t[1] : 0));
  const t = ray.t ?? Math.max(...ends);
  draw_line(context, camera, ray.origin, plus(ray.origin, ray.direction, t), "#ffd84a");
}

// The frame of a point: x red, y green, and z, the normal, blue.
function draw_frame(context, camera, bounce, length) {
  for (const [axis, label, color] of [[bounce.x, "x", "#ff5a4d"], [bounce.y, "y", "#52d273"], [bounce.n, "z", "#6fb7ff"]]) {
    const end = plus(bounce.p, axis, length);
    draw_line(context, camera, bounce.p, end, color);
    draw_label(context, camera, end, label, color);
  }
}

function draw_label(context, camera, p, label, color) {
  const at = project(camera, p);
  if (!at) return;
  const size = pen();
  const [x, y] = [at[0] * context.canvas.width + 6 * size, at[1] * context.canvas.height - 6 * size];
  context.font = `bold ${12 * size}px system-ui, sans-serif`;
  context.setLineDash([]);
  context.lineWidth = 3 * size;
  context.strokeStyle = "#000";
  context.fillStyle = color;
  context.strokeText(label, x, y);
  context.fillText(label, x, y);
}

function draw_point(context, camera, p, label) {
  const at = project(camera, p);
  if (!at) return;
  const [x, y] = [at[0] * context.canvas.width, at[1] * context.canvas.height];
  const size = pen();
  context.beginPath();
  context.setLineDash([]);
  context.arc(x, y, 4 * size, 0, 7);
  context.fillStyle = "#ffd84a";
  context.strokeStyle = "#000";
  context.lineWidth = size;
  context.fill();
  context.stroke();
  draw_label(context, camera, p, label, "#ffd84a");
}

// A path from its first point on, with the surfaces that it meets and the directions in which it looked for light. `size` is
// that of the scene.
function draw_path(context, camera, path, shapes, size) {
  const { bounces } = path;
  for (const { primitive } of bounces) if (shapes[primitive]) draw_shape(context, camera, shapes[primitive]);
  bounces.forEach((bounce, i) => {
    for (const draw of bounce.direct ? bounce.direct.draws : []) {
      if (!draw.traced) continue;
      const far = typeof draw.distance === "number" ? draw.distance : size;
      const is_dark = draw.hidden || (draw.light < 0 && draw.radiance.every((c) => c === 0));
      draw_line(context, camera, bounce.p, plus(bounce.p, draw.wi, far), is_dark ? "#ff5a4d" : "#52d273", is_dark);
    }
    const after = bounces[i + 1];
    if (after) draw_line(context, camera, bounce.p, after.p, "#ffd84a");
    else if (bounce.way) draw_line(context, camera, bounce.p, plus(bounce.p, bounce.way, 0.3 * size), "#ffd84a", true);
  });
  bounces.forEach((bounce, i) => draw_point(context, camera, bounce.p, String(i + 1)));
}
