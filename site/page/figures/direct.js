// 3: direct light by hemisphere sampling and by light sampling: two pictures, and the running mean at one point.
live.figure('direct', (figure) => {
  const canvas = figure.canvas(640, 440, 'Two pictures of one room, and the running means at a point. Arrow keys move the point.');
  const lamp = figure.slider('side of the lamp', 0.05, 1.8, 0.05, 0.6, (side) => side.toFixed(2));
  const number = figure.slider('samples', 1, 500, 1, 100);
  const says = figure.says();
  const width = 160, height = 120, shown = [310, 232];  // a picture, and its size here
  let point = [0.5, 0.12];
  const growing = [1, 0].map((hemisphere) => new live.Growing(width, height, (row, rows, sample) => live.ask('rows',
    live.view({ lamp: lamp.value, width, height, from: 1, to: 1, hemisphere }), 1, sample, row, rows)));
  const place = () => [point[0] * shown[0], (1 - point[1]) * shown[1]];
  figure.drag(canvas, place, (x, y) => {
    if (x > 330) x -= 330;
    point = [Math.min(1, Math.max(0, x / shown[0])), 1 - Math.min(1, Math.max(0, y / shown[1]))];
  });

  return (changed) => {
    const pen = canvas.getContext('2d');
    pen.clearRect(0, 0, 640, 440);
    growing.forEach((picture, i) => {
      if (changed && picture.lamp !== lamp.value) picture.restart();
      picture.lamp = lamp.value;
      // As many samples as the slider says; a picture of more has to begin again.
      if (picture.samples > number.value) picture.restart();
      if (picture.samples < number.value) picture.work(12);
      pen.drawImage(picture.canvas, 330 * i, 0, ...shown);
      live.text(pen, `${['hemisphere', 'light'][i]} sampling, ${picture.samples} per pixel`, 330 * i, shown[1] + 18);
      const [x, y] = place();
      live.dot(pen, 330 * i + x, y, 'card', 6);
      live.dot(pen, 330 * i + x, y, i === 0 ? 'warm' : 'cool', 4);
    });
    const [found, ...all] = live.ask('direct', live.view({ lamp: lamp.value, width, height, to: 1 }), ...point, number.value, 1);
    if (found !== 1) {
      says('The point is outside the room.');
    } else {
      const lists = [all.slice(0, number.value), all.slice(number.value)];
      const [hemisphere, light] = lists.map((list) => live.statistics(list)), top = 2.5 * Math.max(light.mean, 1e-6);
      live.line(pen, 40, 420, 620, 420, 'line', 1);
      lists.forEach((list, i) => live.running_mean(pen, list, 40, 580, (mean) => 420 - 145 * Math.min(1, mean / top), ['warm', 'cool'][i]));
      live.text(pen, 'running mean at the point', 40, 272, 'muted');
      live.text(pen, `${number.value} samples`, 620, 437, 'muted', 'right');
      // One sample says nothing of its noise.
      const told = ({ mean, deviation }) => mean.toFixed(3) + (number.value > 1 ? ` ± ${(deviation / Math.sqrt(number.value)).toFixed(3)}` : '');
      says(`hemisphere ${told(hemisphere)}, light ${told(light)}`);
    }
    if (growing.some((picture) => picture.samples < number.value)) figure.redraw();
  };
});
