#include "writeup/accuracy/rung_program.h"

#include "grader/process/spawn.h"
#include "pt/error.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

namespace writeup::accuracy {

namespace fs = std::filesystem;

RungProgram::RungProgram(const fs::path& folder, const std::string& mixture, const Options& options,
                         pt::Engine engine) {
  name_ = "ladder_rung." + mixture;
  std::replace(name_.begin(), name_.end(), '=', '-');
  const fs::path program = folder / name_;
  if (!fs::exists(program)) {
    throw pt::Error(program.string() + " is missing: build the target ladder_rungs");
  }
  grader::base::Pipe in = grader::base::make_pipe(), out = grader::base::make_pipe();
  Options own = options;
  own.engine = engine;
  std::vector<std::string> command = words_of(own);
  command.insert(command.begin(), program.string());
  grader::process::Child child{command, {}, {}, "", {}};
  for (char** entry = environ; *entry != nullptr; ++entry) child.environment.emplace_back(*entry);
  child.descriptors = {in.read_end.number(), out.write_end.number(), STDERR_FILENO};
  pid_ = grader::process::spawn(child);
  requests_ = std::move(in.write_end);
  replies_.reset(fdopen(dup(out.read_end.number()), "r"));
  if (!replies_) throw pt::Error("no descriptor is left");
}

RungProgram::~RungProgram() { grader::process::kill_child(pid_); }

RungReply RungProgram::render(const RungRequest& request) {
  const std::string line = to_line(request) + "\n";
  char* text = nullptr;
  std::size_t size = 0;
  const bool sent = write(requests_.number(), line.data(), line.size()) == ssize_t(line.size());
  const bool answered = sent && getline(&text, &size, replies_.get()) > 0;
  const std::string reply = answered ? text : "";
  std::free(text);
  if (!answered) throw pt::Error(name_ + " has ended: it says above why");
  return reply_from(reply);
}

}  // namespace writeup::accuracy
