// 3: a density drawn by hand over g(x) = x^2, and the samples g / p that it gives.
live.figure('density', (figure) => {
  const canvas = figure.canvas(640, 430, 'A density as bars, drawn by hand, over the curve of g, and the running mean. Arrow keys choose a bar and change it.');
  const number = figure.slider('samples', 10, 1000, 10, 200);
  const bars = 32, heights = new Array(bars).fill(0.5);
  figure.button('all the same', () => heights.fill(0.5));
  figure.button('as high as g', () => heights.forEach((_, i) => { heights[i] = ((i + 0.5) / bars) ** 2; }));
  const says = figure.says();
  const left = 20, width = 600, floor = 230, height = 210;
  let last = 16;
  figure.drag(canvas, () => [left + (last + 0.5) / bars * width, floor - heights[last] * height], (x, y) => {
    const bar = Math.min(bars - 1, Math.max(0, Math.floor((x - left) / width * bars)));
    const value = Math.min(1, Math.max(0, (floor - y) / height));
    // A fast hand skips no bar.
    for (let i = Math.min(last, bar); i <= Math.max(last, bar); ++i) if (Math.abs(last - bar) < 6 || i === bar) heights[i] = value;
    last = bar;
  }, (x) => { last = Math.min(bars - 1, Math.max(0, Math.floor((x - left) / width * bars))); });

  return () => {
    const answer = live.ask('density', bars, heights, number.value, 1), samples = answer.filter((_, i) => i % 2 === 1);
    const pen = canvas.getContext('2d');
    pen.clearRect(0, 0, 640, 430);
    pen.fillStyle = live.color('line');
    heights.forEach((each, i) => pen.fillRect(left + i / bars * width, floor - each * height, width / bars - 2, each * height));
    live.line(pen, left, floor, left + width, floor, 'muted', 1);
    for (let i = 0; i < 60; ++i) live.line(pen, left + i * 10, floor - (i / 60) ** 2 * height, left + (i + 1) * 10, floor - ((i + 1) / 60) ** 2 * height, 'warm', 2);
    for (let i = 0; i < Math.min(200, answer.length / 2); ++i) live.dot(pen, left + width * answer[2 * i], floor + 8, 'cool', 2);
    const end = 410, scale = 150;  // a mean of 1 is that high
    live.line(pen, left, end - scale / 3, left + width, end - scale / 3, 'good', 1);
    live.text(pen, '1/3', left + width, end - scale / 3 - 5, 'good', 'right');
    live.line(pen, left, end, left + width, end, 'line', 1);
    live.text(pen, 'running mean of g / p', left, 262, 'muted');
    live.running_mean(pen, samples, left, width, (mean) => end - scale * Math.min(1, mean), 'cool');
    const { mean, deviation } = live.statistics(samples);
    const is_blind = heights.some((each, i) => each === 0 && i > 0);
    says(samples.length === 0 ? 'All bars are 0.'
      : `mean ${mean.toFixed(3)}, standard deviation of a sample ${deviation.toFixed(3)}${is_blind ? '; where p is 0, g is never counted' : ''}`);
  };
});
