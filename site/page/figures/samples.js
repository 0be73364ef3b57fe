// 1.1: the samples of one pixel that an edge crosses.
live.figure('samples', (figure) => {
  const canvas = figure.canvas(640, 330, 'A coarse picture, one pixel of it with its samples, and their mean. Arrow keys choose the pixel.');
  const number = figure.slider('samples', 1, 64, 1, 8);
  figure.button('other random numbers', () => { ++seed; });
  const says = figure.says();
  const width = 16, height = 12, cell = 20;
  let seed = 1, pixel = [4, 5], picture = null;
  const view = () => live.view({ width, height, to: 1, normals: 1 });
  figure.drag(canvas, () => [(pixel[0] + 0.5) * cell, (height - pixel[1] - 0.5) * cell], (x, y) => {
    const limit = (value, size) => Math.min(size - 1, Math.max(0, Math.floor(value)));
    // An arrow key moves by less than a pixel.
    const here = [limit(x / cell, width), limit(height - y / cell, height)];
    if (here[0] === pixel[0] && here[1] === pixel[1]) {
      const middle = [(pixel[0] + 0.5) * cell, (height - pixel[1] - 0.5) * cell];
      here[0] = limit(pixel[0] + (x > middle[0] + 10 ? 1 : 0), width);
    }
    pixel = here;
  });

  return (changed) => {
    if (changed || !picture) picture = live.ask('rows', view(), number.value, seed, 0, height);
    const answer = live.ask('pixel', view(), ...pixel, number.value, seed);
    const pen = canvas.getContext('2d'), left = 350, size = 240, rgb = (r, g, b) => `rgb(${[r, g, b].map((c) => Math.round(255 * c)).join(' ')})`;
    pen.clearRect(0, 0, 640, 330);
    for (let y = 0; y < height; ++y) {
      for (let x = 0; x < width; ++x) {
        const at = 3 * (y * width + x);
        pen.fillStyle = rgb(...picture.slice(at, at + 3));
        pen.fillRect(x * cell, (height - 1 - y) * cell, cell, cell);
      }
    }
    pen.strokeStyle = live.color('warm');
    pen.lineWidth = 3;
    pen.strokeRect(pixel[0] * cell, (height - 1 - pixel[1]) * cell, cell, cell);
    pen.fillStyle = live.color('soft');
    pen.fillRect(left, 0, size, size);
    for (let i = 3; i < answer.length; i += 5) {
      const [x, y, ...color] = answer.slice(i, i + 5);
      live.dot(pen, left + size * x, size * (1 - y), 'ink', 7);
      pen.fillStyle = rgb(...color);
      pen.beginPath();
      pen.arc(left + size * x, size * (1 - y), 6, 0, 2 * Math.PI);
      pen.fill();
    }
    pen.strokeStyle = live.color('muted');
    pen.lineWidth = 1;
    pen.strokeRect(left, 0, size, size);
    pen.fillStyle = rgb(...answer.slice(0, 3));
    pen.fillRect(left, size + 12, size, 40);
    live.text(pen, 'the mean is the colour of the pixel', left, size + 72, 'muted');
    says(`pixel (${pixel.join(', ')}): mean of ${number.value} sample${number.value > 1 ? 's' : ''} = (${[...answer.slice(0, 3)].map((c) => c.toFixed(3)).join(', ')})`);
  };
});
