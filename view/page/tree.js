
// The boxes of the tree, and those that a ray tests.

async function show_tree() {
  if (now.tree) {
    now.tree = null;
  } else {
    try {
      now.tree = await ask("tree", query());
      now.other_tree = data.reference ? await ask("tree", { ...query(), from: "reference" }) : null;
    } catch {
      now.tree = null;  // the banner has said why
    }
  }
  by_id("tree").hidden = !now.tree;
  if (now.tree) by_id("level").max = now.tree.depth;
  await find_ray();
  show_level(0);
}

// The ray through the middle of the pixel, while the tree is shown. A page without a server has it from the start.
async function find_ray() {
  if (data.live) now.ray = null;
  try {
    if (now.tree && now.pixel) now.ray = await ask("ray", query_of_pixel());
  } catch {
    now.ray = null;  // the banner has said why
  }
  by_id("ray").hidden = !now.ray || now.ray.tests.length === 0;
  by_id("test").max = now.ray ? now.ray.tests.length : 0;
  show_test(-Number(by_id("test").value));
}

function says_of(test) {
  const level = test.level === undefined ? "not a box of the tree" : `level ${test.level}`;
  if (!test.t) return `${level}, missed`;
  const between = `${level}, t ${shown(test.t[0])} to ${shown(test.t[1])}`;
  if (!test.opened) return `${between}, not opened`;
  const met = ([primitive, t]) => `${primitive} ${t === null ? "missed" : `at t ${shown(t)}`}`;
  return test.primitives ? `${between}, primitives ${test.primitives.map(met).join(", ")}` : `${between}, opened`;
}

function show_test(step) {
  if (now.ray) {
    const { tests, boxes, primitives } = now.ray;
    by_id("test").value = Number(by_id("test").value) + step;
    const count = Number(by_id("test").value);
    by_id("test_says").textContent = count > 0 ? `${count} of ${boxes}: ${says_of(tests[count - 1])}`
      : `${boxes} boxes and ${primitives} primitives for the ray through the middle of the pixel`;
  }
  show_lines();
}

function show_level(step) {
  if (now.tree) {
    by_id("level").value = Number(by_id("level").value) + step;
    const says = (tree) => `${tree.count} nodes, ${tree.depth + 1} levels, ${tree.leaves} leaves of at most ${tree.largest}; `
      + `by areas ${shown(tree.boxes)} boxes and ${shown(tree.primitives)} primitives per ray`;
    const beside = now.other_tree ? `. The reference: ${says(now.other_tree)}` : "";
    by_id("level_says").textContent = `${by_id("level").value}: ${says(now.tree)}${beside}`;
  }
  show_lines();
}
