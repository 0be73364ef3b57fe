// 2.1: the tree of build_bvh over discs in the plane, level by level.
live.figure('tree', (figure) => {
  const canvas = figure.canvas(640, 320, 'Discs in the plane, and the boxes of one level of their tree');
  const level = figure.slider('level', 0, 8, 1, 3);
  const leaf = figure.slider('max_leaf', 1, 8, 1, 2);
  figure.button('other discs', () => { ++seed; });
  figure.button('build', () => { growing = 0; });
  const says = figure.says();
  let seed = 1, growing = -1, shown = -1;

  return () => {
    const size = 40, answer = live.ask('tree', size, seed, leaf.value), nodes = answer[0];
    const node = (i) => answer.slice(1 + 3 * size + 7 * i, 8 + 3 * size + 7 * i);
    const depths = new Array(nodes).fill(0);
    for (let i = 0; i < nodes; ++i) {
      const [, , , , left, right, count] = node(i);
      if (count === 0) depths[left] = depths[right] = depths[i] + 1;
    }
    const deepest = Math.max(...depths);
    if (growing >= 0) {
      // One level in half a second.
      growing = shown < 0 ? 0 : growing + (performance.now() - shown) / 500;
      shown = performance.now();
      level.set(Math.min(deepest, Math.floor(growing)));
      if (growing > deepest) growing = shown = -1;
      else figure.redraw();
    }
    const pen = canvas.getContext('2d');
    pen.clearRect(0, 0, 640, 320);
    for (let i = 0; i < size; ++i) {
      const [x, y, radius] = answer.slice(1 + 3 * i, 4 + 3 * i);
      pen.fillStyle = live.color('muted');
      pen.beginPath();
      pen.arc(320 * x, 320 * (1 - y), 320 * radius, 0, 2 * Math.PI);
      pen.fill();
    }
    let boxes = 0, leaves = 0;
    for (let i = 0; i < nodes; ++i) {
      const [x0, y0, x1, y1, , , count] = node(i), is_leaf = count > 0;
      if (depths[i] !== level.value && !(is_leaf && depths[i] < level.value)) continue;
      ++boxes;
      leaves += is_leaf;
      pen.strokeStyle = live.color(is_leaf ? 'good' : 'warm');
      pen.lineWidth = is_leaf ? 1.5 : 2.5;
      pen.strokeRect(320 * x0, 320 * (1 - y1), 320 * (x1 - x0), 320 * (y1 - y0));
    }
    says(`level ${Math.min(level.value, deepest)} of ${deepest}: ${boxes} box${boxes === 1 ? '' : 'es'}, of which ${leaves} ${leaves === 1 ? 'is a leaf' : 'are leaves'}; ${nodes} nodes in all`);
  };
});
