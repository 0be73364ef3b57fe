#include "pt/scene/collada/materials.h"

#include "pt/scene/collada/numbers.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string_view>

#include <tinyxml2.h>

namespace pt {

namespace {

std::string plain_label(const XMLElement& element) {
  const std::string name = label(element);
  return name.substr(1, name.size() - 2);
}

// The elements that the channels of a material's shader are read from. `shader` is null if there is none.
struct Shader {
  const XMLElement* instance;  // <instance_effect>
  const XMLElement* effect;
  const XMLElement* shader = nullptr;
};

Shader common_shader(const XMLElement& instance, const XMLElement& effect) {
  Shader found{&instance, &effect};
  const XMLElement* profile = effect.FirstChildElement("profile_COMMON");
  const XMLElement* technique = profile ? profile->FirstChildElement("technique") : nullptr;
  if (technique == nullptr) return found;
  for (const char* kind : {"phong", "lambert", "blinn", "constant"}) {
    if (!found.shader) found.shader = technique->FirstChildElement(kind);
  }
  return found;
}

// The <newparam sid> or <setparam ref> with that name among an element's children.
const XMLElement* find_param(const XMLElement* parent, const char* kind, const char* attribute,
                             std::string_view name) {
  const XMLElement* param = parent ? parent->FirstChildElement(kind) : nullptr;
  while (param != nullptr && param->Attribute(attribute, std::string(name).c_str()) == nullptr) {
    param = param->NextSiblingElement(kind);
  }
  return param;
}

// A material sets a parameter that its effect declares: in the technique, the profile or the effect.
const XMLElement* find_param(const Shader& shader, std::string_view name) {
  const XMLElement* found = find_param(shader.instance, "setparam", "ref", name);
  const tinyxml2::XMLNode* scope = shader.shader->Parent();
  while (found == nullptr && scope != nullptr && scope->ToElement() != nullptr) {
    found = find_param(scope->ToElement(), "newparam", "sid", name);
    scope = scope == shader.effect ? nullptr : scope->Parent();
  }
  return found;
}

// One of a shader's channels, such as diffuse: its <color> or <float>, or why it has none.
struct Channel {
  const XMLElement* value = nullptr;
  std::string instead;  // "is a texture, which is not read"; empty if the channel is not there
};

Channel channel(const Shader& shader, const char* name) {
  const XMLElement* found = shader.shader ? shader.shader->FirstChildElement(name) : nullptr;
  if (found == nullptr) return {};
  for (const char* kind : {"color", "float"}) {
    if (const XMLElement* value = found->FirstChildElement(kind)) return {value, ""};
  }
  if (found->FirstChildElement("texture")) return {nullptr, "is a texture, which is not read"};
  const XMLElement* reference = found->FirstChildElement("param");
  const char* ref = reference ? reference->Attribute("ref") : nullptr;
  if (ref == nullptr) return {};
  const XMLElement* param = find_param(shader, ref);
  if (param == nullptr) {
    return {nullptr, "is the parameter " + quoted(ref) + ", which the file does not define"};
  }
  for (const char* kind : {"float4", "float3", "float"}) {
    if (const XMLElement* value = param->FirstChildElement(kind)) return {value, ""};
  }
  return {nullptr, "is the parameter " + quoted(ref) + ", which is no colour"};
}

// Up to four numbers, and how many there are; for things that are ignored, so that nothing fails.
struct Loose {
  double v[4] = {0, 0, 0, 1};
  int count = 0;
};

Loose read_loosely(const XMLElement* value) {
  Loose loose;
  const char* text = value ? value->GetText() : nullptr;
  double* v = loose.v;
  if (text) loose.count = std::sscanf(text, "%lf %lf %lf %lf", v, v + 1, v + 2, v + 3);
  return loose;
}

// Returns whether the shader lets light through (COLLADA 1.4.1, "transparent"): the opacity is
// alpha x transparency for A_ONE, the default, and 1 - colour x transparency for RGB_ZERO.
bool is_see_through(const Shader& shader) {
  const Channel transparent = channel(shader, "transparent");
  if (!transparent.value && !transparent.instead.empty()) return true;
  const Loose factor = read_loosely(channel(shader, "transparency").value);
  const double t = factor.count == 1 ? factor.v[0] : 1;
  if (!transparent.value) return t != 1;
  const Loose c = read_loosely(transparent.value);
  const char* text = transparent.value->Parent()->ToElement()->Attribute("opaque");
  const std::string_view mode = text ? text : "A_ONE";
  const int first = mode.starts_with("RGB") ? 0 : 3, last = mode.starts_with("RGB") ? 2 : 3;
  const double opaque = mode.ends_with("ZERO") ? 0 : 1;
  return std::any_of(c.v + first, c.v + last + 1, [&](double v) { return v * t != opaque; });
}

void note_what_is_ignored(const Shader& shader, const std::string& name,
                          std::vector<std::string>& notes) {
  if (shader.shader == nullptr) return;
  if (is_see_through(shader)) {
    notes.push_back("material " + name + " is transparent, which is ignored: it is opaque.");
  }
  const Loose reflectivity = read_loosely(channel(shader, "reflectivity").value);
  if (reflectivity.count == 1 && reflectivity.v[0] > 0) {
    notes.push_back("material " + name + " has a reflectivity, which is ignored: it is diffuse.");
  }
}

// The course's own diffuse surface: its colour is the first child, whatever its name.
std::optional<Rgb> course_albedo(const ColladaDocument& document, const XMLElement& effect) {
  const XMLElement* diffuse = course_child(effect, "diffuse");
  if (diffuse == nullptr) return std::nullopt;
  const XMLElement* color = diffuse->FirstChildElement();
  return read_color(document, color ? *color : *diffuse);
}

Rgb read_albedo(const ColladaDocument& document, const Shader& shader, const std::string& name,
                std::vector<std::string>& notes) {
  std::optional<Rgb> albedo = course_albedo(document, *shader.effect);
  const Channel diffuse = channel(shader, "diffuse");
  if (!albedo && diffuse.value) albedo = read_color(document, *diffuse.value);
  if (!albedo) {
    notes.push_back("material " + name +
                    (diffuse.instead.empty() ? " states no diffuse colour: its albedo is 0.5."
                                             : " has a diffuse colour that " + diffuse.instead +
                                                   ": its albedo is 0.5."));
    return gray(0.5);
  }
  if (!(max_channel(*albedo) <= 1)) {
    notes.push_back("material " + name +
                    " reflects more than it receives: its albedo is cut to 1.");
  }
  return {std::min(albedo->r, 1.0), std::min(albedo->g, 1.0), std::min(albedo->b, 1.0)};
}

struct Emission {
  Rgb radiance;
  bool is_ignored = false;
};

// Exporters write an emission colour for every material, so that it emits only if it is asked for.
Emission read_emission(const ColladaDocument& document, const Shader& shader,
                       const LoadOptions& options, const std::string& name,
                       std::vector<std::string>& notes) {
  if (const XMLElement* emission = course_child(*shader.effect, "emission")) {
    return {read_color(document, document.child(*emission, "radiance"))};
  }
  const Channel common = channel(shader, "emission");
  if (!common.value && !common.instead.empty()) {
    notes.push_back("material " + name + " has an emission colour that " + common.instead +
                    ": it does not emit.");
  }
  const Rgb color = common.value ? read_color(document, *common.value) : Rgb{};
  if (is_black(color) || options.common_emission) return {color};
  notes.push_back("material " + name +
                  " has an emission colour in profile_COMMON, which is ignored: only the course's "
                  "emission/radiance emits.");
  return {{}, true};
}

}  // namespace

FileMaterial read_material(const ColladaDocument& document, const XMLElement& element,
                           const LoadOptions& options, std::vector<std::string>& notes) {
  const std::string name = label(element);
  FileMaterial result;
  result.material.name = plain_label(element);
  const XMLElement* instance = element.FirstChildElement("instance_effect");
  const char* url = instance ? instance->Attribute("url") : nullptr;
  if (url == nullptr || document.find(*instance, url, "effect").first == nullptr) {
    notes.push_back("material " + name + " names no effect of the file: its albedo is 0.5.");
    return result;
  }
  const XMLElement& effect = document.resolve(*instance, "url", "effect");
  const Shader shader = common_shader(*instance, effect);
  const Emission emission = read_emission(document, shader, options, name, notes);
  result.material.emission = emission.radiance;
  result.ignores_emission = emission.is_ignored;
  std::string& unsupported = result.material.unsupported;
  for (const char* kind : {"mirror", "glass", "refraction", "microfacet"}) {
    if (unsupported.empty() && course_child(effect, kind)) unsupported = kind;
  }
  if (!unsupported.empty()) return result;
  result.material.albedo = read_albedo(document, shader, name, notes);
  note_what_is_ignored(shader, name, notes);
  return result;
}

}  // namespace pt
