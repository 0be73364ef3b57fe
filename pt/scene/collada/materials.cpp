#include "pt/scene/collada/materials.h"

#include "pt/scene/collada/numbers.h"

#include <algorithm>
#include <optional>

#include <tinyxml2.h>

namespace pt {

namespace {

std::string plain_label(const XMLElement& element) {
  const std::string name = label(element);
  return name.substr(1, name.size() - 2);
}

const XMLElement* common_shader(const XMLElement& effect) {
  const XMLElement* profile = effect.FirstChildElement("profile_COMMON");
  const XMLElement* technique = profile ? profile->FirstChildElement("technique") : nullptr;
  if (technique == nullptr) return nullptr;
  for (const char* kind : {"phong", "lambert", "blinn"}) {
    if (const XMLElement* shader = technique->FirstChildElement(kind)) return shader;
  }
  return nullptr;
}

// The colour of one of a shader's channels, such as diffuse.
std::optional<Rgb> common_color(const ColladaDocument& document, const XMLElement* shader,
                                const char* channel) {
  const XMLElement* found = shader ? shader->FirstChildElement(channel) : nullptr;
  const XMLElement* color = found ? found->FirstChildElement("color") : nullptr;
  if (color == nullptr) return std::nullopt;
  return read_color(document, *color);
}

// The course's own diffuse surface: its colour is the first child, whatever its name.
std::optional<Rgb> course_albedo(const ColladaDocument& document, const XMLElement& effect) {
  const XMLElement* diffuse = course_child(effect, "diffuse");
  if (diffuse == nullptr) return std::nullopt;
  const XMLElement* color = diffuse->FirstChildElement();
  return read_color(document, color ? *color : *diffuse);
}

Rgb read_albedo(const ColladaDocument& document, const XMLElement& effect, const std::string& name,
                std::vector<std::string>& notes) {
  std::optional<Rgb> albedo = course_albedo(document, effect);
  if (!albedo) albedo = common_color(document, common_shader(effect), "diffuse");
  if (!albedo) {
    notes.push_back("material " + name + " states no diffuse colour: its albedo is 0.5.");
    return gray(0.5);
  }
  if (!(max_channel(*albedo) <= 1)) {
    notes.push_back("material " + name +
                    " reflects more than it receives: its albedo is cut to 1.");
  }
  return {std::min(albedo->r, 1.0), std::min(albedo->g, 1.0), std::min(albedo->b, 1.0)};
}

}  // namespace

Material read_material(const ColladaDocument& document, const XMLElement& element,
                       std::vector<std::string>& notes) {
  const XMLElement& effect =
      document.resolve(document.child(element, "instance_effect"), "url", "effect");
  const std::string name = label(element);
  Material material;
  material.name = plain_label(element);
  if (const XMLElement* emission = course_child(effect, "emission")) {
    material.emission = read_color(document, document.child(*emission, "radiance"));
  } else if (common_color(document, common_shader(effect), "emission").value_or(Rgb{}) != Rgb{}) {
    notes.push_back("material " + name +
                    " has an emission colour in profile_COMMON, which is ignored: only the "
                    "course's emission/radiance emits.");
  }
  for (const char* kind : {"mirror", "glass", "refraction", "microfacet"}) {
    if (material.unsupported.empty() && course_child(effect, kind)) material.unsupported = kind;
  }
  if (material.unsupported.empty()) material.albedo = read_albedo(document, effect, name, notes);
  return material;
}

}  // namespace pt
