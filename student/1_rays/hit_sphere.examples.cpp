#include "pt/tasks/hit_sphere.h"

#include "pt/examples/example.h"

using namespace pt;

EXAMPLE("from outside: the near side") {
  const auto hit = hit_sphere({{0, 0, 0}, 1}, {{0, 0, 3}, {0, 0, -1}});
  EXPECT(hit);
  NEAR(hit->t, 2);
  NEAR(hit->n, {0, 0, 1});
}

EXAMPLE("begins inside the sphere") {}

EXAMPLE("points away from the sphere") {}

EXAMPLE("a direction of length 2") {}
