#include "grader/examples/hunt.h"

#include "grader/base/sha256.h"
#include "grader/base/wrap.h"
#include "pt/error.h"
#include "pt/file.h"

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <unistd.h>

namespace grader::examples {

namespace {

namespace fs = std::filesystem;

std::string without_blanks(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first == line.npos ? "" : line.substr(first, line.find_last_not_of(' ') - first + 1);
}

// A number that looks random and is the same on every machine.
std::uint64_t number_of(const std::string& text) {
  return std::strtoull(base::sha256(text).substr(0, 15).c_str(), nullptr, 16);
}

}  // namespace

Quarry choose(const std::vector<mistakes::Solution>& solutions, const std::string& slug,
              std::uint64_t seed) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    if (!solutions[i].is_right() && solutions[i].is_ordinary) all.push_back(i);
  }
  if (all.empty()) throw pt::Error(slug + " has no wrong solution to hunt");
  return {all[number_of(fmt::format("{} {}", slug, seed)) % all.size()], all.size()};
}

std::uint64_t seed_of_learner() {
  return number_of(std::to_string(getuid()) + fs::current_path().string()) % 10000;
}

// The build has a file of each mistake, which begins with what is known of it; a handout has known.<slug>.json.
Found found(const std::string& root, const std::string& programs, const std::string& slug,
            const std::string& name) {
  const std::string file = fmt::format("{}/build/mistakes/{}/{}/{}.cpp", root, slug, name, slug);
  if (fs::exists(file)) {
    const std::string code = pt::read_file(file);
    return {mistakes::described(name, code), code.substr(code.find("\n#include") + 1)};
  }
  const std::string path = fmt::format("{}/known.{}.json", programs, slug);
  for (const auto& mistake : mistakes::known_from_json(pt::read_file(path), path).mistakes) {
    if (mistake.name == name) return {mistake, ""};
  }
  throw pt::Error(fmt::format("{} does not have {}", path, name));
}

std::string numbered(const std::string& source, const std::set<std::string>& right_lines,
                     bool marked) {
  std::string text;
  int number = 0;
  for (const std::string& line : base::lines_of(source)) {
    const bool is_new = marked && !right_lines.contains(without_blanks(line));
    text += fmt::format("{} {:3}  {}\n", is_new ? '>' : ' ', ++number, line);
  }
  return text;
}

std::set<std::string> lines_of_right(const std::string& root, const std::string& part,
                                     const std::string& slug) {
  std::vector<std::string> files{fmt::format("{}/reference/{}/{}.cpp", root, part, slug)};
  for (const char* folder : {"right", "noisy"}) {
    const std::string path = fmt::format("{}/grader/tasks/{}/{}", root, slug, folder);
    if (!fs::exists(path)) continue;
    for (const auto& entry : fs::directory_iterator(path)) files.push_back(entry.path());
  }
  std::set<std::string> lines;
  for (const std::string& file : files) {
    for (const std::string& line : base::lines_of(pt::read_file(file)))
      lines.insert(without_blanks(line));
  }
  return lines;
}

}  // namespace grader::examples
