#include "grader/service/sandbox/launcher/options.h"

#include "pt/error.h"
#include "pt/number.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace grader::sandbox::box {

namespace {

std::uint64_t number(std::string_view text) {
  const std::optional<std::uint64_t> value = pt::number_in<std::uint64_t>(text);
  if (!value) throw pt::Error("'" + std::string(text) + "' is not a limit");
  return *value;
}

void take(Options& options, std::string_view word) {
  const std::size_t equals = std::min(word.find('='), word.size());
  const std::string_view name = word.substr(0, equals);
  const std::string_view value = word.substr(std::min(equals + 1, word.size()));
  if (name == "--inside") {
    options.inside = true;
  } else if (name == "--tools") {
    options.tools = true;
  } else if (name == "--folder") {
    options.folder = value;
  } else if (name == "--visible") {
    options.visible.emplace_back(value);
  } else if (name == "--cpu") {
    options.limits.cpu_seconds = number(value);
  } else if (name == "--memory") {
    options.limits.address_space = number(value);
  } else if (name == "--file-size") {
    options.limits.file_size = number(value);
  } else if (name == "--processes") {
    options.limits.processes = number(value);
  } else if (name == "--user") {
    options.user = static_cast<uid_t>(number(value));
  } else if (name == "--started") {
    options.started = static_cast<int>(number(value));
  } else if (name == "--part") {
    options.part = static_cast<int>(number(value));
  } else if (name == "--landlock") {
    options.landlock = static_cast<long>(number(value));
  } else if (name == "--files") {
    options.limits.open_files = number(value);
  } else {
    throw pt::Error("there is no option '" + std::string(word) + "'");
  }
}

}  // namespace

Options parse(int count, char** words) {
  Options options;
  int i = 1;
  for (; i < count && std::string_view(words[i]) != "--"; ++i) take(options, words[i]);
  if (i + 1 >= count) throw pt::Error("which program? Write it after --");
  options.command.assign(words + i + 1, words + count);
  options.command.push_back(nullptr);
  return options;
}

}  // namespace grader::sandbox::box
