// A request of the view's page: a setting and its value on each line.
#include "pt/error.h"
#include "tests/fuzz/input.h"
#include "view/worker/settings.h"

#include <sstream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  std::istringstream lines{std::string(fuzz::as_text(bytes, size))};
  view::Query query;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = std::min(line.find('='), line.size());
    query.emplace(line.substr(0, equals), line.substr(std::min(equals + 1, line.size())));
  }
  try {
    const view::Settings settings = view::settings_of(query);
    const pt::RenderOptions& render = settings.render;
    fuzz::expect(render.width >= 16 && render.width <= 2048 && render.height >= 16 &&
                 render.height <= 2048);
    fuzz::expect(settings.x >= 0 && settings.x < render.width && settings.y >= 0 &&
                 settings.y < render.height);
    fuzz::expect(render.samples >= 1 && (render.adaptive || render.samples <= 1024));
    pt::LoadedScene loaded;
    loaded.scene.primitives.spheres.push_back({{0, 0, 0}, 1});
    const pt::View view = view_of(loaded, settings);
    fuzz::expect(!settings.eye || view.camera.position == settings.eye->position);
  } catch (const pt::Error& error) {
    fuzz::expect_reason(error);
  }
  return 0;
}
