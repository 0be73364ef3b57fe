#include "grader/service/wire/session.h"

#include "grader/base/printable.h"
#include "grader/check/language/find_failure.h"
#include "grader/check/mocks/counting.h"
#include "grader/check/mocks/scripted_radiance.h"
#include "grader/service/wire/kept_state.h"
#include "grader/tasks.h"
#include "pt/error.h"
#include "pt/scene/scene.h"

#include <algorithm>
#include <cstdlib>
#include <new>
#include <utility>

#include <fmt/format.h>

namespace grader::wire {

namespace {

constexpr std::size_t kMaxPrinted = std::size_t{1} << 12;

// Of answers to smaller inputs, for each failure: what costs some tenths of a second.
constexpr std::uint64_t kMaxAnsweredSmaller = std::uint64_t{1} << 20;

std::shared_ptr<Session> the_session, the_session_of_smaller_inputs;
int search_served = 0;  // the search for smaller inputs that the second session serves

std::shared_ptr<const Definition> defined(ObjectKind kind, const Writer& content) {
  const std::string_view bytes = content.bytes();
  return std::make_shared<Definition>(
      Definition{content_hash(kind, bytes), kind, std::string(bytes)});
}

}  // namespace

std::shared_ptr<Session> open_session(const SessionSettings& settings) {
  the_session = std::make_shared<Session>(settings);
  SessionSettings smaller = settings;
  smaller.smaller_inputs = true;
  smaller.max_timeouts = 1;    // each takes the full time limit of a call
  smaller.max_failures = 100;  // one hanging call is enough
  smaller.max_answered = std::min(smaller.max_answered, kMaxAnsweredSmaller);
  the_session_of_smaller_inputs = std::make_shared<Session>(smaller);
  return the_session;
}

void use_session(std::shared_ptr<Session> opened) { the_session = std::move(opened); }

Session& session() {
  if (!the_session) throw pt::Error("no session with a worker is open: main has to open one");
  const int searching = check::search_for_smaller();
  if (searching == 0) return *the_session;
  if (searching != search_served) the_session_of_smaller_inputs->count_answers_anew();
  search_served = searching;
  return *the_session_of_smaller_inputs;
}

void Session::begin() {
  definitions_.clear();
  scenes_.clear();
}

void Session::keep(const pt::Scene& scene) {
  if (!kept_.contains(&scene)) kept_[&scene] = definition_of(scene);
}

Session::Shared Session::definition_of(const pt::Scene& scene) const {
  Writer content;
  Codec<pt::Scene>::put(content, scene,
                        settings_.integrated ? pt::Engine::task : scene.tracer.engine());
  return defined(ObjectKind::scene, content);
}

Handle Session::need(const Shared& definition) {
  const bool named = std::ranges::any_of(
      definitions_, [&](const Shared& each) { return each->handle == definition->handle; });
  if (!named) definitions_.push_back(definition);
  return definition->handle;
}

Handle Session::name(const pt::Scene& scene) {
  const auto kept = kept_.find(&scene);
  const Handle handle = need(kept == kept_.end() ? definition_of(scene) : kept->second);
  scenes_[handle] = &scene;
  return handle;
}

Handle Session::name(const pt::Primitives& primitives) {
  Writer content;
  put(content, primitives);
  return need(defined(ObjectKind::primitives, content));
}

Handle Session::name(const pt::Bvh& bvh) {
  Writer content;
  put(content, bvh);
  return need(defined(ObjectKind::bvh, content));
}

const pt::Scene& Session::scene(Handle handle) const {
  const auto found = scenes_.find(handle);
  if (found == scenes_.end()) throw BadMessage("it named a scene that it was not given");
  return *found->second;
}

namespace {

std::optional<RadiancesAhead> radiances_ahead(const SessionSettings& settings) {
  if (!settings.answers || !answers(settings.task, Function::radiance)) {
    return std::nullopt;
  }
  const auto& script = check::radiance_script();
  if (!script || script->of_call) return std::nullopt;
  RadiancesAhead ahead{script->values, script->numbers};
  if (ahead.values.empty()) ahead.values.emplace_back();
  return ahead;
}

// Returns whether an answer of this size is a tree of one box, which has one form, or of none.
bool is_of_one_box(std::size_t size) {
  Writer tree;
  put(tree, pt::Bvh{{{}}, {0}});
  return size <= tree.bytes().size();
}

// Of inner calls and rays: with so few, 65,537 calls take some hundredths of a second.
constexpr std::int64_t kShort = 4;

// A call can be made again if all right solutions have one answer. The judge's own script of radiances is gone at the end of the run.
bool can_be_asked_again(const SessionSettings& settings, const CallHead& head, std::size_t size) {
  if (!settings.answers || settings.integrated || head.batch.count != 0) return false;
  if (answers(settings.task, Function::radiance)) return head.ahead.has_value();
  return static_cast<Function>(head.function) != Function::build_bvh || is_of_one_box(size);
}

}  // namespace

std::string_view Session::call(Function function, std::uint64_t code, const CallBatch& batch,
                               const Writer& arguments, bool records) {
  if (record_.calls == 0) first_call_ = Clock::now();
  expect_attempted();
  expect_time_left();
  record_.calls += std::max(1, batch.count);
  const CallHead head{.function = static_cast<std::uint32_t>(function),
                      .code = code,
                      .batch = batch,
                      .ahead = radiances_ahead(settings_),
                      .records = records};
  const std::vector<Shared> definitions = definitions_;
  try {
    const Writer call = message(head, arguments.bytes());
    reply_ = try_again(worker_, [&] { return converse(call); });
    Reader reply(reply_);
    const std::int64_t work = questions_ + take_head(reply, code);
    expect_attempted();
    const std::string_view result = reply.raw(reply.left());
    if (can_be_asked_again(settings_, head, result.size())) {
      Call& first = first_calls_[{questions_ > 0, function, result.size()}];
      const bool is_shorter = first.work > kShort && work > 0 && work < first.work;
      if (first.result.empty() || is_shorter) {
        first = {head, std::string(arguments.bytes()), definitions, std::string(result), work};
        if (first.head.ahead) first.head.ahead->are_told = false;
      }
    }
    return result;
  } catch (const WorkerFailed& failure) {
    fail(failure);
  } catch (const BadMessage& bad) {
    reject(bad.what());
  } catch (const std::bad_alloc&) {
    settings_.at_fault("there is no memory left");
  } catch (const pt::Error& error) {
    settings_.at_fault(error.what());
  }
  std::abort();  // at_fault has returned
}

void cannot_judge(const std::string& why) { throw pt::Error(why); }

void Session::expect_attempted() const {
  if (record_.todo.contains(settings_.task)) {
    settings_.give_up(results::Cause::not_attempted, "the task is not written yet");
  }
}

void Session::drop_known_definitions() {
  if (!worker_) known_ = {};
  std::erase_if(definitions_, [&](const Shared& each) {
    Handle& known = known_[static_cast<std::size_t>(each->kind)];
    return std::exchange(known, each->handle) == each->handle;
  });
}

Writer Session::message(const CallHead& head, std::string_view arguments) {
  drop_known_definitions();
  CallHead all = head;
  all.definitions = definitions_.size();
  Writer out;
  put(out, all);
  for (const Shared& each : definitions_) put(out, *each);
  out.raw(arguments.data(), arguments.size());
  return out;
}

// As many as two bytes can count.
constexpr int kOthers = 65536;

void Session::make_first_calls_again() {
  try {
    for (const auto& [which, first] : first_calls_) {
      // So many calls that ask the judge would take a second. Those that do not ask come first.
      const int others = std::get<bool>(which) && !first.head.ahead ? 0 : kOthers;
      if (record_.kept != 0 || answer_again(first, others) == first.result) continue;
      // A task that answers otherwise in each process keeps nothing.
      worker_.reset();
      if (answer_again(first, 0) == first.result) record_.kept = kOtherAnswer;
    }
  } catch (const check::CaseFailed&) {  // all calls together have taken too long
    return;
  }
}

std::string Session::answer_again(const Call& call, int others) {
  begin();
  definitions_ = call.definitions;
  CallHead head = call.head;
  head.others = others;
  const Writer again = message(head, call.arguments);
  try {
    reply_ = try_again(worker_, [&] { return converse(again); });
    Reader reply(reply_);
    take_head(reply, head.code);
    return std::string(reply.raw(reply.left()));
  } catch (const WorkerFailed&) {
    return "";
  } catch (const BadMessage&) {
    return "";
  }
}

// Asking the judge takes processor time of the worker too, about 10 microseconds and more on a busy
// machine. So that the limit of a call is about the task's own work, each question extends it.
constexpr std::chrono::microseconds kOfQuestion{40};

std::string Session::converse(const Writer& call) {
  questions_ = 0;
  if (!worker_) worker_ = start_worker(settings_.program, settings_.tier, kMaxPrinted);
  worker_->allow(settings_.call_limit);
  worker_->send(Kind::call, ++sequence_, call.bytes());
  for (;;) {
    Message message = worker_->receive(sequence_);
    if (message.kind == Kind::reply) return std::move(message.payload);
    if (message.kind == Kind::threw) {
      throw WorkerFailed{results::Cause::crash,
                         "it threw: " + base::printable(message.payload, 200), true};
    }
    if (message.kind == Kind::going_on) {
      go_on();
      continue;
    }
    if (!settings_.answers) throw BadMessage("it called the judge, which answers nothing here");
    const auto answer_one = [&](std::string_view question) {
      if (++questions_ > settings_.max_questions) {
        throw WorkerFailed{
            results::Cause::timeout,
            fmt::format("no answer after {} calls of other tasks", settings_.max_questions)};
      }
      return answer(settings_.task, question, *this);
    };
    if (message.kind == Kind::asked) {
      Reader in(message.payload);
      while (in.left() > 0) answer_one(get<std::string>(in));
      continue;
    }
    const Writer reply = answer_one(message.payload);
    worker_->send(Kind::answer, sequence_, reply.bytes());
    worker_->extend(kOfQuestion);
  }
}

// The next call of the batch has the limit of a call again. All calls together have theirs.
void Session::go_on() {
  worker_->allow(settings_.call_limit);
  if (running_ + worker_->running() <= settings_.total_limit) return;
  keep_totals(results::Cause::timeout);
  worker_.reset();
  expect_total_time_left();
}

std::int64_t Session::take_head(Reader& reply, std::uint64_t code) {
  const auto head = get<ReplyHead>(reply);
  if (head.code != code) throw BadMessage("the reply is of another type");
  for (const std::int64_t count : {head.closest, head.occluded}) {
    if (count < 0 || count > kMaxCount) throw BadMessage("a count of rays that is impossible");
  }
  for (std::size_t i = 0; i < kTasks.size(); ++i) {
    if (head.todo >> i & 1) record_.todo.emplace(kTasks[i]);
  }
  if (record_.kept == 0) record_.kept = head.kept;
  pt::count_rays({head.closest, head.occluded});
  const std::int64_t rays = head.closest + head.occluded;
  if (!settings_.integrated) return rays;
  for (const pt::Box& box : head.tests.boxes) check::count(box);
  for (const pt::Triangle& triangle : head.tests.triangles) check::count(triangle);
  for (const pt::Sphere& sphere : head.tests.spheres) check::count(sphere);
  return rays;
}

void Session::reject(const std::string& why) {
  fail({results::Cause::bad_reply, "an impossible reply: " + why, false});
}

void Session::fail(const WorkerFailed& failure) {
  count_failure(failure);
  known_ = {};
  if (!failure.alive) {
    if (worker_ && record_.printed.size() < kMaxPrinted) record_.printed += worker_->printed();
    if (worker_) keep_totals(failure.cause);
    worker_.reset();
  }
  const std::chrono::duration<double> limit = settings_.call_limit;
  settings_.give_up(failure.cause, failure.text.empty()
                                       ? fmt::format("no answer within {} s", limit.count())
                                       : failure.text);
  std::abort();  // give_up has returned
}

SessionRecord Session::record() const {
  SessionRecord record = record_;
  if (worker_ && record.printed.size() < kMaxPrinted) record.printed += worker_->printed();
  record.printed = base::printable(record.printed, kMaxPrinted, true);
  return record;
}

}  // namespace grader::wire
