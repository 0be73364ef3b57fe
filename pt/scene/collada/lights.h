#pragma once

#include "pt/scene/collada/emitters.h"
#include "pt/scene/collada/nodes.h"

#include <string>
#include <vector>

namespace pt {

// Each surface that emits and each light node is a light. The search for lights that coincide looks
// at all pairs, and a picture samples all of them at every point.
inline constexpr std::size_t kMaxLights = 10'000;

// A light that a node of the scene holds.
struct LightNode {
  Light light;
  std::string name;  // in quotes
  Vec3 position;
};

struct LightNodes {
  std::vector<LightNode> nodes;
  std::vector<std::string> unsupported;  // "spot light 'Lamp'"
  std::vector<std::string> notes;
};

LightNodes read_lights(const ColladaDocument& document, const std::vector<Instance>& instances);

// All lights of a scene, each once. A light node that lies on an emitting surface is a second
// statement about the same lamp: the surface is the light. So an area light whose centre is within
// a twentieth of the surface's size from the surface's own and whose plane is parallel; and a point
// light there that lies in the surface, for whether it shines out of it rounding would decide.
struct SceneLights {
  std::vector<Light> lights;
  std::vector<std::string> notes;
};
SceneLights merge_lights(const std::vector<Emitter>& emitters, const std::vector<LightNode>& nodes);

}  // namespace pt
