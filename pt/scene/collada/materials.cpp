#include "pt/scene/collada/materials.h"

#include "pt/scene/collada/numbers.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>

#include <tinyxml2.h>

namespace pt {

namespace {

// The elements that the channels of a material are read from. `shader` is null if there is none.
struct Shader {
  const XMLElement* instance;  // <instance_effect>
  const XMLElement* effect;
  const XMLElement* shader = nullptr;
};

Shader common_shader(const XMLElement& instance, const XMLElement& effect) {
  Shader found{&instance, &effect};
  for (const char* kind : {"phong", "lambert", "blinn", "constant"}) {
    if (!found.shader) found.shader = find_below(&effect, {"profile_COMMON", "technique", kind});
  }
  return found;
}

// The <newparam sid> or <setparam ref> with that name among an element's children.
const XMLElement* find_param(const XMLElement* parent, const char* kind, const char* key,
                             std::string_view name) {
  const XMLElement* param = find_below(parent, {kind});
  while (param != nullptr && attribute(param, key) != name) {
    param = param->NextSiblingElement(kind);
  }
  return param;
}

// A material sets a parameter that its effect declares: in the technique, the profile or the effect.
const XMLElement* find_param(const Shader& shader, std::string_view name) {
  const XMLElement* found = find_param(shader.instance, "setparam", "ref", name);
  const tinyxml2::XMLNode* scope = shader.shader;
  while (found == nullptr && scope != nullptr && scope != shader.effect) {
    scope = scope->Parent();
    found = find_param(scope->ToElement(), "newparam", "sid", name);
  }
  return found;
}

// One of a shader's channels, such as diffuse: its <color> or <float>, or why it has none.
struct Channel {
  const XMLElement* element = nullptr;
  const XMLElement* value = nullptr;
  std::string instead;  // "is a texture, which is not read"; empty if the channel is not there
};

Channel channel(const Shader& shader, const char* name) {
  const XMLElement* found = find_below(shader.shader, {name});
  if (found == nullptr) return {};
  for (const char* kind : {"color", "float"}) {
    if (const XMLElement* value = found->FirstChildElement(kind)) return {found, value, ""};
  }
  if (found->FirstChildElement("texture")) {
    return {found, nullptr, "is a texture, which is not read"};
  }
  const std::string_view ref = attribute(found->FirstChildElement("param"), "ref");
  if (ref.empty()) return {};
  const XMLElement* param = find_param(shader, ref);
  const std::string what = "is the parameter " + quoted(ref);
  if (param == nullptr) return {found, nullptr, what + ", which the file does not define"};
  for (const char* kind : {"float4", "float3", "float"}) {
    if (const XMLElement* value = param->FirstChildElement(kind)) return {found, value, ""};
  }
  return {found, nullptr, what + ", which is no colour"};
}

// The numbers of a channel that is ignored, so that nothing fails.
std::vector<double> read_loosely(const Channel& channel) {
  std::istringstream text{std::string(trimmed_text(channel.value))};
  return {std::istream_iterator<double>(text), {}};
}

// Returns whether the shader lets light through (COLLADA 1.4.1, "transparent"): the opacity is
// alpha x transparency for A_ONE, the default, and 1 - colour x transparency for RGB_ZERO.
bool is_see_through(const Shader& shader) {
  const Channel transparent = channel(shader, "transparent");
  if (!transparent.value && !transparent.instead.empty()) return true;
  const std::vector<double> factor = read_loosely(channel(shader, "transparency"));
  const double t = factor.size() == 1 ? factor[0] : 1;
  if (!transparent.value) return t != 1;
  std::vector<double> c = read_loosely(transparent);
  c.resize(4, 1);
  const std::string_view mode = attribute(transparent.element, "opaque");
  const double opaque = mode.ends_with("ZERO") ? 0 : 1;
  if (!mode.starts_with("RGB")) return c[3] * t != opaque;
  return c[0] * t != opaque || c[1] * t != opaque || c[2] * t != opaque;
}

void note_what_is_ignored(const Document& document, const Shader& shader, const std::string& name) {
  if (is_see_through(shader)) {
    document.note("material " + name + " is transparent, which is ignored: it is opaque.");
  }
  const std::vector<double> reflectivity = read_loosely(channel(shader, "reflectivity"));
  if (reflectivity.size() == 1 && reflectivity[0] > 0) {
    document.note("material " + name + " has a reflectivity, which is ignored: it is diffuse.");
  }
}

// The colour of the course's own diffuse surface is its first child, whatever its name.
Rgb read_albedo(const Document& document, const Shader& shader, const std::string& name) {
  const Channel diffuse = channel(shader, "diffuse");
  const XMLElement* color = diffuse.value;
  if (const XMLElement* course = course_child(*shader.effect, "diffuse")) {
    color = course->FirstChildElement() ? course->FirstChildElement() : course;
  }
  if (color == nullptr) {
    document.note("material " + name +
                  (diffuse.instead.empty()
                       ? " states no diffuse colour: its albedo is 0.5."
                       : " has a diffuse colour that " + diffuse.instead + ": its albedo is 0.5."));
    return gray(0.5);
  }
  const Rgb albedo = read_color(document, *color);
  if (!(max_channel(albedo) <= 1)) {
    document.note("material " + name + " reflects more than it receives: its albedo is cut to 1.");
  }
  return {std::min(albedo.r, 1.0), std::min(albedo.g, 1.0), std::min(albedo.b, 1.0)};
}

// Nothing if an emission colour is ignored: exporters write one for every material, so that it
// emits only if it is asked for.
std::optional<Rgb> read_emission(const Document& document, const Shader& shader,
                                 const LoadOptions& options, const std::string& name) {
  if (const XMLElement* emission = course_child(*shader.effect, "emission")) {
    return read_color(document, document.child(*emission, "radiance"));
  }
  const Channel common = channel(shader, "emission");
  if (!common.value && !common.instead.empty()) {
    document.note("material " + name + " has an emission colour that " + common.instead +
                  ": it does not emit.");
  }
  const Rgb color = common.value ? read_color(document, *common.value) : Rgb{};
  if (is_black(color) || options.common_emission) return color;
  document.note("material " + name +
                " has an emission colour in profile_COMMON, which is ignored: only the course's "
                "emission/radiance emits.");
  return std::nullopt;
}

}  // namespace

FileMaterial read_material(const Document& document, const XMLElement& element,
                           const LoadOptions& options) {
  const std::string name = label(element);
  FileMaterial result;
  result.material.name = name.substr(1, name.size() - 2);  // without quotes
  const XMLElement* instance = element.FirstChildElement("instance_effect");
  if (document.find(instance, "url", "effect").first == nullptr) {
    document.note("material " + name + " names no effect of the file: its albedo is 0.5.");
    return result;
  }
  const XMLElement& effect = document.resolve(*instance, "url", "effect");
  const Shader shader = common_shader(*instance, effect);
  const std::optional<Rgb> emission = read_emission(document, shader, options, name);
  result.material.emission = emission.value_or(Rgb{});
  result.ignores_emission = !emission;
  for (const char* kind : {"mirror", "glass", "refraction", "microfacet"}) {
    if (course_child(effect, kind) == nullptr) continue;
    if (!options.lambertian) result.material.unsupported = kind;
    document.note("material " + name + " (" + kind + ") is " +
                  (options.lambertian ? "treated as a diffuse albedo of 0.5."
                                      : "outside the model: only its normals can be shown."));
    return result;
  }
  result.material.albedo = read_albedo(document, shader, name);
  note_what_is_ignored(document, shader, name);
  return result;
}

}  // namespace pt
