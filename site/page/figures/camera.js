// 1.2: the ray of a place in the picture, and the window from above.
live.figure('camera', (figure) => {
  const canvas = figure.canvas(640, 330, 'A picture with a place in it, and its ray through the window, from above. Arrow keys move the place.');
  const hfov = figure.slider('hfov', 20, 140, 1, 50, (degrees) => `${degrees}°`);
  const vfov = figure.slider('vfov', 20, 120, 1, 38, (degrees) => `${degrees}°`);
  const says = figure.says();
  let place = [0.8, 0.7];
  const picture = { left: 10, top: 30, width: 270, height: 200 };
  const limit = (value) => Math.min(1, Math.max(0, value));
  figure.drag(canvas, () => [picture.left + place[0] * picture.width, picture.top + (1 - place[1]) * picture.height], (x, y) => {
    place = [limit((x - picture.left) / picture.width), 1 - limit((y - picture.top) / picture.height)];
  });
  const ask = (x, y) => [...live.ask('camera_ray', hfov.value, vfov.value, x, y)].slice(3);

  return () => {
    const pen = canvas.getContext('2d'), { left, top, width, height } = picture;
    pen.clearRect(0, 0, 640, 330);
    pen.fillStyle = live.color('soft');
    pen.fillRect(left, top, width, height);
    pen.strokeStyle = live.color('muted');
    pen.lineWidth = 1;
    pen.strokeRect(left, top, width, height);
    live.text(pen, 'the picture', left, 20, 'muted');
    live.text(pen, '(0, 0)', left, top + height + 18, 'muted');
    live.text(pen, '(1, 1)', left + width, 20, 'muted', 'right');
    live.dot(pen, left + place[0] * width, top + (1 - place[1]) * height, 'warm', 6);
    // From above: the camera at the bottom, -z upwards, the window at a distance of 1.
    const eye = [470, 300], unit = 150;
    const edges = [ask(0, 0.5), ask(1, 0.5)], ray = ask(...place);
    const at = ([x, , z], far) => [eye[0] + unit * far * x / -z, eye[1] - unit * far];
    pen.save();
    pen.beginPath();
    pen.rect(300, 0, 340, 330);
    pen.clip();
    for (const edge of edges) live.line(pen, ...eye, ...at(edge, 2.2), 'line', 2);
    live.line(pen, ...at(edges[0], 1), ...at(edges[1], 1), 'cool', 4);
    live.line(pen, ...eye, ...at(ray, 2.2), 'warm', 2.5);
    live.dot(pen, ...at(ray, 1), 'warm', 6);
    live.dot(pen, ...eye, 'ink', 6);
    pen.restore();
    live.text(pen, 'from above: the window is at z = -1', 640, 325, 'muted', 'right');
    const [x, y, z] = ray.map((part) => part.toFixed(3));
    says(`(${place.map((part) => part.toFixed(2)).join(', ')}): unit direction (${x}, ${y}, ${z}); at z = -1 it is (${(ray[0] / -ray[2]).toFixed(3)}, ${(ray[1] / -ray[2]).toFixed(3)})`);
  };
});
