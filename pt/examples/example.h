#pragma once

#include "pt/math/rgb.h"
#include "pt/math/vec3.h"
#include "pt/sampling/sampler.h"

#include <string>
#include <type_traits>

// Examples: calls of a task, and the answers that its contract asks for. Write them before the task, in <task>.examples.cpp next to
// its file. `./run examples TASK` judges them by many right and many wrong solutions.
//
//   EXAMPLE("begins inside the sphere") {
//     const auto hit = hit_sphere({{0, 0, 0}, 1}, {{0, 0, 3}, {0, 0, -1}, 2.5, 9});
//     EXPECT(hit);
//     NEAR(hit->t, 4);
//     NEAR(hit->n, {0, 0, -1});
//   }
//
// EXPECT(condition)                              the condition holds
// NEAR(value, expected)                          two numbers or vectors agree to 1e-6 of their size, or two colours to 1e-5
// NEAR(value, expected, give_or_take)            no component differs by more than that
// MEAN(draws, call, expected, give_or_take)      the mean of so many calls, which may use the Sampler `sampler`
//
// The first of these that does not hold ends its example.

namespace pt::examples {

using Body = void (*)();

// Adds an example to those of the file.
bool add(const char* name, Body body);

// These count a check, and end the example if it does not hold. `text` is the text of the checked expression.
void expect(const char* text, bool holds);
void near(const char* text, double value, double expected);
void near(const char* text, Vec3 value, Vec3 expected);
void near(const char* text, Rgb value, Rgb expected);
void near(const char* text, double value, double expected, double give_or_take);
void near(const char* text, Vec3 value, Vec3 expected, double give_or_take);
void near(const char* text, Rgb value, Rgb expected, double give_or_take);

template <class Call>
void mean(const char* text, int draws, const Call& call,
          std::type_identity_t<std::invoke_result_t<Call, Sampler&>> expected,
          double give_or_take) {
  Sampler sampler(1);
  std::invoke_result_t<Call, Sampler&> sum{};
  for (int i = 0; i < draws; ++i) sum = sum + call(sampler);
  near((std::string("the mean of ") + text).c_str(), sum * (1.0 / draws), expected, give_or_take);
}

}  // namespace pt::examples

#define FIRSTLIGHT_JOINED(a, b) a##b
#define FIRSTLIGHT_EXAMPLE(name, line)                                    \
  static void FIRSTLIGHT_JOINED(example_, line)();                        \
  [[maybe_unused]] static const bool FIRSTLIGHT_JOINED(is_added_, line) = \
      pt::examples::add(name, &FIRSTLIGHT_JOINED(example_, line));        \
  static void FIRSTLIGHT_JOINED(example_, line)()
#define EXAMPLE(name) FIRSTLIGHT_EXAMPLE(name, __LINE__)
#define EXPECT(...) pt::examples::expect(#__VA_ARGS__, static_cast<bool>(__VA_ARGS__))
#define NEAR(value, ...) pt::examples::near(#value, value, __VA_ARGS__)
#define MEAN(draws, call, ...) \
  pt::examples::mean(          \
      #call, draws, [&]([[maybe_unused]] pt::Sampler& sampler) { return call; }, __VA_ARGS__)
