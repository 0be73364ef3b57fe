#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace measure {

// Draws <folder>/<name>.svg with gnuplot, in the style of the write-up, from commands that read
// their numbers in that folder, and the same as <name>.pdf for papers. It is narrow enough for a phone. Does nothing
// without gnuplot. A caption, which has to be understood without the page around the chart, becomes the description of the SVG,
// and beside the PDF there is a <name>.tex with it.
void draw(const std::filesystem::path& folder, const std::string& name, const std::string& commands,
          const std::string& caption = "");

// A figure that a LaTeX file \inputs: these pictures side by side, and the caption.
std::string latex_figure(const std::vector<std::string>& pictures, const std::string& caption);

// The model of this machine's processor without its frequency, for charts of times; empty where the system does not say it.
std::string processor();
// "processor seconds", with it: the label of an axis.
std::string processor_seconds();

// The colours of all charts, which people with any kind of sight tell apart (Okabe and Ito 2008). The
// reference, or what the others are compared with, is black, and somebody's own code orange. Hemisphere
// sampling is vermilion in every chart, other chances of survival green, other numbers of light samples
// sky or pink, and adaptive sampling blue.
namespace ink {
inline constexpr const char *kBlack = "#000000", *kOrange = "#e69f00", *kBlue = "#0072b2",
                            *kVermilion = "#d55e00", *kGreen = "#009e73", *kPink = "#cc79a7",
                            *kSky = "#56b4e9", *kGray = "#8a9299";
}
// The colour and gnuplot's mark of the code that is the i-th of a user's own, at most four.
struct OwnInk {
  const char* color;
  int mark;
};
OwnInk own_ink(std::size_t i);

// Another colour for a method: always the same for its name, unless that one is taken. If all are
// taken, it has the colour of another method.
const char* ink_of(const std::string& name, const std::vector<std::string>& taken);

// The end of a plot: invisible marks, at which a page shows "<name>: <value> ± <error> at <place>" under
// the pointer. Numbers are expressions of the plot's data; `error` may be empty.
struct Values {
  std::string data;  // "\"x.csv\" index 2 skip 1"
  std::string name, place, height, value, error;
};
std::string under_the_pointer(const Values& values);

// Names of lines right of a chart without a key, each at the height of its line's end, with room for
// a name between two. The upward axis is logarithmic, from `low` to `high`.
struct NamedEnd {
  std::string name, color;
  double height;
};
std::string names_beside(std::vector<NamedEnd> ends, double low, double high);

}  // namespace measure
