#include "pt/scene/collada/lights.h"

#include "pt/scene/collada/numbers.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <tinyxml2.h>

namespace pt {

namespace {

// A light is divided by constant + linear d + quadratic d^2 at the distance d. Without any of them
// it does not fall off (COLLADA 1.4.1, "point").
struct FallOff {
  double constant = 1, linear = 0, quadratic = 0;

  double at(double d) const { return constant + linear * d + quadratic * d * d; }
};

FallOff read_fall_off(const Document& document, const XMLElement& point) {
  const FallOff read{child_number(document, point, "constant_attenuation").value_or(1),
                     child_number(document, point, "linear_attenuation").value_or(0),
                     child_number(document, point, "quadratic_attenuation").value_or(0)};
  if (!(read.constant >= 0 && read.linear >= 0 && read.quadratic >= 0)) {
    document.fail(point, "an attenuation is negative; write a number from 0 up");
  }
  return read.constant + read.linear + read.quadratic > 0 ? read : FallOff{};
}

// In its own frame a light is at the origin and shines along -z with y up. The sides of an area
// light are the images of y and of y x (-z) = -x.
RectangleLight area_light(const Document& document, const Instance& instance, Rgb color) {
  const Transform& map = instance.to_world;
  const Vec3 u = map.direction({0, 1, 0});
  const Vec3 v = map.direction({-1, 0, 0});
  const Vec3 normal = cross(u, v);
  const Vec3 ahead = map.direction({0, 0, -1});
  if (!std::isnormal(length_squared(normal)) || !(dot(normal, ahead) != 0)) {
    document.fail(*instance.node, "area light " + label(*instance.node) +
                                      " has no area or no side to shine to; correct its matrix");
  }
  const Vec3 n = normalize(normal);
  return {map.translation, u, v, dot(n, ahead) < 0 ? -n : n, color};
}

DirectionalLight directional_light(const Document& document, const Instance& instance, Rgb color) {
  const Vec3 ahead = instance.to_world.direction({0, 0, -1});
  if (!std::isnormal(length_squared(ahead))) {
    document.fail(*instance.node, "directional light " + label(*instance.node) +
                                      " has no direction; correct its matrix");
  }
  return {normalize(ahead), color};
}

// The content of a <light>. It is read once, however often the light is instanced.
struct LightText {
  std::string_view kind;
  Rgb color;
  FallOff fall_off{0, 0, 1};
};

// From the course's technique, else from technique_common.
LightText read_text(const Document& document, const XMLElement& light) {
  const XMLElement* course = course_child(light);
  const XMLElement* common = light.FirstChildElement("technique_common");
  const XMLElement* found = course || !common ? course : common->FirstChildElement();
  if (found == nullptr) {
    document.note("light " + label(light) + " has no kind in its technique_common.");
    return {};
  }
  const std::string_view kind = found->Name();
  if (kind == "spot") return {kind, {}};
  if (kind != "area" && kind != "point" && kind != "directional" && kind != "ambient") {
    document.fail(*found, "<" + std::string(kind) +
                              "> is not a kind of light; write area, point, "
                              "directional or ambient");
  }
  LightText text{kind, read_color(document, document.child(*found, "color"))};
  if (kind == "point" && !course) text.fall_off = read_fall_off(document, *found);
  return text;
}

// A point light is as bright as the file says at some distance d.
LightNode point_light(const LightText& text, const std::string& name, Vec3 position,
                      const Box& scene) {
  const FallOff& f = text.fall_off;
  if (f.constant == 0 && f.linear == 0) {
    return {PointLight{position, text.color / f.quadratic}, name, position};
  }
  const double d = std::max(length(position - scene.center()), 0.5 * length(scene.extent()));
  return {PointLight{position, text.color * (d * d / f.at(d))}, name, position,
          "point light " + name + " falls off as 1 / (" + shown(f.constant) + " + " +
              shown(f.linear) + " d + " + shown(f.quadratic) +
              " d^2) in the file (COLLADA's default is 1, not at all); here it falls off as "
              "1 / d^2, and is as bright as the file says at the distance d = " +
              shown(d) + "."};
}

LightNode placed(const Document& document, const Instance& instance, const LightText& text,
                 const Box& scene) {
  const std::string name = label(*instance.node);
  const Vec3 position = instance.to_world.translation;
  if (text.kind == "point") return point_light(text, name, position, scene);
  if (text.kind == "area") return {area_light(document, instance, text.color), name, position};
  if (text.kind == "ambient") return {AmbientLight{text.color}, name, position};
  return {directional_light(document, instance, text.color), name, position};
}

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

LightNodes read_lights(const Document& document, const std::vector<Instance>& instances,
                       const Box& scene) {
  LightNodes lights;
  std::unordered_map<const XMLElement*, LightText> texts;
  if (instances.size() > kMaxLights) {
    document.fail(*instances.back().element, "the scene has more than 10,000 lights; use fewer");
  }
  for (const Instance& instance : instances) {
    const auto [known, is_new] = texts.try_emplace(instance.target);
    LightText& text = known->second;
    if (is_new) text = read_text(document, *instance.target);
    if (text.kind == "spot") {
      lights.unsupported.push_back("spot light " + label(*instance.node));
      document.note(lights.unsupported.back() + " is outside the model and left out.");
      continue;
    }
    const LightNode node = placed(document, instance, text, scene);
    if (is_black(text.color)) {
      document.note("light " + node.name + " is black and left out.");
    } else {
      lights.nodes.push_back(node);
    }
  }
  return lights;
}

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
