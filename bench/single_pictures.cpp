// Measures how often the verdict on one picture is wrong: right pictures of several scenes, formats and samplers, and pictures with 25 faults. Prints the
// tables of docs/verdicts.md.
#include "grader/pictures/single/verdict.h"
#include "pt/command_line.h"
#include "pt/image/tone_map.h"
#include "pt/render/choose_engine.h"
#include "pt/render/render_film.h"
#include "pt/scene/frame_camera.h"
#include "pt/scene/load_collada.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace {

using namespace grader::pictures;
using pt::Image;
using Outcome = SingleVerdict::Outcome;

int width = 72, height = 54;  // of all pictures

struct Scene {
  std::string name;
  pt::LoadedScene loaded;
  pt::View view(int from, int to) const {
    pt::PathSettings settings;
    settings.from = from;
    settings.to = to;
    return {loaded.scene, pt::frame_camera(loaded, pt::Framing::file, width, height), settings,
            width, height};
  }
};

std::unique_ptr<Scene> load(const std::string& file) {
  auto scene = std::make_unique<Scene>(Scene{file, pt::load_collada(file, {.lambertian = true})});
  pt::choose_engine(scene->loaded.scene, pt::Engine::wide, 4);
  return scene;
}

// A file of 8 bits, as SinglePicture holds it, or floats.
SinglePicture as_file(const Image& image, const Codec& codec) {
  if (!codec.eight_bits) return {false, image};
  Image codes(image.width, image.height);
  for (std::size_t i = 0; i < codes.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      codes.pixels[i][c] = pt::decode(static_cast<std::uint8_t>(codec.encode(image.pixels[i][c])));
    }
  }
  return {true, codes};
}

const std::vector<std::pair<std::string, Codec>> kFiles{
    {"floats", {false}},
    {"8 bits", {}},
    {"8 bits, sRGB", {true, 1, Curve::srgb}},
    {"8 bits, as the course", {true, 1.4142135623730951, Curve::gamma, true}}};

// A filter that is wider than a pixel.
Image filtered(const Image& image) {
  Image out = image;
  for (int y = 1; y + 1 < image.height; ++y) {
    for (int x = 1; x + 1 < image.width; ++x) {
      pt::Rgb sum = image.at(x, y) * 4;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        sum += image.at(x + dx, y + dy);
      out.at(x, y) = sum / 8;
    }
  }
  return out;
}

void false_alarms(const std::vector<std::unique_ptr<Scene>>& scenes, int pictures, int threads) {
  fmt::print("| right pictures | agrees | wrong | cannot say |\n|---|---|---|---|\n");
  std::map<std::string, std::map<Outcome, int>> table;
  std::uint64_t seed = 1;
  for (const auto& scene : scenes) {
    for (const int samples : {2, 4, 16, 64}) {
      const pt::View view = scene->view(0, 3);
      const SingleQuestion question{view, samples};
      const auto take = [&](int taken, int count) {
        seed += 1000;
        return render_ours(view, taken, count, seed, threads);
      };
      const std::vector<Image> ours = take(samples, kOwnPictures);
      const std::vector<Image> right = take(samples, pictures),
                               quiet = take(2 * samples, pictures / 2),
                               loud = take(std::max(1, (samples + 2) / 3), pictures / 2);
      const auto judge = [&](const std::string& kind, const Image& image, const Codec& codec) {
        const SingleVerdict verdict = judge_single(as_file(image, codec), question, ours);
        ++table[kind][verdict.outcome];
        if (verdict.outcome == Outcome::agrees) return;
        std::fprintf(stderr, "%s, %d samples, %s: %s\n", scene->name.c_str(), samples, kind.c_str(),
                     verdict.sentence.c_str());
      };
      for (const auto& [name, codec] : kFiles) {
        for (const Image& image : right) {
          judge(name, image, codec);
          judge(name + ", a wider filter", filtered(image), codec);
        }
        for (const Image& image : quiet) judge(name + ", half the variance", image, codec);
        if (samples < 4) continue;
        for (const Image& image : loud) judge(name + ", up to 3 times the variance", image, codec);
      }
      std::fprintf(stderr, "%s %d\n", scene->name.c_str(), samples);
    }
  }
  for (auto& [kind, row] : table) {
    fmt::print("| {} | {} | {} | {} |\n", kind, row[Outcome::agrees], row[Outcome::wrong],
               row[Outcome::cannot_say]);
  }
}

struct Fault {
  std::string name;
  std::string cause;  // a part of the sentence that is true; empty: no cause is
  std::function<Image(const Scene&, int samples, std::uint64_t seed)> make;
  bool no_gamma = false;
  double exposure = 1;
};

Image rendered(const pt::View& view, int samples, std::uint64_t seed) {
  return mean(pt::render_film(view, {samples, {}, seed, 1}).film);
}

Image rendered(const Scene& scene, int from, int to, int samples, std::uint64_t seed) {
  return rendered(scene.view(from, to), samples, seed);
}

