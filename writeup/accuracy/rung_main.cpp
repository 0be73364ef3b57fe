// ladder_rung OPTIONS: renders what `ladder` asks for, a line each, with the tasks linked here.
#include "writeup/accuracy/load.h"
#include "writeup/accuracy/pixels.h"
#include "writeup/accuracy/rung_wire.h"

#include <iostream>

namespace writeup::accuracy {
namespace {

RungReply render(const RungRequest& request, const pt::LoadedScene& loaded, const Options& options,
                 const std::vector<PixelAt>& pixels) {
  const pt::View view{loaded.scene,
                      frame_camera(loaded, options.framing, options.width, options.height),
                      request.path, options.width, options.height};
  std::vector<PixelAt> some;
  for (std::size_t i = request.first; i < pixels.size(); i += request.step) {
    some.push_back(pixels[i]);
  }
  RenderedPixels measured = measure(view, request.render, some);
  const long long samples = measured.all_samples();
  return {measured.cpu_seconds, measured.rays, samples, std::move(measured.mean)};
}

int run(int argc, const char* const* argv) {
  const Options options = parse_ladder(argc, argv);
  const pt::LoadedScene loaded = load_scene(options);
  const std::vector<PixelAt> pixels =
      spread_pixels(options.width, options.height, kSpreadPixels, options.seed);
  for (std::string line; std::getline(std::cin, line);) {
    std::cout << to_line(render(request_from(line), loaded, options, pixels)) << std::endl;
  }
  return 0;
}

}  // namespace
}  // namespace writeup::accuracy

int main(int argc, char** argv) {
  return writeup::accuracy::run_program(writeup::accuracy::run, argc, argv);
}
