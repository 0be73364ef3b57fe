#include "grader/judge/ask_program.h"

#include "grader/base/files.h"
#include "grader/base/sha256.h"
#include "grader/judge/cache.h"
#include "grader/process/run_command.h"
#include "grader/sandbox/box.h"
#include "pt/file.h"

#include <filesystem>

namespace grader::judge {

namespace fs = std::filesystem;

Written ask_program(const Builder& builder, const std::string& program, const Trial& trial,
                    const std::vector<std::string>& words, std::chrono::seconds most) {
  std::vector<std::string> command{program, "--worker", trial.worker.path, "--isolation",
                                   std::string(1, sandbox::letter(trial.request.isolation.tier))};
  command.insert(command.end(), words.begin(), words.end());
  std::string key = content_stamp(program, builder.cache()) + trial.worker.key;
  for (const std::string& word : command) key += '\0' + word;
  const std::string path = builder.cache() + "/" + base::sha256(key) + ".json";
  if (!fs::exists(path)) {
    const std::string temporary = pt::temporary_name(path);
    command.push_back(temporary);
    const process::CommandResult result =
        process::run_command({command, sandbox::judges_environment(), {}, "", {}}, most);
    if (!result.ok() || !fs::exists(temporary)) {
      fs::remove(temporary);
      return {"", result.output};
    }
    fs::rename(temporary, path);
  }
  mark_used(path);
  return {path, ""};
}

}  // namespace grader::judge
