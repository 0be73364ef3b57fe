#pragma once

#include "pt/render/options.h"
#include "pt/scene/load_collada.h"
#include "pt/scene/view.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace view {

// The words of a request, by name.
using Query = std::map<std::string, std::string>;

// A camera that was moved away from where the file has it.
struct Eye {
  pt::Vec3 position, target, up;
};

// What a value of a pixel is: light, or a number that is shown in false colours.
enum class Shown {
  light,
  boxes,
  primitives_tested,
  samples,
  deviation,
  points,
  primitive,
  distance
};

struct Settings {
  pt::RenderOptions render;
  std::optional<Eye> eye;
  bool whole = false;  // a smaller picture than the usual one shows as much of the scene
  Shown shown = Shown::light;
  int x = 0, y = 0;  // a pixel, as the tasks count: from the bottom left
  int first = 0;     // the first sample of it whose path is kept
};

// Reads a request, whose words are options of ./run render. Throws pt::Error with one sentence if one of them cannot be used.
Settings settings_of(const Query& query);

// The numbers of a word such as 0,1,2.5. Throws pt::Error if they are not `count` finite ones.
std::vector<double> numbers_of(const std::string& name, const std::string& word, int count);

pt::View view_of(const pt::LoadedScene& loaded, const Settings& settings);

}  // namespace view
