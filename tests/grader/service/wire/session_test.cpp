// The limits of a call, and of all calls of a session together. The worker crashes, hangs or answers, as
// the arguments say (obedient_hit_sphere.cpp, obedient_diffuse_bsdf.cpp).
#include "grader/service/wire/session.h"

#include "grader/check/language/repeat.h"
#include "grader/check/mocks/scripted_radiance.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/estimate_pixel.h"
#include "pt/tasks/hit_sphere.h"

#include <string>

#include <gtest/gtest.h>

namespace grader::tests {
namespace {

using results::Cause;
using wire::SessionSettings;

struct GaveUp {
  Cause cause = Cause::wrong;
  std::string why;
};

SessionSettings settings() {
  SessionSettings settings;
  settings.task = "hit_sphere";
  settings.program = FIRSTLIGHT_OBEDIENT_WORKER;
  settings.call_limit = std::chrono::milliseconds(100);
  settings.give_up = [](Cause cause, const std::string& why) { throw GaveUp{cause, why}; };
  return settings;
}

constexpr double kAnswers = 1, kCrashes = 2, kHangs = 3;

// Returns the reason why a call failed, or an empty one if it was answered.
GaveUp call(double radius) {
  try {
    pt::hit_sphere({{0, 0, 0}, radius}, {{0, 0, 9}, {0, 0, -1}, 0, 99});
  } catch (const GaveUp& reason) {
    return reason;
  }
  return {};
}

TEST(session, ends_after_as_many_calls_without_an_answer_as_are_allowed) {
  SessionSettings two = settings();
  two.max_timeouts = 2;
  open_session(two);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(call(kHangs).why, "no answer within 0.1 s") << i;
  }
  const GaveUp third = call(kAnswers);
  EXPECT_EQ(third.why, "not called any more: 2 calls got no answer");
  EXPECT_EQ(third.cause, Cause::not_called);
}

TEST(session, ends_after_as_many_crashes_as_are_allowed) {
  SessionSettings two = settings();
  two.max_failures = 2;
  open_session(two);
  EXPECT_EQ(call(kCrashes).cause, Cause::crash);
  EXPECT_EQ(call(kAnswers).why, "");
  EXPECT_EQ(call(kCrashes).cause, Cause::crash);
  const GaveUp next = call(kAnswers);
  EXPECT_EQ(next.why, "not called any more: too many calls crashed or gave no answer");
  EXPECT_EQ(next.cause, Cause::not_called);
}

// Draws samples in one message. Each call takes .03 s, or is endless if the albedo is 3.
GaveUp sample(int calls, double albedo) {
  try {
    check::repeat<pt::diffuse_sample>(calls, 1, pt::gray(albedo), pt::Vec3{0, 0, 1});
  } catch (const GaveUp& reason) {
    return reason;
  }
  return {};
}

TEST(session, gives_each_call_of_a_message_the_limit_of_a_call) {
  open_session(settings());
  EXPECT_EQ(sample(20, 1).why, "");
  EXPECT_EQ(sample(20, 3).why, "no answer within 0.1 s");
}

TEST(session, gives_all_calls_of_a_message_the_limit_of_all_calls) {
  SessionSettings little = settings();
  little.total_limit = std::chrono::milliseconds(300);
  open_session(little);
  const GaveUp reason = sample(200, 1);
  EXPECT_EQ(reason.why.find("not called any more: all calls so far took "), 0u) << reason.why;
  EXPECT_EQ(reason.cause, Cause::timeout);
}

// Asks the judge for the light of so many samples.
GaveUp ask(int samples, SessionSettings settings) {
  settings.task = "estimate_pixel";
  open_session(settings);
  const pt::Camera camera{{}, pt::frame_from_normal({0, 0, 1}), 60, 40, 0.1, 9};
  pt::Scene scene;
  try {
    pt::Sampler sampler(1);
    pt::estimate_pixel({scene, camera, {}, 4, 4}, 0, 0, samples, sampler);
  } catch (const GaveUp& reason) {
    return reason;
  }
  return {};
}

// Messages alone, ten thousands of them, take some ten times the limit of the call.
TEST(session, gives_a_call_time_for_its_questions) {
  SessionSettings asks = settings();
  asks.call_limit = std::chrono::milliseconds(20);
  EXPECT_EQ(ask(10000, asks).why, "");
}

// The worker has these radiances before it calls; the judge still learns of every call, in order.
TEST(session, learns_of_the_calls_whose_answers_it_gave_in_advance) {
  constexpr int kSamples = 5000;  // more bytes of questions than are sent at once
  check::script_radiance({.values = {{1, 10, 0}, {2, 20, 0}, {4, 40, 0}}, .numbers = 3});
  const pt::Camera camera{{}, pt::frame_from_normal({0, 0, 1}), 60, 40, 0.1, 9};
  pt::Scene scene;
  SessionSettings asks = settings();
  asks.task = "estimate_pixel";
  asks.max_questions = kSamples;
  open_session(asks);
  pt::Sampler sampler(1);
  const pt::Rgb mean = pt::estimate_pixel({scene, camera, {}, 4, 4}, 0, 0, kSamples, sampler);
  EXPECT_NEAR(mean.r, 4 - 5.0 / kSamples, 1e-9);
  EXPECT_NEAR(mean.g, 40 - 50.0 / kSamples, 1e-9);
  const std::vector<check::RadianceCall>& calls = check::radiance_calls();
  ASSERT_EQ(calls.size(), kSamples);
  pt::Sampler at(1);
  for (const check::RadianceCall& each : calls) {
    for (int drawn = 0; at.state() != each.sampler; at.next_1d()) ASSERT_LT(drawn++, 10);
    for (int i = 0; i < 3; ++i) at.next_1d();
  }
  EXPECT_EQ(at.state(), sampler.state());
  check::radiance_script() = std::nullopt;
}

TEST(session, ends_a_call_that_asks_for_ever) {
  for (const bool ahead : {false, true}) {
    if (ahead) check::script_radiance({});
    SessionSettings few = settings();
    few.max_questions = 100;
    EXPECT_EQ(ask(100, few).why, "");
    const GaveUp reason = ask(101, few);
    EXPECT_EQ(reason.why, "no answer after 100 calls of other tasks");
    EXPECT_EQ(reason.cause, Cause::timeout);
  }
  check::radiance_script() = std::nullopt;
}

// One answer takes some hundred bytes.
TEST(session, ends_after_as_many_bytes_as_are_allowed) {
  SessionSettings few = settings();
  few.max_answered = 1;
  open_session(few);
  EXPECT_EQ(call(kAnswers).why, "");
  const GaveUp next = call(kAnswers);
  EXPECT_EQ(next.why,
            "not called any more: its results and its calls of other tasks were 0 MiB in all, "
            "where 0 are the most");
  EXPECT_EQ(next.cause, Cause::bad_reply);
  EXPECT_EQ(call(kAnswers).cause, Cause::not_called);
}

TEST(session, counts_answers_anew_for_each_search) {
  SessionSettings few = settings();
  few.max_answered = 1;
  open_session(few);
  EXPECT_EQ(call(kAnswers).why, "");
  wire::session().count_answers_anew();
  EXPECT_EQ(call(kAnswers).why, "");
  EXPECT_EQ(call(kAnswers).cause, Cause::bad_reply);
}

// The session ends before a smaller input is tried, so this says nothing about the submission.
TEST(session, of_smaller_inputs_ends_without_a_cause) {
  SessionSettings smaller = settings();
  smaller.max_failures = 1;
  smaller.smaller_inputs = true;
  open_session(smaller);
  EXPECT_EQ(call(kCrashes).cause, Cause::crash);
  EXPECT_EQ(call(kAnswers).cause, Cause::not_attempted);
}

}  // namespace
}  // namespace grader::tests
