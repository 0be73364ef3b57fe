// 2.2: a ray at a box, and its three intervals as bars.
live.figure('hit_box', (figure) => {
  const canvas = figure.canvas(640, 420, 'A box from above with a ray, and three intervals as bars. Arrow keys move the end of the ray.');
  const rise = figure.slider('rise of the ray in z', -0.6, 0.6, 0.02, 0.1, (z) => z.toFixed(2));
  const furthest = figure.slider('t_max', 0, 8, 0.1, 8, (t) => t.toFixed(1));
  const says = figure.says();
  let from = [60, 60], to = [200, 105], held = 'to';
  figure.drag(canvas, () => to, (x, y) => { y = Math.min(y, 265); if (held === 'from') from = [x, y]; else to = [x, y]; }, (x, y) => {
    held = Math.hypot(x - from[0], y - from[1]) < 25 ? 'from' : 'to';
  });
  const min = [2.6, -2.1, -0.5], max = [4.6, -0.9, 0.5], far = 1e6;
  const left = 90, right = 620, scale = (right - left) / 8;  // of the bars, for t from 0 to 8

  return () => {
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
    const unit = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
    const ray = (t_max) => [from[0] / 100, -from[1] / 100, 0, unit[0], -unit[1], rise.value, 0, t_max];
    const all = live.ask('hit_box', min, max, ray(furthest.value));
    const pen = canvas.getContext('2d');
    pen.clearRect(0, 0, 640, 420);
    pen.fillStyle = live.color('soft');
    pen.strokeStyle = live.color('muted');
    pen.lineWidth = 2;
    pen.fillRect(100 * min[0], -100 * max[1], 200, 120);
    pen.strokeRect(100 * min[0], -100 * max[1], 200, 120);
    const at = (t) => [from[0] + 100 * t * unit[0], from[1] + 100 * t * unit[1]];
    pen.save();
    pen.beginPath();
    pen.rect(0, 0, 640, 275);
    pen.clip();
    live.line(pen, ...from, ...at(furthest.value), 'line', 2);
    if (all[0] === 1) live.line(pen, ...at(all[1]), ...at(all[2]), 'good', 5);
    live.dot(pen, ...from, 'ink', 7);
    live.dot(pen, ...to, 'muted', 7);
    pen.restore();
    // Of each axis: the box is far larger in the two others.
    const bar = (y, name, interval, colour) => {
      live.text(pen, name, left - 12, y + 12, 'ink', 'right');
      live.line(pen, left, y + 8, right, y + 8, 'line', 1);
      if (interval[0] !== 1) return;
      const [begin, end] = [interval[1], interval[2]].map((t) => left + scale * Math.min(8, t));
      pen.fillStyle = live.color(colour);
      pen.fillRect(begin, y, Math.max(2, end - begin), 16);
    };
    ['x', 'y', 'z'].forEach((name, axis) => bar(290 + 26 * axis, name, live.ask('hit_box',
      min.map((low, i) => (i === axis ? low : -far)), max.map((high, i) => (i === axis ? high : far)), ray(furthest.value)), 'cool'));
    bar(376, 'all three', all, 'good');
    live.text(pen, 't = 0', left, 412, 'muted');
    live.text(pen, '8', right, 412, 'muted', 'right');
    live.ask('hit_box', min, max, ray(furthest.value));
    says(all[0] === 1 ? `inside from t = ${all[1].toFixed(3)} to ${all[2].toFixed(3)}` : 'no t is in all three: the ray misses the box');
  };
});
