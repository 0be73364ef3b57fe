#pragma once

#include "grader/check/language/fail.h"
#include "grader/service/wire/worker_process.h"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <vector>

// The judge's end: the one conversation of a property program with a worker, restarted as needed.

namespace grader::wire {

// Throws pt::Error.
[[noreturn]] void cannot_judge(const std::string& why);

// The processor time of all calls together, for a limit of one call. Right tasks that call a slow
// hit_triangle of the submission need more than half of it.
inline std::chrono::milliseconds limit_of_all_calls(std::chrono::milliseconds one) {
  return 30 * one;
}

// The settings for the one worker of this program.
struct SessionSettings {
  std::string task;                            // the slug that is judged
  std::string program;                         // the worker
  sandbox::Tier tier = sandbox::Tier::limits;  // of the worker's box
  bool integrated = false;  // all tasks are the submission's, and its own tree traces scenes
  bool answers = true;      // the worker may call back
  // Called when a call fails; does not return.
  std::function<void(results::Cause, const std::string&)> give_up = check::fail_call;
  // Called with a sentence when the judge itself cannot go on, for example without a worker: there
  // is no verdict then. Does not return.
  std::function<void(const std::string&)> at_fault = cannot_judge;
  // Limits of processor time (grader/service/process/time_limit.h).
  std::chrono::milliseconds call_limit = process::kCallLimit;  // of one call
  std::chrono::milliseconds total_limit = limit_of_all_calls(call_limit);
  // The worker is no longer called after this many calls without an answer or with a crash. They
  // are counted, because time would depend on the machine's load.
  int max_timeouts = 2;
  int max_failures = 500;
  // A call that asks the judge more often has no end. Right tasks ask 65,537 times at most
  // (estimate_pixel and adaptive_pixel, once for a sample).
  int max_questions = 150'000;
  // The judge has to read all results and questions. After this many bytes of them it calls the worker
  // no more. count_answers_anew() begins a new count.
  std::uint64_t max_answered = std::numeric_limits<std::uint64_t>::max();
  // For a session that tries smaller inputs: reaching a limit of all calls only ends that search.
  bool smaller_inputs = false;
};

// The record of a session, for the report.
struct SessionRecord {
  long long calls = 0;         // repetitions included
  std::set<std::string> todo;  // slugs of tasks that are not written yet
  std::string printed;         // the beginning of the workers' output
  std::uint64_t kept = 0;      // 1 + the place of state kept between calls, or 0
};

// The judge's connection to the submission. It starts the worker when needed, restarts it after its
// death, and turns every error of the worker into a failed case (fail_call).
class Session {
 public:
  explicit Session(SessionSettings settings) : settings_(std::move(settings)) {}

  // The scene must neither change nor move until the session ends. It is encoded once, however many
  // calls name it; a second call does nothing.
  void keep(const pt::Scene& scene);

  // Begins a call. name() the objects of the arguments while you write them to `arguments`.
  void begin();
  Handle name(const pt::Scene& scene);
  Handle name(const pt::Primitives& primitives);
  Handle name(const pt::Bvh& bvh);

  // Ends the call: sends it and returns the reply's payload after the ReplyHead. The arguments are
  // for the function with the given number and signature.
  std::string_view call(Function function, std::uint64_t code, const CallBatch& batch,
                        const Writer& arguments, bool records = false);

  // Returns whether the worker records calls: not if it runs all tasks of a submission.
  bool can_record() const { return !settings_.integrated; }

  // Reports that the reply to the last call is malformed. The worker is not called again.
  [[noreturn]] void reject(const std::string& why);

  // The scene of this call with the given name. Throws BadMessage if there is none.
  template <class Object>
  const Object& find(Handle handle) const {
    static_assert(std::is_same_v<Object, pt::Scene>, "inner calls name nothing else");
    return scene(handle);
  }

  SessionRecord record() const;

  // Makes the first calls of each function again: once, or many times if the worker can make them without the judge. Another answer is
  // kept state (kOtherAnswer). Of build_bvh only trees of one box are made again: any other may be different.
  void make_first_calls_again();

  // The answers so far no longer count for the limit.
  void count_answers_anew() { answered_before_ = answered(); }

 private:
  using Shared = std::shared_ptr<const Definition>;
  Shared definition_of(const pt::Scene& scene) const;
  Handle need(const Shared& definition);
  const pt::Scene& scene(Handle handle) const;
  void expect_attempted() const;
  void expect_time_left();
  void call_no_more(results::Cause cause, const std::string& why);
  void expect_total_time_left();
  void count_failure(const WorkerFailed& failure);
  std::uint64_t answered() const { return answered_ + (worker_ ? worker_->answered() : 0); }
  std::chrono::nanoseconds slept() const;  // of all workers together; uncertain time is left out
  void keep_totals(results::Cause cause);  // of a worker that has ended
  void drop_known_definitions();
  Writer message(const CallHead& head, std::string_view arguments);
  std::string converse(const Writer& call);
  void go_on();
  std::int64_t take_head(Reader& reply, std::uint64_t code);  // returns the number of rays
  [[noreturn]] void fail(const WorkerFailed& failure);

  SessionSettings settings_;
  SessionRecord record_;
  std::unique_ptr<WorkerProcess> worker_;
  std::uint64_t sequence_ = 0;
  std::array<Handle, kObjectKinds> known_{};  // the object of each kind that the worker knows
  std::vector<Shared> definitions_;           // definitions that this call needs

  struct Call {
    CallHead head;
    std::string arguments;
    std::vector<Shared> definitions;
    std::string result;
    std::int64_t work = 0;  // inner calls and rays
  };
  std::string answer_again(const Call& call, int others);
  int questions_ = 0;  // of the last call to the judge
  // Of those that ask and those that do not, the first call of each function that has an answer of a size: one that is nothing, and
  // one that is something. Where that is long work, it is the first that is short.
  std::map<std::tuple<bool, Function, std::size_t>, Call> first_calls_;

  std::map<const pt::Scene*, Shared> kept_;
  std::map<Handle, const pt::Scene*> scenes_;  // scenes of this call
  std::string reply_;
  Clock::time_point first_call_;
  std::chrono::nanoseconds running_{0}, slept_{0};  // of workers that have ended
  std::uint64_t answered_ = 0;                      // the bytes of their answers
  std::uint64_t answered_before_ = 0;               // of all answers, those that no longer count
  int timeouts_ = 0, failures_ = 0;
  bool has_ended_ = false;  // a limit of all calls was reached
};

// No call traces or tests more. Sums of such counts do not overflow.
inline constexpr std::int64_t kMaxCount = std::int64_t{1} << 40;

// The number of repetitions in one message: enough to make the message's cost small.
inline constexpr int kBatch = 256;

// The session of this program, opened once by main. While smaller inputs are tried for a failure,
// this is another session with its own worker and limits: what these tries do must not change a
// verdict.
std::shared_ptr<Session> open_session(const SessionSettings& settings);
Session& session();
// Goes on with a session that was opened before the last one; its worker is still there.
void use_session(std::shared_ptr<Session> opened);

// True if the judge answers this inner call of the task.
bool answers(std::string_view task, Function function);

// The judge's own answer to an inner call of the task (from its mocks). Throws BadMessage for calls
// that the judge does not answer.
Writer answer(std::string_view task, std::string_view question, const Session& session);

}  // namespace grader::wire
