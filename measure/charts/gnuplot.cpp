#include "measure/charts/gnuplot.h"

#include "grader/service/process/run_command.h"
#include "pt/file.h"

namespace measure {

namespace fs = std::filesystem;

namespace {

const char* const kStyle = R"gp(set datafile separator ","
set terminal svg size 760,440 font "sans-serif,13"
set grid lc rgb "#c8ccd0"
set border lc rgb "#8a9299"
)gp";

// ColorBrewer's sequential schemes without their lightest colours (Harrower and Brewer 2003).
const char* const kColors[3][kShades] = {
    {"#08306b", "#08519c", "#2171b5", "#4292c6", "#6baed6", "#9ecae1"},
    {"#00441b", "#006d2c", "#238b45", "#41ab5d", "#74c476", "#a1d99b"},
    {"#67000d", "#a50f15", "#cb181d", "#ef3b2c", "#fb6a4a", "#fc9272"}};

}  // namespace

const char* color(Hue hue, int shade) { return kColors[static_cast<int>(hue)][shade % kShades]; }

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
