#pragma once

#include "pt/math/transform.h"
#include "pt/scene/collada/document.h"

#include <vector>

// The visual scene of a file as a list, turned so that y is up (<up_axis>). <unit> changes nothing:
// a scene has the file's unit.

namespace pt {

// One <instance_...> of the visual scene, the geometry, light or camera that it names, and its
// node's transform.
struct Instance {
  const XMLElement* element = nullptr;
  const XMLElement* target = nullptr;
  const XMLElement* node = nullptr;
  Transform to_world;
};

struct Instances {
  Vec3 front{0, 0, 1};  // towards somebody who stands in front of the scene, in world space
  std::vector<Instance> geometries;
  std::vector<Instance> lights;
  std::vector<Instance> cameras;
};

// All content of the file's visual scene, with nested and instanced nodes unfolded, in document
// order. What is not in the file is left out, with a note.
Instances read_nodes(const Document& document);

}  // namespace pt
