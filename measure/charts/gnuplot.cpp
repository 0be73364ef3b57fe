#include "measure/charts/gnuplot.h"

#include "grader/service/process/run_command.h"
#include "pt/file.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace measure {

namespace fs = std::filesystem;

namespace {

const char* const kStyle = R"gp(set datafile separator ","
set terminal svg size 760,440 font "sans-serif,13"
set grid lc rgb "#c8ccd0"
set border lc rgb "#8a9299"
)gp";

constexpr double kRow = 0.05;  // the height of a name, as a part of the axis

}  // namespace

const char* ink_of(std::size_t method) {
  constexpr const char* kOthers[] = {ink::kVermilion, ink::kBlue, ink::kGreen, ink::kPink,
                                     ink::kSky};
  return kOthers[method % std::size(kOthers)];
}

std::string names_beside(std::vector<NamedEnd> ends, double low, double high) {
  std::string text =
      fmt::format("set key off\nset rmargin 27\nset yrange [{:.5g}:{:.5g}]\n", low, high);
  const double axis = std::log10(high / low), row = kRow * axis;
  std::ranges::sort(ends, {}, &NamedEnd::height);
  std::vector<double> rows;
  double below = std::log10(low) - row;
  for (const NamedEnd& end : ends) {
    rows.push_back(below = std::max(std::log10(std::clamp(end.height, low, high)), below + row));
  }
  double above = std::log10(high) + row;
  for (std::size_t i = rows.size(); i-- > 0;) rows[i] = above = std::min(rows[i], above - row);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    text +=
        fmt::format("set label \"{}\" at graph 1.02, first {:.5g} left tc rgb \"{}\" noenhanced\n",
                    ends[i].name, std::pow(10, rows[i]), ends[i].color);
  }
  return text;
}

void draw(const fs::path& folder, const std::string& name, const std::string& commands) {
  const std::string output = "set output \"" + name + ".svg\"\n";
  pt::write_file(folder / (name + ".gp"), kStyle + output + commands);
  const grader::process::Child child{{"/usr/bin/gnuplot", name + ".gp"},
                                     {"PATH=/usr/bin", "LANG=C.UTF-8"},
                                     {},
                                     folder.string(),
                                     {}};
  grader::process::run_command(child, std::chrono::seconds(20));
  fs::remove(folder / (name + ".gp"));
}

}  // namespace measure
