#pragma once

#include "pt/scene/bounce_range.h"
#include "pt/scene/frame_camera.h"
#include "pt/scene/tracer.h"
#include "pt/scene/view.h"
#include "pt/tasks/adaptive_pixel.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace measure {

// One render: everything that its pixels depend on, except the code and the scene file's content.
struct Spec {
  std::string scene;  // path
  int width = 480, height = 360;
  int frame_width = 480, frame_height = 360;  // the camera is framed for a picture of this size
  pt::Framing framing = pt::Framing::course;
  int samples = 1;  // per pixel; the maximum if adaptive
  std::optional<pt::AdaptiveSettings> adaptive;
  pt::PathSettings path;
  // If not empty: one picture per range of bounces, all from the same paths; `path` covers all.
  std::vector<pt::BounceRange> ranges;
  pt::Engine engine = pt::Engine::task;
  std::uint64_t seed = 1;

  int pixels() const { return width * height; }
  int row_pixels() const { return width * std::max(1, static_cast<int>(ranges.size())); }
};

nlohmann::json to_json(const Spec& spec);
Spec spec_from_json(const nlohmann::json& json);

// The beginning of the message of a program that cannot render all ranges at once.
inline constexpr const char* kRangesNotApart = "bounces cannot be taken apart";

// The tasks whose code the pixels depend on.
std::set<std::string> tasks_used(const Spec& spec);

// The command that makes the same picture in full size; with more than pt::kRound samples, with other noise.
std::string render_command(const Spec& spec, const std::string& output);

}  // namespace measure
