#include "grader/self_check/task_folder.h"

#include "grader/base/sources_in.h"
#include "grader/results/promises.h"
#include "pt/error.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace grader::self_check {

namespace fs = std::filesystem;

std::vector<std::string> promises_in(const fs::path& contract) {
  std::ostringstream text;
  text << std::ifstream(contract).rdbuf();
  std::vector<std::string> names;
  for (const results::Promise& promise : results::promises_of(text.str()))
    names.push_back(promise.name);
  return names;
}

std::vector<KeptSolution> kept_solutions(const fs::path& root, const std::string& slug,
                                         const std::string& kind) {
  std::vector<KeptSolution> all;
  if (kind != "wrong" && kind != "relative") {
    for (const fs::path& file : base::sources_in(root / "grader/tasks" / slug / kind)) {
      all.push_back({slug, kind, file.stem(), file});
    }
    return all;
  }
  const fs::path made = root / "build" / (kind == "wrong" ? "mistakes" : "relatives") / slug;
  if (!fs::is_directory(made)) return all;
  for (const auto& entry : fs::directory_iterator(made)) {
    all.push_back({slug, kind, entry.path().filename(), entry.path() / (slug + ".cpp")});
  }
  std::ranges::sort(all, {}, &KeptSolution::name);
  return all;
}

KeptSolution kept_solution(const fs::path& root, const std::string& slug, const std::string& kind,
                           const std::string& name) {
  for (const KeptSolution& each : kept_solutions(root, slug, kind)) {
    if (each.name == name) return each;
  }
  throw pt::Error(slug + " has no " + kind + " solution named " + name);
}

std::string first_line(const fs::path& file, const std::string& label) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line.starts_with(label) ? line.substr(label.size()) : "";
}

}  // namespace grader::self_check
