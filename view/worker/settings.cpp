#include "view/worker/settings.h"

#include "pt/error.h"
#include "pt/number.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace view {

namespace {

// The words of a request that are options of ./run render. With adaptive sampling, its --samples is the most of a pixel.
const std::map<std::string, std::string> kOptions{{"show", "--show"},
                                                  {"bounce", "--bounce"},
                                                  {"bounces", "--bounces"},
                                                  {"engine", "--engine"},
                                                  {"light_samples", "--light-samples"},
                                                  {"survival", "--survival"},
                                                  {"seed", "--seed"},
                                                  {"leaf", "--leaf"},
                                                  {"camera", "--camera"}};

const std::map<std::string, Shown> kShown{{"light", Shown::light},
                                          {"boxes", Shown::boxes},
                                          {"primitives", Shown::primitives_tested},
                                          {"samples", Shown::samples},
                                          {"deviation", Shown::deviation},
                                          {"points", Shown::points},
                                          {"primitive", Shown::primitive},
                                          {"distance", Shown::distance}};

constexpr int kMinSide = 16, kMaxSide = 2048, kMaxBounces = 100, kMaxSamples = 1024,
              kMaxAdaptive = 1 << 14;

int whole_number(const std::string& name, const std::string& word, int least, int most) {
  const auto value = pt::number_in<int>(word);
  if (!value || *value < least || *value > most) {
    throw pt::Error("'" + name + "' takes a whole number from " + std::to_string(least) + " to " +
                    std::to_string(most) + ", and not '" + word + "'");
  }
  return *value;
}

pt::Vec3 vector(const std::string& name, const std::string& word) {
  const std::vector<double> v = numbers_of(name, word, 3);
  return {v[0], v[1], v[2]};
}

pt::RenderOptions render_options(const Query& query) {
  std::vector<std::string> words{"render", "scene.dae"};
  for (const auto& [name, option] : kOptions) {
    const auto found = query.find(name);
    if (found != query.end()) words.push_back(option + "=" + found->second);
  }
  if (query.contains("hemisphere")) words.emplace_back("--hemisphere");
  if (query.contains("adaptive")) {
    const std::string& three = query.at("adaptive");
    const std::size_t first = three.find(','), second = three.find(',', first + 1);
    if (second == std::string::npos ||
        three.find_first_not_of("0123456789.,") != std::string::npos) {
      throw pt::Error(
          "'adaptive' takes the most samples, a batch and a tolerance, as in "
          "1024,32,0.05, and not '" +
          three + "'");
    }
    words.insert(words.end(),
                 {"--samples=" + three.substr(0, first), "--adaptive",
                  three.substr(first + 1, second - first - 1), three.substr(second + 1)});
  }
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  pt::RenderOptions options = pt::parse_options(static_cast<int>(argv.size()), argv.data());
  if (options.adaptive && options.adaptive->max_samples > kMaxAdaptive) {
    throw pt::Error("'adaptive' takes at most " + std::to_string(kMaxAdaptive) + " samples");
  }
  return options;
}

std::optional<Eye> eye_of(const Query& query) {
  if (!query.contains("eye")) return std::nullopt;
  for (const char* name : {"target", "up"}) {
    if (!query.contains(name))
      throw pt::Error("'eye' is given without '" + std::string(name) + "'");
  }
  const Eye eye{vector("eye", query.at("eye")), vector("target", query.at("target")),
                vector("up", query.at("up"))};
  if (!(length(cross(eye.up, eye.position - eye.target)) > 0)) {
    throw pt::Error("the camera has no direction: 'eye', 'target' and 'up' lie on one line");
  }
  return eye;
}

}  // namespace

std::vector<double> numbers_of(const std::string& name, const std::string& word, int count) {
  std::vector<double> numbers;
  std::string_view rest = word;
  for (int i = 0; i < count; ++i) {
    const std::size_t end = i + 1 == count ? rest.size() : std::min(rest.find(','), rest.size());
    const auto number = pt::number_in<double>(rest.substr(0, end));
    if (!number || !std::isfinite(*number)) {
      throw pt::Error("'" + name + "' takes " + std::to_string(count) +
                      " numbers with commas, as in 0,1,2.5, and not '" + word + "'");
    }
    numbers.push_back(*number);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return numbers;
}

Settings settings_of(const Query& query) {
  Settings settings;
  const auto known = [](const std::string& name) {
    // With `beside`, a picture begins anew, together with the one that it is compared with.
    static const std::array<const char*, 14> kOwn{
        "samples", "first", "w",     "h",          "x",        "y",      "eye",
        "target",  "up",    "shown", "hemisphere", "adaptive", "beside", "whole"};
    for (const char* own : kOwn) {
      if (name == own) return true;
    }
    return kOptions.contains(name);
  };
  for (const auto& setting : query) {
    if (!known(setting.first)) throw pt::Error("there is no setting '" + setting.first + "'");
  }
  const auto number = [&](const char* name, int usual, int least, int most) {
    const auto found = query.find(name);
    return found == query.end() ? usual : whole_number(name, found->second, least, most);
  };
  settings.render = render_options(query);
  settings.render.width = number("w", 480, kMinSide, kMaxSide);
  settings.render.height = number("h", 360, kMinSide, kMaxSide);
  number("bounces", 0, 0, kMaxBounces);
  settings.render.samples = number("samples", settings.render.samples, 1, kMaxSamples);
  number("light_samples", 1, 1, kMaxSamples);
  settings.x = number("x", 0, 0, settings.render.width - 1);
  settings.y = number("y", 0, 0, settings.render.height - 1);
  settings.first = number("first", 0, 0, kMaxAdaptive);
  settings.eye = eye_of(query);
  settings.whole = query.contains("whole");
  if (query.contains("shown")) {
    const auto found = kShown.find(query.at("shown"));
    if (found == kShown.end()) throw pt::Error("nothing is shown as '" + query.at("shown") + "'");
    settings.shown = found->second;
  }
  return settings;
}

pt::View view_of(const pt::LoadedScene& loaded, const Settings& settings) {
  const pt::RenderOptions& render = settings.render;
  // The course's camera cuts a window of so many pixels: a small one would show a part of the scene.
  const bool is_cut = settings.whole && render.framing == pt::Framing::course;
  const double scale = is_cut ? std::max({1.0, 480.0 / render.width, 360.0 / render.height}) : 1.0;
  const auto scaled = [&](int side) { return static_cast<int>(std::lround(scale * side)); };
  pt::Camera camera =
      frame_camera(loaded, render.framing, scaled(render.width), scaled(render.height));
  if (settings.eye) {
    const pt::Vec3 z = normalize(settings.eye->position - settings.eye->target);
    const pt::Vec3 x = normalize(cross(settings.eye->up, z));
    camera.position = settings.eye->position;
    camera.camera_to_world = {x, cross(z, x), z};
  }
  return {loaded.scene, camera, path_settings(render), render.width, render.height};
}

}  // namespace view
