#pragma once

#include "pt/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pt {

// The surfaces in one place, and what they became.
struct Twins {
  std::size_t equal = 0;     // that lay on another one and faced the same way: removed
  std::size_t opposite = 0;  // that lay on the back of another one: its other side now
  std::size_t lamps = 0;     // of the removed ones, those that emit where another one does
  // For each primitive as it was: whether its material is still seen, on some side of some surface.
  std::vector<bool> is_shown;
};

// Of a corner; the same for corners that are equal.
std::uint64_t hash_of(Vec3 p);

// Cuts flat faces of more than three corners that have the same ones into the same triangles: a face and the same
// face turned round begin at different corners, and so have other diagonals.
void share_diagonals(Scene& scene);

// Calls share_diagonals. Then it makes one surface of triangles that have the same corners, in any order, and of spheres with the
// same centre and radius: else rounding decides at each point which is met first. Of two that face the same way the
// first stays, unless only the other emits. Of two that face opposite ways the first shows the
// material of the second on its back.
Twins merge_twins(Scene& scene);

// The number of triangles that have another surface in their plane at their centre, which is not the same triangle.
std::size_t count_overlaps(const Primitives& primitives);

}  // namespace pt
