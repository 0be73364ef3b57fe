// Draws the pictures of docs/four_bugs.md: what the judge rendered with each bug, the golden, and
// where they differ, as an SVG with the pixels in it; and prints what the report says.
#include "grader/report/embedded.h"
#include "grader/report/pictures.h"
#include "grader/results/read_json.h"
#include "grader/self_check/four_bugs.h"
#include "pt/error.h"
#include "pt/image/image_io.h"
#include "pt/image/tone_map.h"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>

namespace {

using namespace grader;
using namespace grader::self_check;

constexpr int kPanel = 192, kGap = 8, kLine = 18;  // all wide and high in pixels of the drawing

struct Panel {
  std::string title;
  pt::Picture picture;
};

std::string svg(const std::vector<Panel>& panels,
                const std::vector<results::FailingCell>& outlined) {
  const int scale = kPanel / panels[0].picture.width;
  const int width = scale * panels[0].picture.width, height = scale * panels[0].picture.height;
  const int step = width + kGap;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" font-family=\"sans-serif\" font-size=\"12\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      static_cast<int>(panels.size()) * step - kGap, height + kLine);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const int left = static_cast<int>(i) * step;
    out += fmt::format(
        "<image x=\"{}\" width=\"{}\" height=\"{}\" style=\"image-rendering:pixelated\" "
        "href=\"{}\"/>\n<text x=\"{}\" y=\"{}\">{}</text>\n",
        left, width, height, report::png_address(panels[i].picture), left, height + kLine - 4,
        panels[i].title);
  }
  const int last = static_cast<int>(panels.size() - 1) * step;
  for (const results::FailingCell& cell : outlined) {
    out += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#d95f02\"/>\n",
        last + scale * cell.x, scale * cell.y, scale * cell.width, scale * cell.height);
  }
  return out + "</svg>\n";
}

std::string drawn(const results::PictureResult& picture) {
  if (!picture.counts.empty()) {
    const pt::SampleMap render = pt::read_counts(picture.counts);
    const pt::SampleMap golden = pt::read_counts(picture.golden_counts);
    const int min = *std::min_element(golden.counts.begin(), golden.counts.end());
    return svg({{"samples per pixel, with the bug", report::count_map(render, min, golden.max)},
                {"of the reference", report::count_map(golden, min, golden.max)},
                {"blue too few, orange too many", report::count_difference_map(render, golden)}},
               {});
  }
  const pt::Image render = mean(pt::read_exr(picture.render));
  const pt::Image golden = mean(pt::read_exr(picture.golden));
  const double exposure = report::exposure_for(golden);
  return svg({{"with the bug", pt::tone_map(render, exposure)},
              {"golden", pt::tone_map(golden, exposure)},
              {"blue too dark, orange too bright", report::block_difference_map(render, golden)},
              {"evidence, what fails outlined",
               report::evidence_map(mean(pt::read_exr(picture.evidence)))}},
             picture.cells);
}

// Its picture into the folder, its report to the screen.
void draw(const Bug& bug, const std::filesystem::path& folder) {
  const Submission submission(bug.solution);
  put(bug, submission);
  const Outcome outcome = submission.grade({bug.task}, kCallLimit);
  const results::Results results =
      results::results_from_json(outcome.results.dump(), std::string(bug.solution) + ".json");
  for (const results::PictureResult& picture : results.tasks.at(0).pictures) {
    if (picture.recipe != bug.recipe) continue;
    std::ofstream file(folder / (std::string(bug.solution) + ".svg"));
    if (!(file << drawn(picture))) throw pt::Error(folder.string() + " cannot be written to");
  }
  fmt::print("## {}\n{}\n", bug.title, outcome.output);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw pt::Error("say where to: draw_four_bugs docs/four_bugs");
    std::filesystem::create_directories(argv[1]);
    for (const Bug& bug : kFourBugs) draw(bug, argv[1]);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
