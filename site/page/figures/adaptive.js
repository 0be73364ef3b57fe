// 5: the samples of a pixel, their mean and its interval, until the tolerance is reached; the picture and the map of samples.
live.figure('adaptive', (figure) => {
  const canvas = figure.canvas(640, 460, 'A picture, the map of its samples, and the interval of one pixel against its samples. Arrow keys choose the pixel.');
  const tolerance = figure.slider('tolerance', 0.02, 0.3, 0.01, 0.1, (part) => part.toFixed(2));
  const batch = figure.slider('batch', 4, 64, 4, 16);
  const says = figure.says();
  const width = 96, height = 72, most = 512, shown = [310, 232];
  let pixel = [50, 20], next = 0, made = '';
  const [picture, map] = [0, 1].map(() => Object.assign(document.createElement('canvas'), { width, height }));
  const limit = (value, size) => Math.min(size - 1, Math.max(0, Math.floor(value)));
  figure.drag(canvas, () => [(pixel[0] + 0.5) / width * shown[0], (1 - (pixel[1] + 0.5) / height) * shown[1]], (x, y) => {
    if (x > 330) x -= 330;
    pixel = [limit(x / shown[0] * width, width), limit((1 - y / shown[1]) * height, height)];
  });
  const view = () => live.view({ width, height });
  const settings = () => [most, batch.value, tolerance.value, 1];

  // Eight pixels of a row.
  function addPixels() {
    const pixels = live.ask('adaptive', view(), ...settings(), next, 8), images = [new ImageData(8, 1), new ImageData(8, 1)];
    for (let x = 0; x < 8; ++x) {
      const [r, g, b, samples] = pixels.slice(4 * x, 4 * x + 4), part = samples / most;
      images[0].data.set([r, g, b].map(live.shade).concat(255), 4 * x);
      images[1].data.set([255 * Math.min(1, 2 * part), 255 * Math.min(1, 2 - 2 * part), 60, 255], 4 * x);
    }
    [picture, map].forEach((each, i) => each.getContext('2d').putImageData(images[i], next % width, height - 1 - Math.floor(next / width)));
    next += 8;
  }

  function drawInterval(pen, list, stop) {
    let mean = 0, squares = 0;
    const points = list.map((value, i) => {
      const distance = value - mean;
      mean += distance / (i + 1);
      squares += distance * (value - mean);
      return [mean, i > 0 ? 1.96 * Math.sqrt(squares / i / (i + 1)) : 0];
    });
    const end = points[points.length - 1][0], top = Math.max(2 * end, 1e-6);
    const x = (i) => 40 + 580 * i / Math.max(stop * 1.25, 32), y = (value) => 430 - 150 * Math.min(1, Math.max(0, value / top));
    pen.fillStyle = live.color('line');
    pen.beginPath();
    points.forEach(([m, half], i) => i > 0 && pen.lineTo(x(i + 1), y(m + half)));
    points.slice(1).reverse().forEach(([m, half], i) => pen.lineTo(x(points.length - i), y(m - half)));
    pen.fill();
    points.slice(1).forEach(([m], i) => i > 0 && live.line(pen, x(i + 1), y(points[i][0]), x(i + 2), y(m), 'cool', 2));
    live.line(pen, x(stop), 275, x(stop), 430, 'good', 2);
    live.text(pen, `stops after ${stop}`, x(stop) - 6, 288, 'good', 'right');
    live.line(pen, 40, 430, 620, 430, 'line', 1);
    live.text(pen, 'mean and interval against samples', 40, 450, 'muted');
    return points[stop - 1];
  }

  return () => {
    if (made !== `${settings()}`) {
      made = `${settings()}`;
      next = 0;
    }
    const end = performance.now() + 15;
    while (next < width * height && performance.now() < end) addPixels();
    const pen = canvas.getContext('2d');
    pen.clearRect(0, 0, 640, 460);
    [picture, map].forEach((each, i) => {
      pen.drawImage(each, 330 * i, 0, ...shown);
      live.text(pen, ['the picture', `its samples: green few, red ${most}`][i], 330 * i, shown[1] + 18);
      pen.strokeStyle = live.color('cool');
      pen.lineWidth = 3;
      pen.strokeRect(330 * i + pixel[0] / width * shown[0] - 4, (1 - (pixel[1] + 1) / height) * shown[1] - 4, 12, 12);
    });
    const stop = live.ask('adaptive', view(), ...settings(), pixel[1] * width + pixel[0], 1)[3];
    const list = [...live.ask('samples', view(), ...pixel, stop, 1)];
    const [mean, half] = drawInterval(pen, list, stop);
    says(`pixel (${pixel.join(', ')}): ${stop} samples, mean ${mean.toFixed(3)} ± ${half.toFixed(3)}`
      + (mean > 0 ? `, ${(100 * half / mean).toFixed(0)}% of it` : ', no light'));
    if (next < width * height) figure.redraw();
  };
});
