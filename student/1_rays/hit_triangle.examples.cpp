#include "pt/tasks/hit_triangle.h"

#include "pt/examples/example.h"

using namespace pt;

// In the plane z = 0, with its normal along z.
const Triangle corner = flat_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});

EXAMPLE("from the front") {
  const auto hit = hit_triangle(corner, {{0.2, 0.3, 5}, {0, 0, -1}});
  EXPECT(hit);
  NEAR(hit->t, 5);
  NEAR(hit->n, {0, 0, 1});
}

EXAMPLE("from behind") {}

EXAMPLE("beyond the long edge") {}

EXAMPLE("near one corner, with three different normals") {}
