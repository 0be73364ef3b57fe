#include "pt/scene/collada/lights.h"
#include "pt/scene/collada/numbers.h"

#include <algorithm>
#include <cmath>

namespace pt {

namespace {

constexpr double kCenterTolerance = 0.05;  // of the surface's size
constexpr double kPlaneTolerance = 1e-3;   // the same, for a point light
constexpr double kParallel = 0.99;         // cosine

bool coincide(const LightNode& node, const Emitter& emitter) {
  const Vec3 offset = node.position - emitter.center;
  if (!(length(offset) <= kCenterTolerance * emitter.size) || emitter.n == Vec3{}) return false;
  if (const auto* area = std::get_if<RectangleLight>(&node.light)) {
    return std::abs(dot(area->n, emitter.n)) > kParallel;
  }
  return std::holds_alternative<PointLight>(node.light) &&
         std::abs(dot(offset, emitter.n)) <= kPlaneTolerance * emitter.size;
}

// "0.8 x 0 x 0.6": the size of a rectangle along x, y and z.
std::string reach(const RectangleLight& light) {
  const auto along = [&](int axis) {
    const double length_of = std::abs(light.u[axis]) + std::abs(light.v[axis]);
    const bool is_noise = length_of < 1e-5 * (max_abs(light.u) + max_abs(light.v));
    return shown(is_noise ? 0 : length_of);
  };
  return along(0) + " x " + along(1) + " x " + along(2);
}

// Returns whether the sides of two rectangles are the same except for rounding.
bool same_sides(const RectangleLight& a, const RectangleLight& b) {
  const auto parallel = [](Vec3 p, Vec3 q) {
    const double tolerance = 1e-3 * length(q);
    return length(p - q) <= tolerance || length(p + q) <= tolerance;
  };
  return (parallel(a.u, b.u) && parallel(a.v, b.v)) || (parallel(a.u, b.v) && parallel(a.v, b.u));
}

// A note on the values of the light node that its surface replaces; empty if the two agree.
std::string correction(const LightNode& node, const Emitter& emitter) {
  const std::string which = "light node " + node.name + " lies on the emitting surface " +
                            emitter.name + ", which is the light";
  const auto* area = std::get_if<RectangleLight>(&node.light);
  if (area == nullptr) return which + ": the point light is left out.";
  std::string note;
  const auto* quad = std::get_if<RectangleLight>(&emitter.light);
  if (quad != nullptr && !same_sides(*area, *quad)) {
    note += "; the node's " + reach(*area) + " along x, y, z is replaced by " + reach(*quad);
  }
  if (!(area->radiance == emitter.radiance)) {
    note += "; its colour " + shown(area->radiance) + " is replaced by the radiance " +
            shown(emitter.radiance);
  }
  if (dot(area->n, emitter.n) < 0) note += "; it shone to the other side";
  return note.empty() ? "" : which + note + ".";
}

}  // namespace

std::vector<Light> merge_lights(const Document& document, const std::vector<Emitter>& emitters,
                                const std::vector<LightNode>& nodes) {
  std::vector<Light> merged;
  for (const Emitter& emitter : emitters) merged.push_back(emitter.light);
  for (const LightNode& node : nodes) {
    const auto emitter = std::find_if(emitters.begin(), emitters.end(),
                                      [&](const Emitter& e) { return coincide(node, e); });
    if (emitter != emitters.end()) {
      const std::string note = correction(node, *emitter);
      if (!note.empty()) document.note(note);
    } else {
      merged.push_back(node.light);
      if (!node.note.empty()) document.note(node.note);
    }
  }
  return merged;
}

}  // namespace pt
