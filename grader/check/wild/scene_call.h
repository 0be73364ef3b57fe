#pragma once

#include "grader/check/wild/search.h"
#include "grader/check/wild/wild_scene.h"

#include <sstream>

#include <fmt/format.h>

namespace grader::check {

// A wild scene, and what else a task gets: Asks has ask(situation, n, seed), smaller(), text() and samples().
template <class Asks>
class SceneCall : public WildInput {
 public:
  static WildPointer make(const WildScene& scene, const Asks& asks) {
    std::optional<Situation> situation = made(scene);
    if (!situation) return nullptr;
    return std::make_shared<SceneCall>(scene, asks, std::move(*situation));
  }

  SceneCall(const WildScene& scene, const Asks& asks, Situation situation)
      : scene_(scene), asks_(asks), situation_(std::move(situation)) {}

  Explanations ask(int n, std::uint64_t seed) const override {
    return asks_.ask(situation_, n, seed);
  }
  std::vector<WildPointer> smaller() const override {
    std::vector<WildPointer> all;
    const auto keep = [&](const WildPointer& input) {
      if (input) all.push_back(input);
    };
    for (const Asks& asks : asks_.smaller()) keep(make(scene_, asks));
    for (const WildScene& scene : check::smaller(scene_)) keep(make(scene, asks_));
    return all;
  }
  std::string text() const override {
    std::ostringstream text;
    text << text_of(scene_);
    showValue(situation_, text);
    return text.str() + "\n" + asks_.text();
  }
  int samples() const override { return asks_.samples(); }

 private:
  WildScene scene_;
  Asks asks_;
  Situation situation_;
};

// The value of a generator, outside of a property. Only for calls that count how plain a file is.
template <class T>
T any_of(const rc::Gen<T>& generator, std::uint64_t seed) {
  constexpr int kSize = 100;
  return generator(rc::Random(seed), kSize).value();
}

}  // namespace grader::check
