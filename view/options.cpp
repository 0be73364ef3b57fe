#include "view/options.h"

#include "pt/command_line.h"

#include <vector>

namespace view {

namespace {

const char* kFooter =
    "--from chooses the implementation of the tasks, as for render: --from student, or --from "
    "hit_bvh=student\n"
    "for one; the default is reference, and in a handout student.\n\n"
    "Examples:\n"
    "  ./run view scenes/box_spheres.dae\n"
    "  ./run view scenes/box_spheres.dae --from trace_path=student --pixel 240 100\n"
    "  ./run view scenes/box_spheres.dae --pixel 240 100 --export path.html\n";

}  // namespace

Options parse_options(int argc, const char* const* argv) {
  Options options;
  std::vector<int> size, pixel;
  int samples = 0, bounces = -1;
  CLI::App app("Shows the light of a scene in a browser, and what the paths of one pixel did.",
               "./run view");
  app.footer(kFooter);
  app.add_option("scene", options.scene, "Scene file (.dae)")->required();
  app.add_option("--pixel", pixel, "Show the paths of this pixel, counted from the bottom left")
      ->expected(2)
      ->allow_extra_args(false)
      ->type_name("X Y");
  app.add_option("-r,--size", size, "Width and height in pixels, default 480 360")
      ->expected(2)
      ->allow_extra_args(false)
      ->check(CLI::Range(16, 2048))
      ->type_name("W H");
  app.add_option("-s,--samples", samples, "Paths of the pixel, default 16")
      ->check(CLI::Range(1, 64));
  app.add_option("-m,--bounces", bounces, "How often light may bounce, default 5")
      ->check(CLI::Range(0, 100));
  app.add_option("--port", options.port, "Port of 127.0.0.1; default: any")
      ->check(CLI::Range(1, 65535));
  app.add_flag("--no-browser", options.no_browser, "Print the address, and open nothing");
  app.add_option("--export", options.page, "Write one page for this pixel, and end")
      ->type_name("FILE.html");
  app.add_flag("--lambertian", options.lambertian,
               "Treat mirrors, glass and the like as diffuse, albedo 0.5");
  app.add_option("--worker", options.worker, "Given by ./run")->required()->group("");
  app.add_option("--reference", options.reference, "Given by ./run")->group("");
  app.add_option("--tasks", options.tasks, "Given by ./run")->group("");
  app.add_option("--build", options.build, "Given by ./run")->group("");
  app.add_option("--mixture", options.from, "Given by ./run")->group("");
  pt::parse(app, argc, argv);
  options.settings["w"] = std::to_string(size.empty() ? 480 : size[0]);
  options.settings["h"] = std::to_string(size.empty() ? 360 : size[1]);
  options.settings["samples"] = std::to_string(samples > 0 ? samples : 16);
  options.settings["bounces"] = std::to_string(bounces >= 0 ? bounces : 5);
  if (!pixel.empty()) options.pixel = {pixel[0], pixel[1]};
  return options;
}

}  // namespace view