// Emitted, direct and indirect light with factors.
Image sum(const Scene& scene, int samples, std::uint64_t seed, double direct, double indirect) {
  Image all = rendered(scene, 0, 0, samples, seed);
  const Image one = rendered(scene, 1, 1, samples, seed + 1),
              more = rendered(scene, 2, 3, samples, seed + 2);
  for (std::size_t i = 0; i < all.pixels.size(); ++i) {
    all.pixels[i] += one.pixels[i] * direct + more.pixels[i] * indirect;
  }
  return all;
}

Image each(Image image, const std::function<pt::Rgb(pt::Rgb, int, int)>& change) {
  const Image before = image;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) image.at(x, y) = change(before.at(x, y), x, y);
  }
  return image;
}

std::vector<Fault> faults() {
  std::vector<Fault> all;
  const auto factors = [&](const std::string& name, const std::string& cause, double direct,
                           double indirect) {
    all.push_back({name, cause, [=](const Scene& scene, int samples, std::uint64_t seed) {
                     return sum(scene, samples, seed, direct, indirect);
                   }});
  };
  constexpr double kPi = 3.14159265358979;
  factors("direct light missing", "direct light is missing", 0, 1);
  factors("direct light half", "direct light is half", .5, 1);
  factors("direct light twice", "direct light is twice", 2, 1);
  factors("direct light times pi", "direct light is pi", kPi, 1);
  factors("direct light without 1 / pi", "direct light is 1 / pi", 1 / kPi, 1);
  factors("direct light times 2 pi", "direct light is 2 pi", 2 * kPi, 1);
  factors("no indirect light", "indirect light is missing", 1, 0);
  factors("indirect light half", "indirect light is half", 1, .5);
  factors("indirect light twice", "indirect light is twice", 1, 2);
  factors("indirect light times pi", "indirect light is pi", 1, kPi);
  factors("roulette not divided", "roulette not divided", 1, .7);
  factors("reflected light half", "reflected light is half", .5, .5);
  factors("reflected light twice", "reflected light is twice", 2, 2);
  const auto changed = [&](const std::string& name, const std::string& cause,
                           const std::function<pt::Rgb(const Image&, int, int)>& change) {
    all.push_back({name, cause, [=](const Scene& scene, int samples, std::uint64_t seed) {
                     const Image right = rendered(scene, 0, 3, samples, seed);
                     return each(right, [&](pt::Rgb, int x, int y) { return change(right, x, y); });
                   }});
  };
  all.push_back({"the last bounce missing", "last bounce",
                 [](const Scene& scene, int samples, std::uint64_t seed) {
                   return rendered(scene, 0, 2, samples, seed);
                 }});
  changed("upside down", "upside down",
          [](const Image& i, int x, int y) { return i.at(x, height - 1 - y); });
  changed("mirrored", "mirrored",
          [](const Image& i, int x, int y) { return i.at(width - 1 - x, y); });
  changed("turned by 180 degrees", "180",
          [](const Image& i, int x, int y) { return i.at(width - 1 - x, height - 1 - y); });
  changed("black", "black", [](const Image&, int, int) { return pt::Rgb{}; });
  changed("red and blue exchanged", "", [](const Image& i, int x, int y) {
    const pt::Rgb p = i.at(x, y);
    return pt::Rgb{p.b, p.g, p.r};
  });
  changed("3 % too bright", "another brightness",
          [](const Image& i, int x, int y) { return i.at(x, y) * 1.03; });
  changed("a block 20 % darker", "", [](const Image& i, int x, int y) {
    return i.at(x, y) * (x >= 24 && x < 40 && y >= 30 && y < 46 ? .8 : 1);
  });
  changed("moved by three pixels", "",
          [](const Image& i, int x, int y) { return i.at(std::min(x + 3, width - 1), y); });
  changed("clamped at .5", "", [](const Image& i, int x, int y) {
    const pt::Rgb p = i.at(x, y);
    return pt::Rgb{std::min(p.r, .5), std::min(p.g, .5), std::min(p.b, .5)};
  });
  changed("a few fireflies", "too bright", [](const Image& i, int x, int y) {
    return x % 18 == 5 && y % 18 == 9 ? pt::Rgb{300, 300, 300} : i.at(x, y);
  });
  const auto other_scene = [&](const std::string& name, const std::string& cause,
                               const std::function<void(pt::Scene&)>& change) {
    all.push_back({name, cause, [=](const Scene& scene, int samples, std::uint64_t seed) {
                     pt::Scene other = scene.loaded.scene;
                     change(other);
                     pt::choose_engine(other, pt::Engine::wide, 4);
                     const pt::View view = scene.view(0, 3);
                     const pt::View spoiled{other, view.camera, view.settings, width, height};
                     return rendered(spoiled, samples, seed);
                   }});
  };
  other_scene("a sphere missing", "sphere around", [](pt::Scene& scene) {
    scene.primitives.spheres.pop_back();
    scene.material_of.pop_back();
  });
  other_scene("all spheres black", "every sphere is black", [](pt::Scene& scene) {
    scene.materials.push_back({"none", {}, {}, ""});
    for (std::size_t i = scene.primitives.triangles.size(); i < scene.material_of.size(); ++i) {
      scene.material_of[i] = static_cast<int>(scene.materials.size()) - 1;
    }
  });
  const auto other_camera = [&](const std::string& name,
                                const std::function<void(pt::Camera&)>& change) {
    all.push_back({name, "field of view", [=](const Scene& scene, int samples, std::uint64_t seed) {
                     pt::View view = scene.view(0, 3);
                     change(view.camera);
                     return rendered(view, samples, seed);
                   }});
  };
  other_camera("field of view 10 % smaller", [](pt::Camera& camera) {
    camera.hfov_deg *= .9;
    camera.vfov_deg *= .9;
  });
  other_camera("fields of view exchanged",
               [](pt::Camera& camera) { std::swap(camera.hfov_deg, camera.vfov_deg); });
  changed("no gamma", "no gamma", [](const Image& i, int x, int y) { return i.at(x, y); });
  all.back().no_gamma = true;
  changed("exposure 3", "another exposure",
          [](const Image& i, int x, int y) { return i.at(x, y); });
  all.back().exposure = 3;
  return all;
}

