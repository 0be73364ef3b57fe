// right: a coroutine yields the samples, which are summed in pairs; every second bit of one random
// number is for x, the others for y.
#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/estimate_pixel.h"

#include <coroutine>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace pt {

namespace {

class Samples {
 public:
  struct promise_type {
    Rgb sample;
    Samples get_return_object() {
      return Samples(std::coroutine_handle<promise_type>::from_promise(*this));
    }
    std::suspend_always initial_suspend() noexcept { return {}; }
    std::suspend_always final_suspend() noexcept { return {}; }
    std::suspend_always yield_value(Rgb next) noexcept {
      sample = next;
      return {};
    }
    void return_void() {}
    void unhandled_exception() { throw; }
  };

  explicit Samples(std::coroutine_handle<promise_type> handle) : handle_(handle) {}
  Samples(Samples&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  ~Samples() {
    if (handle_) handle_.destroy();
  }

  std::optional<Rgb> next() {
    handle_.resume();
    if (handle_.done()) return std::nullopt;
    return handle_.promise().sample;
  }

 private:
  std::coroutine_handle<promise_type> handle_;
};

// 53 bits are enough for two coordinates of 26 and 27.
Vec2 unzipped(double xi) {
  auto bits = static_cast<std::uint64_t>(xi * 0x1p54);
  Vec2 at;
  for (int i = 0; i < 27; ++i, bits >>= 2) {
    at.x = 0.5 * (at.x + static_cast<double>(bits >> 1 & 1));
    at.y = 0.5 * (at.y + static_cast<double>(bits & 1));
  }
  return at;
}

Samples samples_of(const View& view, int x, int y, int samples, Sampler& sampler) {
  for (int i = 0; i < samples; ++i) {
    const Vec2 at = samples == 1 ? Vec2{0.5, 0.5} : unzipped(sampler.next_1d());
    const Ray ray = camera_ray(view.camera, (x + at.x) / view.width, (y + at.y) / view.height);
    co_yield radiance(view.scene, ray, view.settings, sampler);
  }
}

// Sums of 1, 2, 4, ... samples, each waiting for another one of its size: a binary counter.
class SumInPairs {
 public:
  void add(Rgb value) {
    std::size_t size = 0;
    for (; size < waiting_.size() && waiting_[size]; ++size) {
      value += *std::exchange(waiting_[size], std::nullopt);
    }
    if (size == waiting_.size()) waiting_.emplace_back();
    waiting_[size] = value;
  }
  Rgb total() const {
    Rgb sum;
    for (const auto& each : waiting_) sum += each.value_or(Rgb{});
    return sum;
  }

 private:
  std::vector<std::optional<Rgb>> waiting_;
};

}  // namespace

Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  SumInPairs sum;
  Samples all = samples_of(view, x, y, samples, sampler);
  while (const std::optional<Rgb> sample = all.next()) sum.add(*sample);
  return sum.total() / samples;
}

}  // namespace pt
