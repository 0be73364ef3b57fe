#include "view/child.h"

#include "grader/service/process/spawn.h"

#include <array>
#include <cerrno>
#include <chrono>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace view {

namespace {

// Of a submission. There is no limit of time: its user looks on, and each answer has one.
constexpr grader::process::Limits kLimits{
    .cpu_seconds = {},
    .address_space = std::uint64_t{2} << 30,
    .file_size = 0,
    .processes = 0,
    .open_files = 16,
};

// Far more than the largest picture.
constexpr std::size_t kMaxAnswer = std::size_t{1} << 27;

void write_all(const grader::base::Descriptor& to, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(to.number(), text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw ChildEnded("the program of the tasks has ended");
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace

Child::~Child() { end(); }

void Child::stop() {
  if (const pid_t pid = pid_; pid > 0) grader::process::end_child(pid);
}

void Child::restart() {
  if (const std::unique_lock lock(one_at_a_time_, std::try_to_lock); lock) {
    end();
    return;
  }
  is_renewed_ = true;
  stop();
}

int Child::end() {
  const int status = pid_ > 0 ? grader::process::kill_child(pid_) : 0;
  pid_ = -1;
  questions_.close();
  answers_.close();
  read_.clear();
  return status;
}

void Child::start() {
  grader::base::Pipe to = grader::base::make_pipe(), from = grader::base::make_pipe();
  const grader::base::Descriptor nothing(open("/dev/null", O_RDWR | O_CLOEXEC));
  grader::process::Child child;
  // What a learner's code prints goes to the terminal.
  const int printed = program_.box ? nothing.number() : STDERR_FILENO;
  child.descriptors = {nothing.number(), printed, printed, to.read_end.number(),
                       from.write_end.number()};
  if (program_.box) {
    child = grader::sandbox::boxed({program_.command,
                                    {"LANG=C.UTF-8"},
                                    child.descriptors,
                                    {program_.scene},
                                    "",
                                    false,
                                    kLimits},
                                   *program_.box);
    held_ = child.held;
  } else {
    child.command = program_.command;
    child.environment = grader::process::own_environment();
  }
  pid_ = grader::process::spawn(child);
  questions_ = std::move(to.write_end);
  answers_ = std::move(from.read_end);
}

// Reads what has come, after at most patience_.
void Child::fill() {
  pollfd ready{answers_.number(), POLLIN, 0};
  const int count = poll(&ready, 1, static_cast<int>(patience_.count()));
  if (count == 0) {
    end();
    throw ChildEnded(
        fmt::format("the tasks gave no answer for {} s, as in an endless loop, and were stopped",
                    static_cast<double>(patience_.count()) / 1000));
  }
  std::array<char, 1 << 16> buffer{};
  const ssize_t size = read(answers_.number(), buffer.data(), buffer.size());
  if (size < 0 && errno == EINTR) return;
  if (size > 0 && read_.size() > kMaxAnswer) {
    end();
    throw ChildEnded("the program of the tasks answers without end, and was stopped");
  }
  if (size > 0) {
    read_.append(buffer.data(), static_cast<std::size_t>(size));
    return;
  }
  int status = 0;
  waitpid(pid_, &status, 0);
  pid_ = -1;
  end();
  // So a box says that its program ended by a signal.
  if (WIFEXITED(status) && WEXITSTATUS(status) > 128) status = WEXITSTATUS(status) - 128;
  const char* const how = WIFSIGNALED(status) ? "crashed" : "ended their program";
  throw ChildEnded(fmt::format("the tasks {}: {}", how, grader::process::describe_status(status)));
}

std::string Child::read_line() {
  while (read_.find('\n') == std::string::npos) fill();
  return read_bytes(read_.find('\n') + 1);
}

std::string Child::read_bytes(std::size_t size) {
  while (read_.size() < size) fill();
  std::string bytes = read_.substr(0, size);
  read_.erase(0, size);
  return bytes;
}

Reply Child::ask(const std::string& what, const std::map<std::string, std::string>& query) {
  const std::lock_guard lock(one_at_a_time_);
  const nlohmann::json words{{"what", what}, {"query", query}};
  const auto replace = nlohmann::json::error_handler_t::replace;
  const std::string question = words.dump(-1, ' ', false, replace) + "\n";
  try {
    return ask_once(question);
  } catch (const ChildEnded&) {
    if (!is_renewed_.exchange(false)) throw;
    end();
    return ask_once(question);
  }
}

Reply Child::ask_once(const std::string& question) {
  if (pid_ < 0) start();
  try {
    write_all(questions_, question);
  } catch (const ChildEnded&) {
    fill();  // says how it ended
    throw;
  }
  Reply reply;
  try {
    const nlohmann::json head = nlohmann::json::parse(read_line());
    if (head.contains("error")) throw pt::Error(head.at("error").get<std::string>());
    reply.bytes = read_bytes(head.at("size"));
    reply.state = head.at("state");
  } catch (const nlohmann::json::exception&) {
    end();
    throw ChildEnded("the tasks have written into the answers of their program, and were stopped");
  }
  return reply;
}

}  // namespace view
