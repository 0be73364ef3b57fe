#pragma once

#include "pt/geometry/box.h"
#include "pt/scene/collada/emitters.h"
#include "pt/scene/collada/nodes.h"

#include <string>
#include <vector>

namespace pt {

// The maximum number of lights: each emitting surface and each light node is a light. The search
// for lights that coincide tests all pairs, and a picture samples all lights at every point.
inline constexpr std::size_t kMaxLights = 10'000;

// A light that a node of the scene holds.
struct LightNode {
  Light light;
  std::string name;  // in quotes
  Vec3 position;
  std::string note{};  // on how it is read, if it is a light of the scene
};

struct LightNodes {
  std::vector<LightNode> nodes;
  std::vector<std::string> unsupported;  // "spot light 'Lamp'"
};

// A point light of the common profile may fall off in any way. Ours fall off with the squared
// distance: in the middle of the scene, or half its diagonal away if that is further, they are as
// bright as the file says. `scene` bounds all surfaces.
LightNodes read_lights(const Document& document, const std::vector<Instance>& instances,
                       const Box& scene);

// All lights of a scene, each once. A light node on an emitting surface describes the same lamp a
// second time: the surface is the light, and the node is left out. This concerns area lights
// parallel to a flat surface, with centres within a twentieth of the surface's size, and point
// lights there that lie in the surface's plane, because rounding would decide on which side they
// shine.
std::vector<Light> merge_lights(const Document& document, const std::vector<Emitter>& emitters,
                                const std::vector<LightNode>& nodes);

}  // namespace pt
