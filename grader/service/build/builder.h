#pragma once

#include "grader/service/build/cache.h"
#include "grader/service/build/config.h"
#include "grader/service/build/headers.h"
#include "grader/service/build/precompiled.h"
#include "grader/service/build/tool_folder.h"
#include "grader/service/process/run_command.h"
#include "grader/service/sandbox/box.h"
#include "grader/tasks.h"

#include <functional>
#include <map>
#include <string>

namespace grader::build {

// A built object or program, or the reason why there is none.
struct Built {
  std::string path;      // of the object or program; empty after a failure
  std::string key;       // stands for its content and everything that went into it
  std::string error;     // the first error, as the compiler or linker said it
  std::string rejected;  // why the object is not accepted, in one sentence
  std::string warnings;  // of the compiler, about the file; may be empty

  bool ok() const { return !path.empty(); }
};

// Compiles files of a submission and links workers, with plain commands in boxes. Each result is
// kept under the hash of everything it depends on. Safe from any thread. Both functions throw
// pt::Error if the machine is at fault: a full disk, no memory, a box that does not start.
class Builder {
 public:
  // Compiles in boxes of the tier, with a limit in seconds for each file.
  Builder(const Config& config, sandbox::Tier tier, int seconds);

  // Compiles `text` as the file part/slug.cpp of a tree that contains nothing else but the headers.
  Built compile(const TaskConfig& task, const std::string& text) const;

  // Compiles `text` as the file part/slug.examples.cpp: a learner's examples of the task. They may call the task, and what
  // pt/examples/ declares.
  Built compile_examples(const TaskConfig& task, const std::string& text) const;

  // Links a worker: the framework, and `objects` with one definition of every task. `key` stands for
  // the content of these objects. `recorded`: the calls of tasks that can be recorded go through the
  // recorder (pt/scene/recorder.h).
  Built link(const Paths& objects, const std::string& key, bool recorded) const;

  const std::string& cache() const { return cache_; }

 private:
  // Copies of the objects that do not depend on any submission.
  std::string folder_of_parts() const;
  // A hash of everything that an object of the task depends on.
  std::string object_key(const std::string& file, const std::string& text,
                         const Headers& headers) const;
  // A folder with these headers.
  std::string folder_of(const Headers& headers) const;
  sandbox::Box tool_box(const ToolFolder& place) const;
  // `tree`: the folder of the headers.
  sandbox::Box compiler_box(const ToolFolder& place, const TaskConfig& task,
                            const std::string& file, const std::string& text,
                            const std::string& tree) const;
  // Compiles `text` as that file of a tree. `rules` says what it may include; `audit` returns why the object is not accepted, or
  // nothing.
  Built compile_file(const TaskConfig& task, const Task& rules, const std::string& file,
                     const std::string& text,
                     const std::function<std::string(const std::string&)>& audit) const;
  process::CommandResult run_linker(const ToolFolder& place, const Paths& objects,
                                    bool recorded) const;
  // Throws pt::Error if the reference does not link either. The linker's output does not show whose
  // fault it is, since it contains names of a submission's objects.
  void expect_linker(bool recorded) const;
  // Throws pt::Error if it fails because of the machine; then `what` could not be judged.
  process::CommandResult run(const sandbox::Box& box, const std::string& what) const;

  const Config& config_;
  sandbox::Tier tier_;
  int seconds_;
  std::string cache_;      // the folder
  Running running_;        // in it
  std::string toolchain_;  // a hash of the compiler and the flags
  std::string framework_;  // a hash of the framework's objects
  Headers headers_;
  PrecompiledHeaders precompiled_;
  std::map<std::string, std::string> header_hashes_;
};

}  // namespace grader::build
