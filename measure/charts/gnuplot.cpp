#include "measure/charts/gnuplot.h"

#include "grader/service/process/run_command.h"
#include "pt/file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <regex>
#include <utility>

#include <fmt/format.h>

namespace measure {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxChart = std::size_t{1} << 24;

const char* const kStyle = R"gp(set datafile separator ","
set terminal svg size 520,440 font "sans-serif,13"
set grid lc rgb "#c8ccd0"
set border lc rgb "#8a9299"
)gp";

constexpr double kRow = 0.05;  // the height of a name, as a part of the axis

// A number of a name that is the same on every machine (FNV-1a); of "half b" and half_b the same.
std::size_t number_of(const std::string& name) {
  std::uint32_t number = 2166136261U;
  for (const char c : name) {
    number = (number ^ static_cast<unsigned char>(c == '_' ? ' ' : c)) * 16777619U;
  }
  return number >> 8;
}

// Returns whether gnuplot has drawn.
bool run_gnuplot(const fs::path& folder, const std::string& name, const std::string& commands) {
  const fs::path file = folder / (name + ".gp");
  pt::write_file(file, commands);
  const grader::process::Child child{{"/usr/bin/gnuplot", file.filename().string()},
                                     {"PATH=/usr/bin", "LANG=C.UTF-8"},
                                     {},
                                     folder.string(),
                                     {}};
  const bool is_drawn = grader::process::run_command(child, std::chrono::seconds(20)).ok();
  fs::remove(file);
  return is_drawn;
}

// The commands of an SVG, for a PDF of the same size: 96 pixels are an inch.
std::string for_paper(const std::string& commands) {
  static const std::regex output(R"re(set output "(.*)\.svg")re");
  static const std::regex terminal(
      R"re(set terminal svg size ([0-9]+),([0-9]+) font "sans-serif,13")re");
  std::string text = std::regex_replace(commands, output, "set output \"$1.pdf\"");
  for (std::smatch found; std::regex_search(text, found, terminal);) {
    text.replace(
        found.position(), found.length(),
        fmt::format("set terminal pdfcairo size {:.3f}in,{:.3f}in font \"sans-serif,9.75\"",
                    std::stoi(found[1]) / 96.0, std::stoi(found[2]) / 96.0));
  }
  return text;
}

// Each text of `signs` is replaced by the one beside it.
using Signs = std::vector<std::pair<std::string, std::string>>;
std::string with_signs(const std::string& text, const Signs& signs) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const auto found = std::ranges::find_if(signs, [&](const auto& sign) {
      return text.compare(at, sign.first.size(), sign.first) == 0;
    });
    out += found == signs.end() ? std::string(1, text[at]) : found->second;
    at += found == signs.end() ? 1 : found->first.size();
  }
  return out;
}

std::string as_latex(const std::string& text) {
  static const Signs signs{{"\\", "\\textbackslash{}"},
                           {"{", "\\{"},
                           {"}", "\\}"},
                           {"$", "\\$"},
                           {"&", "\\&"},
                           {"#", "\\#"},
                           {"%", "\\%"},
                           {"_", "\\_"},
                           {"^2", "$^2$"},
                           {"^", "\\^{}"},
                           {"~", "\\~{}"},
                           {"\u00d7", "$\\times$"},
                           {"\u00b1", "$\\pm$"},
                           {"\u00b2", "$^2$"},
                           {"<", "$<$"},
                           {">", "$>$"},
                           {"\u03c3", "$\\sigma$"},
                           {"\u03a3", "$\\Sigma$"},
                           {"\u00b7", "$\\cdot$"}};
  return with_signs(text, signs);
}

// gnuplot's own titles name its commands, and its texts under the pointer need a script.
std::string for_pages(std::string svg, const std::string& caption) {
  static const std::regex own("<title>[^<]*</title>|<desc>[^<]*</desc>");
  static const std::regex scripted(
      R"re(onmousemove="gnuplot_svg.showHypertext\(evt,'([^"]*)'\)" onmouseout="[^"]*">)re");
  svg = std::regex_replace(std::regex_replace(svg, own, ""), scripted, "><title>$1</title>");
  const std::size_t head = svg.find('>', svg.find("<svg"));
  if (caption.empty() || head == svg.npos) return svg;
  const std::string text = with_signs(caption, {{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}});
  return svg.insert(head + 1, "\n<desc>" + text + "</desc>");
}

}  // namespace

