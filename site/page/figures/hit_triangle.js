// 1.3: a ray straight into the picture, at the place of the pointer, and a triangle whose corners can be dragged.
live.figure('hit_triangle', (figure) => {
  const canvas = figure.canvas(640, 360, 'A triangle, coloured by its weights, and a ray that looks into the picture. Arrow keys move the ray.');
  const tilt = figure.slider('depth of the red corner', -1, 1, 0.05, 0, (z) => z.toFixed(2));
  const furthest = figure.slider('t_max', 0, 6, 0.05, 6, (t) => t.toFixed(2));
  const says = figure.says();
  const corners = [[120, 310], [520, 300], [300, 50]];
  let ray = [310, 220], held = null;
  figure.drag(canvas, () => ray, (x, y) => { if (held) corners[corners.indexOf(held)] = held = [x, y]; else ray = [x, y]; }, (x, y) => {
    held = corners.find(([cx, cy]) => Math.hypot(x - cx, y - cy) < 22);
  });

  // The picture is the plane z = 0, 100 units a unit; rays start at z = 3.
  const hit = (x, y) => live.ask('hit_triangle',
    corners.map(([cx, cy], i) => [cx / 100, -cy / 100, i === 0 ? tilt.value : 0]).flat(), x / 100, -y / 100, 3, 0, 0, -1, 0, furthest.value);
  // The corner normals are the axes, so that n is as the weights are.
  const weights = ([, , ...n]) => n.map((part) => part / (n[0] + n[1] + n[2]));
  const coarse = Object.assign(document.createElement('canvas'), { width: 160, height: 90 });

  // The picture is made again only when the triangle or the range has changed.
  let made = '';
  function paint() {
    const wanted = `${corners} ${tilt.value} ${furthest.value}`;
    if (made === wanted) return;
    made = wanted;
    const image = new ImageData(160, 90);
    for (let y = 0; y < 90; ++y) {
      for (let x = 0; x < 160; ++x) {
        const here = hit(x * 4 + 2, y * 4 + 2);
        if (here[0] === 1) image.data.set([...weights(here).map((weight) => 255 * weight), 255], (y * 160 + x) * 4);
      }
    }
    coarse.getContext('2d').putImageData(image, 0, 0);
  }

  return () => {
    paint();
    const pen = canvas.getContext('2d');
    pen.clearRect(0, 0, 640, 360);
    pen.drawImage(coarse, 0, 0, 640, 360);
    corners.forEach(([x, y], i) => {
      const [nx, ny] = corners[(i + 1) % 3];
      live.line(pen, x, y, nx, ny, 'muted', 1);
      live.dot(pen, x, y, 'ink', 7);
      live.text(pen, `p${i}`, x + 10, y - 8);
    });
    const here = hit(...ray);
    live.dot(pen, ...ray, 'card', 8);
    live.dot(pen, ...ray, here[0] === 1 ? 'good' : 'warm', 5);
    says(here[0] === 1 ? `t = ${here[1].toFixed(3)}, weights ${weights(here).map((weight) => weight.toFixed(2)).join(', ')}` : 'no hit');
  };
});
