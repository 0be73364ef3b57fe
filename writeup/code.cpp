#include "writeup/code.h"

#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "grader/service/process/run_command.h"
#include "pt/error.h"
#include "pt/file.h"

#include <chrono>
#include <sstream>

namespace writeup {

namespace {

constexpr std::size_t kMaxObject = std::size_t{1} << 28;

constexpr std::chrono::minutes kBuildTime{20};
constexpr std::size_t kMaxJson = std::size_t{1} << 22;

std::string built_file(const Options& options, const std::string& label) {
  return options.work + "/submission." + label + ".json";
}

// Compiles the submission, and links its tasks with the parts that the file `parts` lists.
void build(const Options& options, const std::string& submission, const std::string& built,
           const std::string& parts) {
  const auto result =
      grader::process::run_command({{options.boxed, "build", submission, built, parts},
                                    {"PATH=/usr/bin:/bin", "LANG=C.UTF-8"},
                                    {},
                                    "",
                                    {}},
                                   kBuildTime);
  if (!result.ok())
    throw pt::Error("the submission " + submission + " cannot be built: " + result.output);
}

}  // namespace

Code code_of_program(const std::filesystem::path& program) {
  Code code;
  code.command = {program.string()};
  std::map<std::string, std::string> contents;
  const std::filesystem::path build = program.parent_path().parent_path();
  std::istringstream list(pt::read_file(program.string() + ".objects", kMaxObject));
  // Each line has a name without spaces, one space, and a path.
  for (std::string name, path; list >> name && list.get() == ' ' && std::getline(list, path);) {
    contents[name] += grader::base::sha256(pt::read_file(build / path, kMaxObject));
  }
  if (contents.empty()) throw pt::Error(program.string() + ".objects is empty");
  for (const auto& [name, content] : contents) code.hash[name] = grader::base::sha256(content);
  return code;
}

Code code_of_submission(const Options& options, const std::string& submission,
                        const std::string& label) {
  const std::string built = built_file(options, label);
  build(options, submission, built, "writeup_boxed.json");
  const auto in = nlohmann::json::parse(pt::read_file(built, kMaxJson));
  Code code;
  code.command = {options.boxed, "render", in.at("worker"), in.at("tier")};
  code.hash = in.at("hash").get<std::map<std::string, std::string>>();
  code.hash["framework"] += grader::base::sha256(grader::base::stamp(options.boxed));
  code.unusable = in.at("unusable").get<std::map<std::string, std::string>>();
  return code;
}

Code accuracy_of_submission(const Options& options, const Code& code, const std::string& label) {
  Code accuracy = code;
  accuracy.command = {options.accuracy, "--built", built_file(options, label), "--name", label};
  accuracy.hash["framework"] += grader::base::sha256(grader::base::stamp(options.accuracy));
  return accuracy;
}

Code accuracy_of_several(const Options& options, const std::map<std::string, Code>& codes) {
  const std::filesystem::path program =
      std::filesystem::path(options.boxed).parent_path() / "accuracy_boxed";
  Code several;
  several.command = {program};
  const std::filesystem::path reference = program.parent_path() / "ladder_rung.reference";
  if (std::filesystem::exists(reference)) several.command.emplace_back("--reference");
  several.hash["framework"] = grader::base::stamp(program);
  for (const auto& [label, code] : codes) {
    const Code one = accuracy_of_submission(options, code, label);
    several.command.insert(several.command.end(), one.command.begin() + 1, one.command.end());
    for (const auto& [task, hash] : code.hash) several.hash[task] += label + hash;
  }
  return several;
}

Code view_of_submission(const Options& options, const Code& code, bool is_wanted) {
  const std::string built = options.work + "/submission_view.json";
  if (is_wanted) build(options, options.submissions.at(0), built, "view_boxed.json");
  Code view = code;
  view.command = {options.view, "--boxed", built, "--reference", options.view_worker};
  view.hash["framework"] += grader::base::sha256(grader::base::stamp(options.view) +
                                                 grader::base::stamp(options.view_worker));
  return view;
}

std::string identity(const Code& code, const measure::Spec& spec) {
  std::string text = code.hash.at("framework");
  for (const std::string& task : measure::tasks_used(spec)) text += task + code.hash.at(task);
  return text;
}

std::string obstacle(const Code& code, const measure::Spec& spec) {
  for (const std::string& task : measure::tasks_used(spec)) {
    if (const auto found = code.unusable.find(task); found != code.unusable.end()) {
      return task + " " + found->second;
    }
  }
  return "";
}

}  // namespace writeup
