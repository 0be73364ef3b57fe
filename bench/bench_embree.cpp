// Compares the wide engine with Embree 3, its robust mode and tinybvh in one run: rays, whole pictures, threads, and which goals
// were reached. See docs/performance.md.
#include "bench/against_embree.h"
#include "bench/queries.h"
#include "pt/accel/kernel.h"
#include "pt/command_line.h"
#include "pt/error.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <CLI/CLI.hpp>

namespace {

namespace fs = std::filesystem;

// A scene of 14 primitives, and the course's scenes that are here.
std::vector<std::string> scene_files(const fs::path& folder) {
  std::vector<std::string> files{FIRSTLIGHT_ROOT "/scenes/box_spheres.dae"};
  for (const char* name : {"sky/CBbunny.dae", "sky/CBcoil.dae", "meshedit/maxplanck.dae"}) {
    const fs::path file = folder / name;
    if (fs::exists(file)) {
      files.push_back(file.string());
    } else {
      std::printf("%s was not found (--scenes FOLDER says where)\n", file.string().c_str());
    }
  }
  return files;
}

// bench/chart.gp reads rays.csv and writes rays.svg, both in the folder. Its commands go to
// gnuplot's input, so no shell sees the folder's name.
void draw_chart(const std::string& folder) {
  std::string quoted;
  for (const char c : folder) quoted += c == '\'' ? "''" : std::string(1, c);
  std::FILE* gnuplot = popen("gnuplot", "w");
  if (gnuplot == nullptr) return;
  std::fprintf(gnuplot, "folder = '%s'\nload '%s/bench/chart.gp'\n", quoted.c_str(),
               FIRSTLIGHT_ROOT);
  if (pclose(gnuplot) != 0) std::printf("no chart: gnuplot did not draw it\n");
}

std::string default_scenes() {
  const char* named = std::getenv("FIRSTLIGHT_COURSE_SCENES");
  return named != nullptr ? named : FIRSTLIGHT_ROOT "/../shared/scenes";
}

int run(pt::BenchSettings settings, const std::string& scenes, bool quick) {
  std::vector<int> blobs{1000, 10000, 100000, 1000000};
  if (quick) {
    settings = {settings.folder, 3, 20000, 160, 4};
    blobs.pop_back();
  }
  std::error_code failed;
  fs::create_directories(settings.folder, failed);
  if (failed) throw pt::Error(settings.folder + " cannot be made: " + failed.message());
  std::printf("kernel %s; CPU times; ratios are medians of rounds\n", pt::best_kernel().name);
  if (!pt::has_tinybvh) {
    std::printf("tinybvh is not compared: FIRSTLIGHT_TINYBVH named no folder with tiny_bvh.h\n");
  }

  const std::vector<std::string> files = scene_files(scenes);
  std::vector<pt::Goal> goals = pt::compare_rays(settings, blobs, files);
  draw_chart(settings.folder);
  std::vector<std::string> pictures{"10000", files.front()};
  if (files.size() > 1) pictures.insert(pictures.begin(), files[1]);
  const std::vector<pt::Goal> more = pt::compare_renders(settings, pictures);
  goals.insert(goals.end(), more.begin(), more.end());
  pt::Csv csv(settings.folder + "/goals.csv", "what,wanted,measured,verdict");
  pt::print_goals(goals, csv);
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // prints each line at once, also into a pipe
  CLI::App app(
      "Compares the wide engine with Embree 3 and tinybvh: rays, whole pictures, threads, memory.\n"
      "Writes rays.csv, rays.svg, renders.csv and goals.csv. About ten minutes.");
  pt::BenchSettings settings;
  std::string scenes = default_scenes();
  bool quick = false;
  app.add_option("--out", settings.folder, "folder for the files, made if it is missing")
      ->capture_default_str();
  app.add_option("--scenes", scenes, "folder of the course's scenes (sky/CBbunny.dae, ...)")
      ->capture_default_str();
  app.add_flag("--quick", quick, "takes only half a minute: fewer rounds and rays, small pictures");
  return pt::run_command_line(app, count, arguments, [&] { return run(settings, scenes, quick); });
}
