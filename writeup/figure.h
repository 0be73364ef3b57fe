#pragma once

#include "measure/charts/numbers.h"
#include "writeup/markdown.h"
#include "writeup/plan.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

// A figure for a page: files, and words about them.

namespace writeup {

struct Shown {
  std::string id, label;
  std::string file;  // without extension; .png, .exr and .js are there, or .png and .csv for a map
  std::string kind;  // "film", "map", or "" where there is no picture
  int width = 0, height = 0;
  std::string note;       // "partial", or the obstacle
  std::string facts;      // "s = 16, l = 8, m = 1; 4.2 s"
  std::string command;    // renders it alone
  std::string low, high;  // the ends of a map's colours
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Shown, id, label, file, kind, width, height, note, facts,
                                   command, low, high)

struct Drawn {
  std::vector<Shown> pictures;
  std::vector<std::string> columns;            // of a table
  std::vector<std::vector<std::string>> rows;  // of the table; the first cell is the row's head
  std::vector<std::string> charts, tables;     // files: .svg; and .csv, or a chart as .pdf
  std::vector<std::string> problems;           // reasons for missing parts, a sentence each
  std::map<std::string, std::string> numbers;  // "l16.seconds": "4.2"
  double seconds = 0;                          // of processor time
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Drawn, pictures, columns, rows, charts, tables, problems,
                                   numbers, seconds)

using measure::digits;

// A factor and its standard error: "1.30 ± 0.02×"; without the error if it is 0.
std::string factor_text(double value, double error);

// Draws into the folder, which has to exist. All of the figure's renders have to be settled.
Drawn draw_pictures(const Plan& plan, const Figure& figure, const std::filesystem::path& folder);
Drawn draw_speedup(const Plan& plan, const Figure& figure, const std::filesystem::path& folder);

Drawn draw_rules(const Plan& plan, const Figure& figure, const std::filesystem::path& folder);

Drawn draw_curve(const Plan& plan, const Figure& figure, const std::filesystem::path& folder);
Drawn draw_prices(const Plan& plan, const Figure& figure, const std::filesystem::path& folder);
Drawn draw_path(const Plan& plan, const Figure& figure, const std::filesystem::path& folder);
Drawn draw_ray(const Plan& plan, const Figure& figure, const std::filesystem::path& folder);
Drawn draw_measured(const Plan& plan, const Figure& figure, const std::filesystem::path& folder);

// The names of the numbers that a figure has, whether or not they could be measured.
std::vector<std::string> number_names(const Figure& figure);

}  // namespace writeup
