#include "pt/tasks/hit_box.h"

#include "pt/examples/example.h"

using namespace pt;

const Box cube{{-1, -1, -1}, {1, 1, 1}};

EXAMPLE("straight through") {
  const auto inside = hit_box(cube, {{0.1, 0.2, 5}, {0, 0, -1}});
  EXPECT(inside);
  NEAR(inside->min, 4);
  NEAR(inside->max, 6);
}

EXAMPLE("begins inside") {}

EXAMPLE("passes beside the box") {}

EXAMPLE("ends before the box") {}
