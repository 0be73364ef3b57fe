#include "writeup/handbook.h"

#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/image_io.h"
#include "pt/image/sample_map.h"
#include "pt/image/tone_map.h"
#include "writeup/compose.h"

#include <algorithm>
#include <cstdlib>
#include <set>

#include <fmt/format.h>

namespace writeup {

namespace fs = std::filesystem;

namespace {

constexpr int kGap = 8;  // pixels, between the pictures of a figure
constexpr pt::Color8 kPaper{255, 255, 255};
constexpr std::size_t kMaxPicture = std::size_t{1} << 24;

// Renders keep their rows in float: a number in the middle between two levels can be rounded to either.
constexpr int kLevels = 1;

pt::Picture drawn(const Plan& plan, const Figure& figure, const Picture& picture) {
  if (const std::string why = plan.unavailable(picture); !why.empty()) throw pt::Error(why);
  const std::vector<Unit> units = plan.units(figure, picture);
  const Composed composed = compose(plan.store(), units);
  if (!composed.complete) throw pt::Error(composed.sum.failed);
  const pt::Film& film = composed.sum.film;
  if (picture.look == Look::radiance) return pt::tone_map(mean(film), picture.exposure);
  return sample_picture(sample_map(film, units.at(0).spec.samples));
}

pt::Picture side_by_side(const std::vector<pt::Picture>& pictures) {
  int width = -kGap, height = 0;
  for (const pt::Picture& picture : pictures) {
    width += picture.width + kGap;
    height = std::max(height, picture.height);
  }
  pt::Picture all(width, height, kPaper);
  int left = 0;
  for (const pt::Picture& picture : pictures) {
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) all.at(left + x, y) = picture.at(x, y);
    }
    left += picture.width + kGap;
  }
  return all;
}

pt::Picture drawn(const Plan& plan, const Figure& figure) {
  std::vector<pt::Picture> pictures;
  for (const Picture& picture : figure.pictures) pictures.push_back(drawn(plan, figure, picture));
  return pictures.size() == 1 ? pictures[0] : side_by_side(pictures);
}

// Calls the action for the picture of every figure. An exception becomes a problem.
template <class Action>
Problems for_each(const Plan& plan, const std::vector<const Figure*>& figures, Action action) {
  Problems problems;
  for (const Figure* figure : figures) {
    try {
      action(*figure, drawn(plan, *figure));
    } catch (const std::exception& error) {
      problems.push_back(fmt::format("{}: {}", figure->id, error.what()));
    }
  }
  return problems;
}

// Throws pt::Error if two pictures differ by more than rounding.
void expect_same(const pt::Picture& made, const pt::Picture& kept) {
  if (made.width != kept.width || made.height != kept.height) {
    throw pt::Error(fmt::format("its picture is {} x {} pixels and would be {} x {}", kept.width,
                                kept.height, made.width, made.height));
  }
  int most = 0;
  std::size_t other = 0;
  for (std::size_t i = 0; i < made.pixels.size(); ++i) {
    int off = 0;
    for (int c = 0; c < 3; ++c)
      off = std::max(off, std::abs(made.pixels[i][c] - kept.pixels[i][c]));
    other += off > kLevels ? 1 : 0;
    most = std::max(most, off);
  }
  if (other == 0) return;
  throw pt::Error(
      fmt::format("{} of {} pixels differ from the kept picture, by up to {} levels; "
                  "./run writeup --handbook makes it again",
                  other, made.pixels.size(), most));
}

}  // namespace

Problems write_handbook(const Plan& plan, const std::vector<const Figure*>& figures,
                        const fs::path& folder) {
  return for_each(plan, figures, [&](const Figure& figure, const pt::Picture& picture) {
    const fs::path file = folder / figure.file;
    const std::string bytes = pt::encode_png(picture);
    if (fs::exists(file) && pt::read_file(file, kMaxPicture) == bytes) return;
    fs::create_directories(file.parent_path());
    pt::write_file(file, bytes);
    fmt::print("{}\n", file.string());
  });
}

Problems check_handbook(const Plan& plan, const Catalogue& catalogue,
                        const std::vector<const Figure*>& figures, const fs::path& folder) {
  Problems problems = for_each(plan, figures, [&](const Figure& figure, const pt::Picture& made) {
    expect_same(made, pt::tone_map(pt::read_image(folder / figure.file), 1));
  });
  std::set<fs::path> planned, folders;
  for (const Figure& figure : catalogue.figures) {
    planned.insert(folder / figure.file);
    folders.insert((folder / figure.file).parent_path());
  }
  for (const fs::path& each : folders) {
    for (const fs::directory_entry& entry : fs::directory_iterator(each)) {
      const bool picture = entry.path().extension() == ".png";
      if (picture && !planned.contains(entry.path())) {
        problems.push_back(entry.path().string() + " is not in a plan: name it in handbook.json");
      }
    }
  }
  return problems;
}

}  // namespace writeup
