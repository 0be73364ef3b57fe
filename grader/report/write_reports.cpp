#include "grader/report/write_reports.h"

#include "grader/report/autograders.h"
#include "grader/report/csv.h"
#include "grader/report/html.h"
#include "grader/report/junit.h"
#include "grader/results/json.h"
#include "grader/results/presentable.h"
#include "pt/file.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace grader::report {

namespace {

namespace fs = std::filesystem;

// Only for a page that lies below the project's folder: another one will be passed on.
Link link_from(const std::string& page, const std::string& root) {
  if (root.empty()) return nullptr;
  const fs::path up = fs::weakly_canonical(root).lexically_relative(
      fs::weakly_canonical(fs::absolute(page)).parent_path());
  if (up != "." && !std::ranges::all_of(up, [](const fs::path& step) { return step == ".."; }))
    return nullptr;
  return [root, up](const std::string& file) {
    std::error_code error;
    return fs::exists(fs::path(root) / file, error) ? (up / file).generic_string() : "";
  };
}

}  // namespace

void check_targets(const ReportFiles& files) {
  std::vector<std::string> paths{files.json, files.html, files.junit, files.csv};
  for (const auto& [name, path] : files.autograders) paths.push_back(path);
  for (const std::string& path : paths) {
    if (!path.empty()) pt::check_target(path);
  }
}

void write_reports(const results::Results& results, const ReportFiles& files) {
  if (!files.json.empty()) results::write_json(results::presentable(results), files.json);
  if (!files.junit.empty()) pt::write_file(files.junit, to_junit(results));
  for (const Autograder& each : kAutograders) {
    const auto path = files.autograders.find(each.name);
    if (path != files.autograders.end() && !path->second.empty())
      pt::write_file(path->second, each.write(results));
  }
  if (!files.csv.empty()) pt::write_file(files.csv, to_csv(results));
  const PageSize size = files.small_page ? PageSize::small : PageSize::full;
  if (!files.html.empty()) {
    pt::write_file(files.html, to_html(results, size, link_from(files.html, files.root)));
  }
}

void ProgressReports::write(const results::Results& results) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const bool with_page = results.complete || start >= next_page_;
  ReportFiles files = files_;
  if (!with_page) files.html.clear();
  write_reports(results, files);
  const auto end = Clock::now();
  if (with_page) next_page_ = end + 9 * (end - start);
}

}  // namespace grader::report
