#include "writeup/boxed_code.h"

#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "grader/service/process/run_command.h"
#include "pt/error.h"
#include "pt/file.h"

#include <chrono>

namespace writeup {

namespace {

constexpr std::chrono::minutes kBuildTime{20};
constexpr std::size_t kMaxJson = std::size_t{1} << 22;

std::string built_file(const Options& options) { return options.work + "/submission.json"; }

// Compiles the submission, with the parts of this file besides its tasks.
void build(const Options& options, const std::string& built, const std::string& parts) {
  const auto result =
      grader::process::run_command({{options.boxed, "build", options.submission, built, parts},
                                    {"PATH=/usr/bin:/bin", "LANG=C.UTF-8"},
                                    {},
                                    "",
                                    {}},
                                   kBuildTime);
  if (!result.ok()) throw pt::Error("the submission cannot be built: " + result.output);
}

}  // namespace

Code code_of_submission(const Options& options) {
  const std::string built = built_file(options);
  build(options, built, "writeup_boxed.json");
  const auto in = nlohmann::json::parse(pt::read_file(built, kMaxJson));
  Code code;
  code.command = {options.boxed, "render", in.at("worker"), in.at("tier")};
  code.hash = in.at("hash").get<std::map<std::string, std::string>>();
  code.hash["framework"] += grader::base::sha256(grader::base::stamp(options.boxed));
  code.unusable = in.at("unusable").get<std::map<std::string, std::string>>();
  return code;
}

Code accuracy_of_submission(const Options& options, const Code& code) {
  Code accuracy = code;
  accuracy.command = {options.accuracy, "--built", built_file(options)};
  accuracy.hash["framework"] += grader::base::sha256(grader::base::stamp(options.accuracy));
  return accuracy;
}

Code view_of_submission(const Options& options, const Code& code, bool is_wanted) {
  const std::string built = options.work + "/submission_view.json";
  if (is_wanted) build(options, built, "view_boxed.json");
  Code view = code;
  view.command = {options.view, "--boxed", built, "--reference", options.view_worker};
  view.hash["framework"] += grader::base::sha256(grader::base::stamp(options.view) +
                                                 grader::base::stamp(options.view_worker));
  return view;
}

}  // namespace writeup
