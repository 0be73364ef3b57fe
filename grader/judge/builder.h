#pragma once

#include "grader/judge/config.h"
#include "grader/judge/headers.h"
#include "grader/judge/precompiled.h"
#include "grader/judge/tool_folder.h"
#include "grader/process/run_command.h"
#include "grader/sandbox/box.h"

#include <map>
#include <string>

namespace grader::judge {

// Something that was built, or why not.
struct Built {
  std::string path;      // of the object or program; empty if it failed
  std::string key;       // stands for its content and everything that went into it
  std::string error;     // the first error, as the compiler or linker said it
  std::string rejected;  // why what was compiled is not accepted, in one sentence
  std::string warnings;  // of the compiler, about the file; empty if there are none

  bool ok() const { return !path.empty(); }
};

// Compiles files of a submission and links workers, by plain commands in boxes, each result kept
// under the hash of everything it depends on. Safe from any thread. Both throw pt::Error where the
// machine is at fault: a full disk, no memory, a box that does not start.
class Builder {
 public:
  // Compiles in boxes of the tier, for so many seconds at most.
  Builder(const Config& config, sandbox::Tier tier, int seconds);

  // `text` as the file part/slug.cpp of a tree in which there are the headers and nothing else.
  Built compile(const TaskConfig& task, const std::string& text) const;

  // Links a worker: the framework, and `objects` with one definition of every task. `key` stands for
  // the content of these objects. `integrated`: the worker also records the tests that hit_bvh makes.
  Built link(const Paths& objects, const std::string& key, bool integrated) const;

  const std::string& cache() const { return cache_; }

 private:
  // Copies of the objects that no submission has a part in.
  std::string folder_of_parts() const;
  // Stands for all that an object of the task depends on.
  std::string object_key(const TaskConfig& task, const std::string& text,
                         const Headers& headers) const;
  // A folder with these headers.
  std::string folder_of(const Headers& headers) const;
  sandbox::Box tool_box(const ToolFolder& place) const;
  // `tree`: the folder of the headers.
  sandbox::Box compiler_box(const ToolFolder& place, const TaskConfig& task,
                            const std::string& text, const std::string& tree) const;
  process::CommandResult run_linker(const ToolFolder& place, const Paths& objects,
                                    bool integrated) const;
  // Throws pt::Error if the reference does not link either. The output of the
  // linker does not tell whose fault it is: it has names of a submission's objects in it.
  void expect_linker(bool integrated) const;
  // Throws pt::Error if it fails and the machine is at fault; `what` could then not be judged.
  process::CommandResult run(const sandbox::Box& box, const std::string& what) const;

  const Config& config_;
  sandbox::Tier tier_;
  int seconds_;
  std::string cache_;      // the folder
  std::string toolchain_;  // stands for compiler and flags
  std::string framework_;  // and for the objects of the framework
  Headers headers_;
  PrecompiledHeaders precompiled_;
  std::map<std::string, std::string> header_hashes_;
};

}  // namespace grader::judge
