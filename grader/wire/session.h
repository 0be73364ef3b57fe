#pragma once

#include "grader/check/fail.h"
#include "grader/wire/worker_process.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <vector>

// The judge's end: the one conversation of a property program with a worker, restarted as needed.

namespace grader::wire {

// Throws pt::Error.
[[noreturn]] void cannot_judge(const std::string& why);

// The settings for the one worker of this program.
struct SessionSettings {
  std::string task;                            // the slug that is judged
  std::string program;                         // the worker
  sandbox::Tier tier = sandbox::Tier::limits;  // of the box it runs in
  bool integrated = false;  // all tasks are the submission's: its scenes are traced by its own tree
  bool answers = true;      // the worker may call back
  // Called when a call fails; does not return.
  std::function<void(results::Cause, const std::string&)> give_up = check::fail_call;
  // Called with a sentence when the judge itself cannot go on, as without a worker: that is nobody's
  // verdict. Does not return.
  std::function<void(const std::string&)> at_fault = cannot_judge;
  // Limits of processor time (grader/process/time_limit.h).
  std::chrono::milliseconds call_limit =
      process::kCallLimit;                       // of one call, and of kBatch repetitions
  std::chrono::milliseconds total_limit{30000};  // of all calls together
  // After so many calls that crashed or gave no answer the worker is not called any more. Counted, as time
  // would depend on what else the machine does.
  int max_timeouts = 3;
  int max_failures = 500;
  // Likewise after so many bytes from workers: the judge has to read them.
  std::uint64_t max_answered = std::numeric_limits<std::uint64_t>::max();
  // The session of smaller inputs for a failure: a limit of all calls ends the search for them.
  bool smaller_inputs = false;
};

// The record of a session, for the report.
struct SessionRecord {
  long long calls = 0;  // repetitions included
  int restarts = 0;
  std::set<std::string> todo;  // slugs of tasks that are not written yet
  std::string printed;         // the beginning of what the workers printed
  std::uint64_t kept = 0;      // 1 + the place of a variable that the task keeps between calls
};

// The judge's connection to the submission: starts the worker when it is needed, starts it again
// after it died, and turns everything that goes wrong into a failed case (fail_call).
class Session {
 public:
  explicit Session(SessionSettings settings) : settings_(std::move(settings)) {}

  // The scene must neither change nor move until the session ends. It is encoded once, however many
  // calls name it; a second call does nothing.
  void keep(const pt::Scene& scene);

  // Begins a call. Name the arguments' objects while they are written to `arguments`.
  void begin();
  Handle name(const pt::Scene& scene);
  Handle name(const pt::Primitives& primitives);
  Handle name(const pt::Bvh& bvh);

  // Ends it: sends the call and returns the reply's payload, after the ReplyHead. The arguments are
  // those of a function of the given number and signature.
  std::string_view call(Function function, std::uint64_t code, const CallBatch& batch,
                        const Writer& arguments);

  // The reply to the last call makes no sense. The worker is not called again.
  [[noreturn]] void reject(const std::string& why);

  // The scene of this call that has the name; throws BadMessage if there is none.
  template <class Object>
  const Object& find(Handle handle) const {
    static_assert(std::is_same_v<Object, pt::Scene>, "inner calls name nothing else");
    return scene(handle);
  }

  SessionRecord record() const;

 private:
  using Shared = std::shared_ptr<const Definition>;
  Shared definition_of(const pt::Scene& scene) const;
  Handle need(const Shared& definition);
  const pt::Scene& scene(Handle handle) const;
  void expect_attempted() const;
  void expect_time_left();
  void call_no_more(results::Cause cause, const std::string& why) const;
  void expect_total_time_left();
  void count_failure(const WorkerFailed& failure);
  std::chrono::nanoseconds slept() const;  // of all workers together; uncertain time is left out
  void keep_totals(results::Cause cause);  // of the worker that has ended
  void drop_known_definitions();
  Writer message(Function function, std::uint64_t code, const CallBatch& batch,
                 const Writer& arguments);
  std::string converse(const Writer& call);
  void take_head(Reader& reply, std::uint64_t code);
  [[noreturn]] void fail(const WorkerFailed& failure);

  SessionSettings settings_;
  SessionRecord record_;
  std::unique_ptr<WorkerProcess> worker_;
  std::uint64_t sequence_ = 0;
  std::set<Handle> known_;  // to the worker
  std::size_t known_bytes_ = 0;
  bool forget_ = false;              // this call begins with a worker that knows nothing
  std::vector<Shared> definitions_;  // that this call needs
  std::map<const pt::Scene*, Shared> kept_;
  std::map<Handle, const pt::Scene*> scenes_;  // of this call
  std::string reply_;
  Clock::time_point first_call_;
  std::chrono::nanoseconds running_{0}, slept_{0};  // of workers that have ended
  std::uint64_t answered_ = 0;                      // bytes of their answers
  int timeouts_ = 0, failures_ = 0;
  results::Cause last_cause_ = results::Cause::timeout;
};

// The number of repetitions in one message: enough that its cost does not count, few enough that
// the limit of a call is a limit for all of them.
inline constexpr int kBatch = 256;

// The session of this program, opened once by main. While smaller inputs are tried for a failure, it
// is another one with a worker and limits of its own: how many are tried depends on the machine, and
// a verdict must not.
void open_session(const SessionSettings& settings);
Session& session();

// The judge's own answer to an inner call of the task (from its mocks). Throws BadMessage for
// what it does not answer.
Writer answer(std::string_view task, std::string_view question, const Session& session);

}  // namespace grader::wire