const char* ink_of(const std::string& name, const std::vector<std::string>& taken) {
  constexpr const char* kOthers[] = {ink::kVermilion, ink::kBlue, ink::kGreen, ink::kPink,
                                     ink::kSky};
  constexpr std::size_t kCount = std::size(kOthers);
  const std::size_t first = number_of(name);
  for (std::size_t step = 0; step < kCount; ++step) {
    const char* const color = kOthers[(first + step) % kCount];
    if (std::ranges::count(taken, color) == 0) return color;
  }
  return kOthers[first % kCount];
}

std::string under_the_pointer(const Values& values) {
  std::string words, numbers = values.value;
  for (const char c : values.name) words += c == '%' ? "%%" : c == '"' ? "'" : std::string(1, c);
  words += ": %.3g";
  if (!values.error.empty()) {
    words += " ± %.1g";
    numbers += ", " + values.error;
  }
  return fmt::format(
      ", {} using ({}):({}):(sprintf(\"{} at %.3g\", {}, {})) with labels hypertext point pt 7 ps "
      ".9 "
      "lc rgb \"#ff000000\" notitle",
      values.data, values.place, values.height, words, numbers, values.place);
}

std::string names_beside(std::vector<NamedEnd> ends, double low, double high) {
  std::size_t longest = 0;
  for (const NamedEnd& end : ends) longest = std::max(longest, end.name.size());
  std::string text = fmt::format("set key off\nset rmargin {:.1f}\nset yrange [{:.5g}:{:.5g}]\n",
                                 2 + 0.85 * static_cast<double>(longest), low, high);
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

OwnInk own_ink(std::size_t i) {
  constexpr OwnInk kInks[] = {
      {ink::kOrange, 5}, {ink::kPink, 9}, {ink::kSky, 11}, {ink::kGreen, 13}};
  return kInks[i % std::size(kInks)];
}

std::string latex_figure(const std::vector<std::string>& pictures, const std::string& caption) {
  std::string text =
      "% For \\input, with \\usepackage{graphicx}. Where this file lies in another folder: "
      "\\graphicspath{{folder/}}\n\\begin{figure}\n  \\centering\n";
  // Three beside each other can still be seen.
  const double width = .99 / static_cast<double>(std::clamp<std::size_t>(pictures.size(), 1, 3));
  for (const std::string& picture : pictures) {
    text += fmt::format("  \\includegraphics[width={:.2f}\\linewidth]{{{}}}\n", width, picture);
  }
  return text + fmt::format("  \\caption{{{}}}\n\\end{{figure}}\n", as_latex(caption));
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    const std::string model = line.substr(line.find(": ") + 2);
    return model.substr(0, model.find(" @"));
  }
  return "";
}

std::string processor_seconds() {
  const std::string model = processor();
  return "processor seconds" + (model.empty() ? "" : "\\n{/*0.8 " + model + "}");
}

void draw(const fs::path& folder, const std::string& name, const std::string& commands,
          const std::string& caption) {
  const std::string output = "set output \"" + name + ".svg\"\n", svg = kStyle + output + commands;
  const fs::path made = folder / (name + ".svg"), paper = folder / (name + ".pdf");
  if (!run_gnuplot(folder, name, svg)) {
    fs::remove(made);  // gnuplot leaves an empty one
  } else if (fs::exists(made)) {
    pt::write_file(made, for_pages(pt::read_file(made, kMaxChart), caption));
  }
  if (!fs::exists(made)) return;
  if (!run_gnuplot(folder, name, for_paper(svg))) {
    fs::remove(paper);
  } else if (!caption.empty()) {
    pt::write_file(folder / (name + ".tex"), latex_figure({paper.filename()}, caption));
  }
}

}  // namespace measure
