#include "measure/calls/conversation.h"

#include "grader/base/printable.h"

#include <cmath>
#include <cstring>

#include <fmt/format.h>

namespace measure::calls {

namespace {

constexpr std::chrono::milliseconds kLimit{
    5000};  // of processor time, a thousand times what a request takes
constexpr std::size_t kMaxPrinted = 1 << 12;
constexpr std::size_t kMaxWords = 200;

}  // namespace

template <class Content>
Content Conversation::converse(const Request& request) {
  if (!worker_) worker_ = grader::wire::start_worker(program_, tier_, kMaxPrinted);
  worker_->allow(kLimit);
  worker_->send(grader::wire::Kind::call, ++sequence_,
                {reinterpret_cast<const char*>(&request), sizeof request});
  const grader::wire::Message message = worker_->receive(sequence_);
  if (message.kind == grader::wire::Kind::threw) {
    throw NoAnswer{"it threw " + grader::base::printable(message.payload, kMaxWords)};
  }
  Reply<Content> reply;
  if (message.kind != grader::wire::Kind::reply || message.payload.size() != sizeof reply) {
    throw NoAnswer{"its worker's answer makes no sense"};
  }
  std::memcpy(&reply, message.payload.data(), sizeof reply);
  if (reply.todo != 0) throw NoAnswer{"it is not written yet"};
  return reply.content;
}

template <class Content>
Content Conversation::ask(const Request& request) {
  try {
    return grader::wire::try_again(worker_, [&] { return converse<Content>(request); });
  } catch (const grader::wire::WorkerFailed& failure) {
    if (failure.cause == grader::results::Cause::timeout) {
      throw NoAnswer{fmt::format("it did not end within {} s: perhaps an endless loop",
                                 std::chrono::duration<double>(kLimit).count())};
    }
    throw NoAnswer{grader::base::printable(failure.text, kMaxWords)};
  }
}

Timed Conversation::time(Request request) {
  request.what = What::time;
  const Timed timed = ask<Timed>(request);
  if (!(timed.seconds > 0 && std::isfinite(timed.seconds)) || timed.calls == 0)
    throw NoAnswer{"its worker's answer makes no sense"};
  return timed;
}

Found Conversation::find(Request request) {
  request.what = What::find;
  return ask<Found>(request);
}

}  // namespace measure::calls
