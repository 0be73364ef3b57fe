// 1.4: a ray in the plane through the middle of a sphere.
live.figure('hit_sphere', (figure) => {
  const canvas = figure.canvas(640, 360, 'A sphere and a ray whose end can be dragged. Arrow keys move the end.');
  const nearest = figure.slider('t_min', 0, 6, 0.05, 0, (t) => t.toFixed(2));
  const furthest = figure.slider('t_max', 0, 6, 0.05, 6, (t) => t.toFixed(2));
  const says = figure.says();
  let from = [70, 250], to = [240, 215], held = 'to';
  figure.drag(canvas, () => to, (x, y) => { if (held === 'from') from = [x, y]; else to = [x, y]; }, (x, y) => {
    held = Math.hypot(x - from[0], y - from[1]) < 25 ? 'from' : 'to';
  });
  const hit = (direction, t_min, t_max) => live.ask('hit_sphere', 3.6, -1.8, 0, 1.2, from[0] / 100, -from[1] / 100, 0, direction, t_min, t_max);

  return () => {
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
    const unit = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
    const direction = [unit[0], -unit[1], 0];
    const at = (t) => [from[0] + 100 * t * unit[0], from[1] + 100 * t * unit[1]];
    // Both places, without a range: the second one is behind the first.
    const first = hit(direction, 0, 100), second = first[0] === 1 ? hit(direction, first[1] + 1e-9, 100) : [0];
    const here = hit(direction, nearest.value, furthest.value);
    const pen = canvas.getContext('2d');
    pen.clearRect(0, 0, 640, 360);
    pen.fillStyle = live.color('soft');
    pen.strokeStyle = live.color('muted');
    pen.lineWidth = 2;
    pen.beginPath();
    pen.arc(360, 180, 120, 0, 2 * Math.PI);
    pen.fill();
    pen.stroke();
    live.line(pen, ...from, ...at(10), 'line', 2);
    if (nearest.value <= furthest.value) live.line(pen, ...at(nearest.value), ...at(furthest.value), 'cool', 4);
    live.dot(pen, ...from, 'ink', 7);
    live.dot(pen, ...to, 'muted', 7);
    [first, second].forEach((place, i) => {
      if (place[0] !== 1) return;
      live.dot(pen, ...at(place[1]), 'muted', 5);
      live.text(pen, `t${first[1] > 0 && second[0] === 1 ? i + 1 : ''} = ${place[1].toFixed(2)}`, at(place[1])[0] + 10, at(place[1])[1] + 20);
    });
    if (here[0] === 1) {
      const [x, y] = at(here[1]);
      live.line(pen, x, y, x + 50 * here[2], y - 50 * here[3], 'good', 3);
      live.dot(pen, x, y, 'good', 7);
    }
    says(here[0] === 1 ? `hit_sphere: t = ${here[1].toFixed(3)}, n = (${here[2].toFixed(2)}, ${here[3].toFixed(2)}, ${here[4].toFixed(2)})`
      : 'hit_sphere: no hit in the range');
  };
});
