// 4: one path in the box, bounce by bounce, and what survival does to the mean and its noise.
live.figure('path', (figure) => {
  const canvas = figure.canvas(640, 480, 'A room, and one path of light in it. Arrow keys move its start.');
  const survival = figure.slider('survival', 0.1, 1, 0.05, 0.7, (chance) => chance.toFixed(2));
  const bounces = figure.slider('bounces at most', 1, 20, 1, 12);
  figure.button('another path', () => { ++seed; });
  const says = figure.says();
  const number = 2000;
  let seed = 7, place = [0.35, 0.2], numbers = '';
  const room = new live.Growing(320, 240, (row, rows, sample) => live.ask('rows', live.view({ width: 320, height: 240 }), 1, sample, row, rows));
  const limit = (value) => Math.min(0.999, Math.max(0, value));
  figure.drag(canvas, () => [place[0] * 640, (1 - place[1]) * 480], (x, y) => { place = [limit(x / 640), limit(1 - y / 480)]; });

  return () => {
    if (room.samples < 32) room.work(15);
    const view = live.view({ width: 320, height: 240, to: bounces.value, survival: survival.value });
    const path = live.ask('path', view, ...place, seed), points = [];
    for (let i = 3; i < path.length; i += 2) points.push([640 * path[i], 480 * (1 - path[i + 1])]);
    const pen = canvas.getContext('2d');
    pen.drawImage(room.canvas, 0, 0, 640, 480);
    for (const [width, style] of [[5, '#000'], [2.5, '#ffd34d']]) {
      pen.strokeStyle = style;
      pen.lineWidth = width;
      pen.beginPath();
      points.forEach((point) => pen.lineTo(...point));
      pen.stroke();
    }
    points.forEach(([x, y], i) => {
      pen.fillStyle = '#000';
      pen.beginPath();
      pen.arc(x, y, 10, 0, 2 * Math.PI);
      pen.fill();
      pen.fillStyle = '#ffd34d';
      pen.font = '14px system-ui, sans-serif';
      pen.textAlign = 'center';
      pen.fillText(i + 1, x, y + 5);
    });
    // While nothing is dragged: many samples of the same pixel.
    const wanted = `${place} ${survival.value} ${bounces.value}`;
    if (wanted !== numbers) {
      numbers = wanted;
      const list = live.ask('samples', view, Math.floor(place[0] * 320), Math.floor(place[1] * 240), number, 1);
      const { mean, deviation } = live.statistics(list);
      figure.numbers = `${number} samples of this pixel: mean ${mean.toFixed(3)} ± ${(deviation / Math.sqrt(number)).toFixed(3)}, standard deviation of one sample ${deviation.toFixed(2)}`;
    }
    says(`This path has ${points.length} point${points.length === 1 ? '' : 's'}. ${figure.numbers}`);
    if (room.samples < 32) figure.redraw();
  };
});
