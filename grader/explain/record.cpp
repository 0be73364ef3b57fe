#include "grader/explain/record.h"

#include <functional>
#include <utility>

namespace grader::explain {

namespace {

template <class... In>
std::tuple<In...> in(const pt::Call& call) {
  return std::any_cast<std::tuple<In...>>(call.in);
}

template <class Out>
Out out(const pt::Call& call) {
  return std::any_cast<Out>(call.out);
}

int index_of(const pt::Scene& scene, const pt::Light* light) {
  const pt::Light* first = scene.lights.data();
  const bool is_in_list =
      std::less_equal<>()(first, light) && std::less<>()(light, first + scene.lights.size());
  return is_in_list ? static_cast<int>(light - first) : -1;
}

std::optional<Event> event_of(const pt::Scene& scene, const pt::Call& call) {
  if (call.name == "closest") {
    return TracedRay{std::get<1>(in<const pt::Scene*, pt::Ray>(call)),
                     out<std::optional<pt::Hit>>(call)};
  }
  if (call.name == "sample_light") {
    const auto [light, p] = in<const pt::Light*, pt::Vec3>(call);
    return LightDraw{index_of(scene, light), p, call.before, call.after,
                     out<pt::LightSample>(call)};
  }
  if (call.name == "diffuse_sample") {
    const auto [albedo, wo] = in<pt::Rgb, pt::Vec3>(call);
    return Direction{albedo, wo, call.before, call.after, out<pt::BsdfSample>(call)};
  }
  if (call.name == "direct_lights" || call.name == "direct_hemisphere") {
    const auto [ignored, point, samples] = in<const pt::Scene*, pt::SurfacePoint, int>(call);
    return DirectLight{
        call.name == "direct_lights", point, samples, call.before, call.after, out<pt::Rgb>(call)};
  }
  return std::nullopt;
}

// Fills in what one event was told.
struct Answering {
  const pt::Scene& scene;
  const Answers& answers;

  void operator()(TracedRay& event) const {
    event.hit = scene.tracer.closest(scene.primitives, event.ray);
  }
  void operator()(LightDraw& event) const {
    if (event.light < 0 || event.light >= std::ssize(scene.lights)) return;
    pt::Sampler sampler(event.before);
    event.sample = sample_light(scene.lights[event.light], event.p, sampler);
    event.after = sampler.state();
  }
  void operator()(Direction& event) const {
    if (answers.direction == nullptr) return;
    pt::Sampler sampler(event.before);
    event.sample = answers.direction(event.albedo, event.wo, sampler);
    event.after = sampler.state();
  }
  void operator()(DirectLight& event) const {
    const Answers::Direct task = event.by_lights ? answers.lights : answers.hemisphere;
    constexpr int kMaxSamples = 100;  // of the contract of trace_path
    if (task == nullptr || event.samples > kMaxSamples) return;
    pt::Sampler sampler(event.before);
    event.light = task(scene, event.point, event.samples, sampler);
    event.after = sampler.state();
  }
};

}  // namespace

Recording::Recording() : outer_(std::exchange(pt::recorder.calls, &calls_)) {}

Recording::~Recording() { pt::recorder.calls = outer_; }

std::vector<Event> events_of(const pt::Scene& scene, std::span<const pt::Call> calls) {
  std::vector<Event> events;
  events.reserve(calls.size());
  for (std::size_t i = 0; i < calls.size();) {
    const std::optional<Event> event = event_of(scene, calls[i]);
    if (event) events.push_back(*event);
    // A call that threw has no end.
    i = event && calls[i].end > i ? calls[i].end : i + 1;
  }
  return events;
}

void answer(const pt::Scene& scene, const Answers& answers, std::vector<Event>& events) {
  for (Event& event : events) std::visit(Answering{scene, answers}, event);
}

int numbers_between(const State& from, const State& to, int most) {
  pt::Sampler sampler(from);
  for (int drawn = 0; drawn <= most; ++drawn) {
    if (sampler.state() == to) return drawn;
    sampler.next_1d();
  }
  return -1;
}

}  // namespace grader::explain
