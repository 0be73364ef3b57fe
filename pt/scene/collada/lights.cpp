#include "pt/scene/collada/lights.h"

#include "pt/scene/collada/numbers.h"

#include <cmath>
#include <unordered_map>

#include <tinyxml2.h>

namespace pt {

namespace {

// <area>, <point>, ... : from the course's technique, else from technique_common.
const XMLElement& kind_element(const ColladaDocument& document, const XMLElement& light) {
  if (const XMLElement* course = course_child(light, "")) return *course;
  const XMLElement& common = document.child(light, "technique_common");
  const XMLElement* kind = common.FirstChildElement();
  if (kind == nullptr) document.fail(common, "light " + label(light) + " has no kind; write one");
  return *kind;
}

// In its own frame a light is at the origin and shines along -z with y up. The sides of an area
// light are the images of y and of y x (-z) = -x.
RectangleLight area_light(const ColladaDocument& document, const Instance& instance, Rgb color) {
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

DirectionalLight directional_light(const ColladaDocument& document, const Instance& instance,
                                   Rgb color) {
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
};

LightText read_text(const ColladaDocument& document, const XMLElement& light) {
  const XMLElement& kind_of = kind_element(document, light);
  const std::string_view kind = kind_of.Name();
  if (kind == "spot") return {kind, {}};
  if (kind != "area" && kind != "point" && kind != "directional" && kind != "ambient") {
    document.fail(kind_of, "<" + std::string(kind) +
                               "> is not a kind of light; write area, point, "
                               "directional or ambient");
  }
  return {kind, read_color(document, document.child(kind_of, "color"))};
}

Light placed(const ColladaDocument& document, const Instance& instance, const LightText& text) {
  if (text.kind == "area") return area_light(document, instance, text.color);
  if (text.kind == "point") return PointLight{instance.to_world.translation, text.color};
  if (text.kind == "directional") return directional_light(document, instance, text.color);
  return AmbientLight{text.color};
}

}  // namespace

LightNodes read_lights(const ColladaDocument& document, const std::vector<Instance>& instances) {
  LightNodes lights;
  std::unordered_map<const XMLElement*, LightText> texts;
  if (instances.size() > kMaxLights) {
    document.fail(*instances[kMaxLights].element,
                  "the scene has more than 10,000 lights; use fewer");
  }
  for (const Instance& instance : instances) {
    if (!texts.contains(instance.target)) {
      texts.emplace(instance.target, read_text(document, *instance.target));
    }
    const LightText& text = texts.at(instance.target);
    const std::string name = label(*instance.node);
    if (text.kind == "spot") {
      lights.unsupported.push_back("spot light " + name);
      lights.notes.push_back("spot light " + name + " is outside the model and left out.");
      continue;
    }
    const Light light = placed(document, instance, text);
    if (is_black(text.color)) {
      lights.notes.push_back("light " + name + " is black and left out.");
      continue;
    }
    lights.nodes.push_back({light, name, instance.to_world.translation});
  }
  return lights;
}

}  // namespace pt
