// ladder_rung OPTIONS: renders the requests of `ladder`, one per line, with the tasks linked here.
#include "measure/scene/options.h"
#include "measure/scene/pixels.h"
#include "measure/scene/rung.h"
#include "pt/end_of_program.h"

#include <iostream>

namespace measure::scene {
namespace {

int run(int argc, const char* const* argv) {
  const Options options = parse_ladder(argc, argv);
  const pt::LoadedScene loaded = load_scene(options);
  pt::View view{loaded.scene,
                frame_camera(loaded, options.framing, options.width, options.height),
                {},
                options.width,
                options.height};
  const std::vector<PixelAt> pixels =
      spread_pixels(options.width, options.height, options.pixels, options.seed);
  for (std::string line; std::getline(std::cin, line);) {
    const nlohmann::json request = nlohmann::json::parse(line);
    const Spec spec = spec_from_json(request.at(0));
    view.settings = spec.path;
    std::vector<PixelAt> some;
    for (std::size_t i = request.at(1); i < pixels.size(); i += request.at(2).get<std::size_t>()) {
      some.push_back(pixels[i]);
    }
    const RenderedPixels measured =
        measure(view, {spec.samples, spec.adaptive, spec.seed, options.threads}, some);
    const RungReply reply{measured.cpu_seconds, measured.rays, measured.all_samples(),
                          measured.mean};
    std::cout << nlohmann::json(reply) << std::endl;
  }
  return 0;
}

}  // namespace
}  // namespace measure::scene

int main(int argc, char** argv) {
  return pt::run_program([&] { return measure::scene::run(argc, argv); });
}
