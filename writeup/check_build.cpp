#include "writeup/check_build.h"

#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "grader/service/process/run_command.h"
#include "pt/error.h"

#include <chrono>
#include <filesystem>
#include <sstream>

namespace writeup {

std::optional<Code> code_of_stability(const Options& options) {
  if (options.stability.empty() || !std::filesystem::exists(options.stability)) return {};
  Code code;
  code.command = {options.stability};
  if (!options.submission.empty()) {
    code.command.insert(code.command.end(), {"--submission", options.submission});
  } else if (options.from.find("student") != std::string::npos) {
    code.command.insert(code.command.end(), {"--submission", "student"});
  }
  std::vector<std::string> words = code.command;
  words.push_back("--keys");
  const auto result = grader::process::run_command(
      {words, {"PATH=/usr/bin:/bin", "LANG=C.UTF-8"}, {}, "", {}}, std::chrono::minutes(1));
  if (!result.ok()) throw pt::Error(options.stability + ": " + result.output);
  std::istringstream lines(result.output);
  for (std::string task, hash; lines >> task >> hash;) code.hash[task] = hash;
  return code;
}

std::optional<Code> code_of_measure(const Options& options, const Code& code) {
  if (options.measure.empty() || !std::filesystem::exists(options.measure)) return {};
  std::string text = grader::base::stamp(options.measure);
  for (const auto& [task, hash] : code.hash) text += task + hash;
  return Code{{options.measure}, {{"framework", grader::base::sha256(text)}}, {}};
}

}  // namespace writeup
