// The front page: a box with two spheres that becomes better while one reads.
live.figure('box', (figure) => {
  const canvas = figure.canvas(640, 480, 'A box with two spheres, rendered while you watch. Arrow keys turn it.');
  const samples = figure.slider('samples of the lamp', 1, 16, 1, 1);
  const bounces = figure.slider('bounces', 0, 8, 1, 5);
  const says = figure.says();
  let yaw = 0, pitch = 0, from = [0, 0], is_moving = 0;

  const rows = (width, height) => (row, count, sample) => live.ask('rows',
    live.view({ yaw, pitch, width, height, to: bounces.value, lights: samples.value }), 1, sample, row, count);
  const coarse = new live.Growing(64, 48, rows(64, 48)), fine = new live.Growing(320, 240, rows(320, 240));

  figure.drag(canvas, () => from, (x, y) => {
    yaw -= (x - from[0]) / 180;
    pitch = Math.min(0.6, Math.max(-0.4, pitch + (y - from[1]) / 180));
    from = [x, y];
    is_moving = performance.now();
    figure.redraw(true);
  }, (x, y) => { from = [x, y]; });
  let is_seen = true;
  new IntersectionObserver(([entry]) => { is_seen = entry.isIntersecting; if (is_seen) figure.redraw(); }).observe(canvas);

  return (changed) => {
    if (changed) {
      coarse.restart();
      fine.restart();
    }
    // A coarse picture while something moves, so that it follows the hand.
    const shown = performance.now() - is_moving < 250 || changed ? coarse : fine;
    shown.work(15);
    const pen = canvas.getContext('2d');
    pen.imageSmoothingEnabled = shown === coarse;
    pen.drawImage(shown.canvas, 0, 0, 640, 480);
    says(`${shown.samples} sample${shown.samples === 1 ? '' : 's'} per pixel, ${shown.width} x ${shown.height} pixels`);
    if (is_seen && fine.samples < 256) figure.redraw();
  };
});
