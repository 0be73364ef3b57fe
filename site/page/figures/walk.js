// 2.3: a ray through the tree: the boxes that hit_bvh tests.
live.figure('walk', (figure) => {
  const canvas = figure.canvas(640, 320, 'Discs in the plane, a ray, and the boxes that it is tested against. Arrow keys move the end of the ray.');
  const leaf = figure.slider('max_leaf', 1, 8, 1, 2);
  const step = figure.slider('tests shown', 0, 80, 1, 80, (tests) => (tests === 80 ? 'all' : tests));
  figure.button('other discs', () => { ++seed; });
  const says = figure.says();
  const size = 40;
  let seed = 1, from = [30, 290], to = [200, 200], held = 'to';
  figure.drag(canvas, () => to, (x, y) => { if (held === 'from') from = [x, y]; else to = [x, y]; }, (x, y) => {
    held = Math.hypot(x - from[0], y - from[1]) < 25 ? 'from' : 'to';
  });

  return () => {
    const tree = live.ask('tree', size, seed, leaf.value);
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
    const unit = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
    const [primitive, t, tested, ...boxes] = live.ask('walk', size, seed, leaf.value,
      from[0] / 320, 1 - from[1] / 320, 0, unit[0], -unit[1], 0, 0, 4);
    const pen = canvas.getContext('2d');
    pen.clearRect(0, 0, 640, 320);
    for (let i = 0; i < size; ++i) {
      const [x, y, radius] = tree.slice(1 + 3 * i, 4 + 3 * i);
      pen.fillStyle = live.color(i === primitive ? 'good' : 'muted');
      pen.beginPath();
      pen.arc(320 * x, 320 * (1 - y), 320 * radius, 0, 2 * Math.PI);
      pen.fill();
    }
    const count = boxes.length / 4, shown = step.value === 80 ? count : Math.min(count, step.value);
    for (let i = 0; i < shown; ++i) {
      const [x0, y0, x1, y1] = boxes.slice(4 * i, 4 * i + 4);
      pen.strokeStyle = live.color(i === shown - 1 ? 'warm' : 'cool');
      pen.lineWidth = i === shown - 1 ? 3 : 1.2;
      pen.strokeRect(320 * x0, 320 * (1 - y1), 320 * (x1 - x0), 320 * (y1 - y0));
    }
    const end = primitive >= 0 ? 320 * t : 1000;
    live.line(pen, ...from, from[0] + end * unit[0], from[1] + end * unit[1], 'ink', 2);
    live.dot(pen, ...from, 'ink', 7);
    live.dot(pen, ...to, 'muted', 6);
    says(`${count} boxes and ${tested} discs were tested; without a tree, all ${size} discs. `
      + (primitive >= 0 ? `Nearest hit: t = ${t.toFixed(3)}, disc ${primitive}` : 'No hit'));
  };
});
