#include "grader/report/html_picture.h"

#include "grader/report/embedded.h"
#include "grader/report/filled.h"
#include "grader/report/pictures.h"
#include "grader/results/summary.h"
#include "pt/error.h"
#include "pt/image/compare.h"
#include "pt/image/image_io.h"
#include "pt/image/tone_map.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace grader::report {

namespace {

using kainjow::mustache::data;

struct Map {
  std::string name, text;
  pt::Picture picture, bar;
  std::string low, high;
  bool outlined = false;  // with the cells that fail
};

data map_data(const Map& map) {
  data out;
  out.set("map_name", map.name);
  out.set("map_text", map.text);
  out.set("map_alt", map.name + ": " + map.text);
  out.set("map_png", png_address(map.picture));
  out.set("map_bar", png_address(map.bar));
  out.set("map_low", map.low);
  out.set("map_high", map.high);
  out.set("outlined", map.outlined);
  return out;
}

// Beyond this a relative error says nothing more: there should be almost no light.
constexpr double kMaxPercent = 1000;

std::string percent(double ratio) {
  if (!std::isfinite(ratio)) return "not a number";
  if (ratio > kMaxPercent / 100) return fmt::format("> +{} %", kMaxPercent);
  return fmt::format("{}{:.1f} %", ratio < 0 ? "\u2212" : "+", std::abs(100 * ratio));
}

data cells_data(const results::PictureResult& picture) {
  data cells{data::type::list};
  for (const results::FailingCell& cell : picture.cells) {
    data out;
    out.set("x", std::to_string(cell.x));
    out.set("y", std::to_string(cell.y));
    out.set("w", std::to_string(cell.width));
    out.set("h", std::to_string(cell.height));
    out.set("middle_x", std::to_string(cell.x + cell.width / 2));
    out.set("middle_y", std::to_string(cell.y + cell.height / 2));
    out.set("channel", cell.channel);
    out.set("cell_off_by", percent(cell.off_by));
    out.set("cell_evidence", fmt::format("{:.{}f}", cell.evidence, cell.evidence < 100 ? 1 : 0));
    cells.push_back(out);
  }
  return cells;
}

template <class Sized>
void check_sizes(const Sized& render, const Sized& golden) {
  if (render.width != golden.width || render.height != golden.height) {
    throw pt::Error(fmt::format("The render has {} x {} pixels, the golden {} x {}.", render.width,
                                render.height, golden.width, golden.height));
  }
}

// The common part of film_view and counts_view.
data view(const char* kind, int width, int height) {
  data out;
  out.set("kind", kind);
  out.set("width", std::to_string(width));
  out.set("height", std::to_string(height));
  for (const char* numbers : {"render_data", "golden_data", "noise_data"}) out.set(numbers, "");
  out.set("has_numbers", false);
  out.set("has_maps", false);
  out.set("bar", false);
  out.set("has_cells", false);
  out.set("render_label", "render");
  out.set("golden_label", "golden");
  return out;
}

data film_maps(const results::PictureResult& picture, const pt::Image& render,
               const pt::Image& golden) {
  const auto bar = [](double full) {
    return legend_bar([=](double t) { return pt::difference_color((2 * t - 1) * full, full); });
  };
  data maps{data::type::list};
  maps.push_back(map_data({"Difference", "of each pixel: blue too dark, orange too bright",
                           pt::difference_map(render, golden), bar(0.2), "\u221220 %", "+20 %"}));
  maps.push_back(
      map_data({"8 \u00d7 8 difference", "of the means of blocks, with less noise",
                block_difference_map(render, golden), bar(kBlockScale), "\u221210 %", "+10 %"}));
  if (picture.evidence.empty()) return maps;
  const pt::Image evidence = mean(pt::read_exr(picture.evidence));
  check_sizes(evidence, golden);
  maps.push_back(map_data(
      {"Evidence",
       picture.cells.empty() ? "against the render, in thresholds"
                             : "against the render, in thresholds; failing cells are outlined",
       evidence_map(evidence), legend_bar([](double t) { return evidence_color(2 * t); }), "0",
       "2 or more", true}));
  return maps;
}

// Maps show what is wrong, so a small page has none for right pictures.
bool has_maps(const results::PictureResult& picture, PageSize size) {
  return size == PageSize::full || picture.state != results::State::pass;
}

data film_view(const results::PictureResult& picture, PageSize size) {
  const pt::Film render = pt::read_exr(picture.render), golden = pt::read_exr(picture.golden);
  check_sizes(render, golden);
  const pt::Image a = mean(render), b = mean(golden);
  const double exposure = exposure_for(b);
  data out = view("film", a.width, a.height);
  out.set("render_png", png_address(pt::tone_map(a, exposure)));
  out.set("golden_png", png_address(pt::tone_map(b, exposure)));
  out.set("render_alt", "The submission's render of " + picture.recipe);
  out.set("golden_alt", "The golden of " + picture.recipe);
  if (size == PageSize::full) {
    out.set("render_data", embedded_pixels(render));
    out.set("golden_data", embedded_pixels(golden));
    out.set("noise_data", embedded_noise(render, golden));
    out.set("has_numbers", true);
  }
  out.set("compare_name", "Render over golden");
  out.set("compare_text", exposure == 1 ? "" : fmt::format("at exposure {:g}", exposure));
  out.set("has_maps", has_maps(picture, size));
  if (has_maps(picture, size)) out.set("maps", film_maps(picture, a, b));
  out.set("has_cells", !picture.cells.empty());
  out.set("cells", cells_data(picture));
  return out;
}

data counts_view(const results::PictureResult& picture, PageSize size) {
  const pt::SampleMap render = pt::read_counts(picture.counts);
  const pt::SampleMap golden = pt::read_counts(picture.golden_counts);
  check_sizes(render, golden);
  const int min = std::min(*std::min_element(render.counts.begin(), render.counts.end()),
                           *std::min_element(golden.counts.begin(), golden.counts.end()));
  const int max = std::max(render.max, golden.max);
  const auto colors = [](double t) {
    return pt::sample_color(static_cast<int>(1000 * t), 0, 1000);
  };
  data out = view("counts", render.width, render.height);
  out.set("render_png", png_address(count_map(render, min, max)));
  out.set("golden_png", png_address(count_map(golden, min, max)));
  out.set("render_alt", "The submission's sample map of " + picture.recipe);
  out.set("golden_alt", "The reference's sample map of " + picture.recipe);
  out.set("golden_label", "reference");
  if (size == PageSize::full) {
    out.set("render_data", embedded_counts(render));
    out.set("golden_data", embedded_counts(golden));
    out.set("has_numbers", true);
  }
  out.set("compare_name", "Sample map");
  out.set("compare_text", "samples per pixel, the brighter the more");
  out.set("bar", true);
  out.set("low", std::to_string(min));
  out.set("high", std::to_string(max));
  out.set("bar_png", png_address(legend_bar(colors)));
  data maps{data::type::list};
  maps.push_back(map_data({"Difference", "of the counts: blue too few, orange too many",
                           count_difference_map(render, golden),
                           legend_bar([](double t) { return pt::difference_color(0.4 * t - 0.2); }),
                           "\u221220 %", "+20 %"}));
  out.set("has_maps", has_maps(picture, size));
  if (has_maps(picture, size)) out.set("maps", maps);
  return out;
}

// One line about the rendering.
std::string made(const results::PictureResult& picture) {
  std::string text = picture.integrated ? "Rendered with all tasks of the submission"
                                        : "Rendered with this task of the submission and the "
                                          "reference elsewhere";
  if (picture.samples > 0) {
    text += fmt::format("; {} samples per pixel in {} round{}", picture.samples, picture.rounds,
                        picture.rounds == 1 ? "" : "s");
  }
  if (picture.noise > 0) {
    text += fmt::format("; {:.2f} times the variance of the reference", picture.noise);
  }
  if (picture.seconds > 0) text += fmt::format("; {:.1f} s", picture.seconds);
  return text + ".";
}

// One sentence on how sure the verdict is; the table has the other blocks.
std::string evidence(const results::PictureResult& picture) {
  if (picture.cells.empty()) return "";
  const results::FailingCell& first = picture.cells[0];
  const std::string which =
      picture.cells.size() == 1
          ? "The block that fails"
          : fmt::format("The first of {} blocks that fail", picture.cells.size());
  return fmt::format("{} ({}x{} at {}, {}) is off by {}: {:.{}f} times what noise explains.", which,
                     first.width, first.height, first.x, first.y, percent(first.off_by),
                     first.evidence, first.evidence < 100 ? 1 : 0);
}

}  // namespace

