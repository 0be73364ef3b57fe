// The text of a WildScene, for a report.
#include "grader/check/language/show.h"
#include "grader/check/wild/wild_scene.h"

#include <fmt/format.h>

namespace grader::check {

namespace {

using Kind = WildLight::Kind;

std::string text_of(const WildLight& light) {
  const std::string at = brief(light.at), radiance = brief(light.radiance);
  const std::string glow = fmt::format("radiance {}{}\n", radiance,
                                       light.has_body ? ", and its surface is in the scene" : "");
  switch (light.kind) {
    case Kind::rectangle:
      return fmt::format("rectangle light around {}, sides {} {}, {}", at, brief(light.u),
                         brief(light.v), glow);
    case Kind::ball:
      return fmt::format("ball of light around {}, radius {}, {}", at, brief(light.radius), glow);
    case Kind::cube:
      return fmt::format("closed mesh light: a cube around {}, edges {} {}, {}", at, brief(light.u),
                         brief(light.v), glow);
    case Kind::point:
      return fmt::format("point light at {}, intensity {}\n", at, radiance);
    case Kind::directional:
      return fmt::format("directional light from {}, irradiance {}\n", at, radiance);
    case Kind::sky:
      break;
  }
  return fmt::format("sky, radiance {}\n", radiance);
}

std::string text_of(const WildSurface& surface) {
  const std::string shape =
      surface.radius > 0
          ? fmt::format("ball at {}, radius {}", brief(surface.at), brief(surface.radius))
          : fmt::format("triangle {} {} {}", brief(surface.at), brief(surface.p1),
                        brief(surface.p2));
  const std::string glows =
      is_black(surface.emission) ? "" : ", emission " + brief(surface.emission);
  return fmt::format("{}, albedo {}{}\n", shape, brief(surface.albedo), glows);
}

std::string text_of(const WildRoom& room) {
  return fmt::format(
      "a closed cube of edge {} around {}, whose walls have the albedos {} {} ...{}\n",
      brief(2 * room.half), brief(room.center), brief(room.albedo[0]), brief(room.albedo[1]),
      is_black(room.emission[0]) ? "" : " and glow");
}

}  // namespace

std::string text_of(const WildScene& scene) {
  std::string text = "here the point is at (0, 0, 0) and its normal along z";
  const bool is_moved = scene.size != 1 || length(scene.away) > 0;
  if (is_moved) {
    text += fmt::format("; the test scales this by {}, turns z to {}, and moves it by {}",
                        brief(scene.size), brief(scene.up), brief(scene.size * scene.away));
  } else if (scene.up.z != 1) {
    text += "; the test turns z to " + brief(scene.up);
  }
  text += fmt::format("\nthe point is on a triangle of side {}", brief(scene.side));
  if (scene.true_normal.z != 1)
    text += fmt::format(", whose true normal is {}", brief(scene.true_normal));
  text += "\n";
  for (const WildLight& light : scene.lights) text += text_of(light);
  for (const WildSurface& surface : scene.surfaces) text += text_of(surface);
  if (scene.room) text += text_of(*scene.room);
  return text;
}

}  // namespace grader::check