void power(const std::vector<std::unique_ptr<Scene>>& scenes, int pictures, int threads,
           const std::string& only, const std::vector<int>& all_samples) {
  fmt::print("\n| fault: found, named, named falsely | file |");
  std::string line = "\n|---|---|";
  for (const int samples : all_samples) {
    fmt::print(" {} samples |", samples);
    line += "---|";
  }
  fmt::print("{}\n", line);
  std::uint64_t seed = 1 << 20;
  int falsely = 0, all = 0;
  for (const Fault& fault : faults()) {
    if (fault.name.find(only) == std::string::npos) continue;
    for (const bool eight : {true, false}) {
      if (!eight && (fault.no_gamma || fault.exposure != 1)) continue;
      std::string row = fmt::format("| {} | {} |", fault.name, eight ? "8 bits" : "floats");
      for (const int samples : all_samples) {
        int found = 0, named = 0, wrong_name = 0, tried = 0;
        for (const auto& scene : scenes) {
          for (int i = 0; i < pictures; ++i, ++tried) {
            seed += 10;
            const Codec codec{eight, fault.exposure, fault.no_gamma ? Curve::linear : Curve::gamma};
            SingleQuestion question{scene->view(0, 3), samples, threads};
            question.seed = seed << 20;
            const SingleVerdict verdict =
                judge_single(as_file(fault.make(*scene, samples, seed), codec), question);
            found += verdict.outcome == Outcome::wrong;
            if (verdict.cause.empty()) continue;
            const bool is_true =
                !fault.cause.empty() && verdict.cause.find(fault.cause) != std::string::npos;
            named += is_true;
            wrong_name += !is_true;
            if (!is_true)
              std::fprintf(stderr, "FALSE %s: %s\n", fault.name.c_str(), verdict.cause.c_str());
          }
        }
        falsely += wrong_name;
        all += tried;
        row += fmt::format(" {} {} {} of {} |", found, named, wrong_name, tried);
      }
      fmt::print("{}\n", row);
      std::fflush(stdout);
    }
  }
  fmt::print("\n{} false names of {} pictures\n", falsely, all);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("How often the verdict on one picture is wrong", "./run bench pictures");
  int right = 12, wrong = 1, threads = 2;
  std::vector<std::string> files;
  for (const char* name :
       {"box_spheres", "large_light", "coloured_lights", "pale_room", "two_lights", "vase"}) {
    files.push_back(fmt::format("{}/scenes/{}.dae", FIRSTLIGHT_ROOT, name));
  }
  app.add_option("scenes", files, "COLLADA files; the first two are also spoiled");
  app.add_option("--right", right, "right pictures of each kind")->capture_default_str();
  app.add_option("--wrong", wrong, "pictures of each fault and scene")->capture_default_str();
  std::string only;
  std::vector<int> samples{16, 64, 256};
  app.add_option("--samples", samples, "of the spoiled pictures")->capture_default_str();
  app.add_option("--fault", only, "only faults with this in their names");
  app.add_option("--width", width)->capture_default_str();
  app.add_option("--height", height)->capture_default_str();
  app.add_option("-t,--threads", threads)->capture_default_str();
  return pt::run_command_line(app, argc, argv, [&] {
    std::vector<std::unique_ptr<Scene>> scenes;
    for (const std::string& file : files) scenes.push_back(load(file));
    if (right > 0) false_alarms(scenes, right, threads);
    if (scenes.size() > 2) scenes.resize(2);
    if (wrong > 0) power(scenes, wrong, threads, only, samples);
    return 0;
  });
}