const char* tone(results::State state) {
  if (state == results::State::pass) return "pass";
  if (state == results::State::too_noisy) return "noisy";
  return results::is_fault(state) ? "fault" : "quiet";
}

std::string Places::taken(const results::PictureResult& picture, const std::string& place) {
  std::string shown;
  for (const std::string* path : {&picture.render, &picture.golden, &picture.evidence,
                                  &picture.counts, &picture.golden_counts}) {
    shown += *path + '\0';
  }
  for (const results::FailingCell& cell : picture.cells) {
    shown += fmt::format("{} {} {} {} {} {} {}\n", cell.x, cell.y, cell.width, cell.height,
                         cell.channel, cell.off_by, cell.evidence);
  }
  const auto [entry, is_new] = places_.try_emplace(shown, place);
  return is_new ? "" : entry->second;
}

data picture_data(const results::PictureResult& picture, const std::string& slug, Places& places) {
  const bool has_views = !picture.render.empty() || !picture.counts.empty();
  const std::string place =
      has_views ? places.taken(picture, slug + "." + picture.recipe) : std::string();
  data out;
  out.set("recipe", picture.recipe);
  out.set("title", picture.title);
  out.set("picture_tone", tone(picture.state));
  out.set("picture_symbol", results::symbol(picture.state));
  out.set("picture_words", results::words(picture.state));
  out.set("same", place.empty() ? data(false) : data(place));
  out.set("picture_points", std::to_string(picture.points));
  out.set("picture_max", std::to_string(picture.max_points));
  set_text(out, "sentence", picture.text);
  set_text(out, "evidence", evidence(picture));
  out.set("made", picture.render.empty() ? "" : made(picture));
  set_text(
      out, "see_it",
      results::is_fault(picture.state) && has_views ? results::how_to_look(slug, picture) : "");
  data views{data::type::list};
  std::string problem;
  const auto add = [&](data (*make)(const results::PictureResult&, PageSize)) {
    try {
      views.push_back(make(picture, places.size()));
    } catch (const pt::Error& error) {
      problem += fmt::format("{}It cannot be shown. {}", problem.empty() ? "" : " ", error.what());
    }
  };
  if (place.empty() && !picture.render.empty()) add(film_view);
  if (place.empty() && !picture.counts.empty()) add(counts_view);
  out.set("views", views);
  out.set("problem", problem.empty() ? data(false) : data(problem));
  return out;
}

}  // namespace grader::report
