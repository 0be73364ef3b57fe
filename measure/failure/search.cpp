#include "measure/failure/search.h"

#include "grader/base/sha256.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace measure::failure {

namespace fs = std::filesystem;
namespace build = grader::build;
namespace judging = grader::judging;
using nlohmann::json;

namespace {

constexpr std::size_t kShown = 2;

std::string text_of(const std::string& slug, const json& search) {
  std::string text =
      fmt::format("{}: {}\n  {}\n  {} inputs in {:.0f} seconds, all runs together\n", slug,
                  search.at("title").get<std::string>(), search.at("measure").get<std::string>(),
                  search.at("tried").get<long long>(), search.at("seconds").get<double>());
  const json& worst = search.at("worst");
  for (std::size_t i = 0; i < std::min(kShown, worst.size()); ++i) {
    text += worst[i].at("broken") ? "  broken: " + worst[i].at("reason").get<std::string>() + "\n"
                                  : fmt::format("  {:.3g}\n", worst[i].at("badness").get<double>());
    std::string input = worst[i].at("input");
    for (std::size_t at = 0; (at = input.find('\n', at)) != input.npos; at += 5) {
      input.replace(at, 1, "\n    ");
    }
    text += "    " + input + "\n";
  }
  return text;
}

}  // namespace

bool has_searches(const build::Config& config, const build::TaskConfig& task) {
  return fs::exists(config.root + "/grader/tasks/" + task.slug + "/searches.cpp");
}

bool search_all(const build::Config& config, const build::TaskConfig& task, const Request& request,
                double minutes, const std::string& folder) {
  fs::create_directories(folder);
  CurveLine line;
  std::string name = task.slug;
  if (!request.submission.empty()) {
    line.kind = CurveLine::Kind::submission;
    name += "." + grader::base::sha256(fs::absolute(request.submission).string()).substr(0, 8);
  }
  const Answered found =
      search_task(config, task, request, {minutes, folder + "/" + name + ".json"}, line);
  if (!found.unusable.empty()) {
    fmt::print("{} is not searched: {}\n", task.slug, found.unusable);
    return false;
  }
  for (const json& search : found.answer) fmt::print("{}\n", text_of(task.slug, search));
  return true;
}

}  // namespace measure::failure
