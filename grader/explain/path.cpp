#include "grader/explain/explain.h"
#include "pt/geometry/spawn_ray.h"

#include <algorithm>

namespace grader::explain {

using pt::PathSettings;
using pt::Rgb;
using pt::Vec3;

namespace {

// Below this part of the light at its first point, a path may end: float has no such numbers.
constexpr double kNoLight = 1e-30;

// A point of the path, and what was asked there.
struct Vertex {
  pt::SurfacePoint point;
  Rgb throughput = pt::gray(1);
  int bounce = 1;
  std::vector<pt::BsdfSample> directions{};
  bool is_lit = false, is_left = false;
};

// Follows the record of one path. It keeps the first thing that is wrong.
class Walk {
 public:
  Walk(const pt::Scene& scene, const pt::Tracer& exact, const pt::SurfacePoint& start,
       const PathSettings& settings, const Told& told)
      : scene_(scene),
        exact_(exact),
        settings_(settings),
        told_(told),
        last_(told.before),
        since_direction_(0) {
    path_.push_back({start});
  }

  void operator()(const LightDraw&) {}

  void operator()(const DirectLight& direct) {
    passes(direct.before, direct.after);
    Vertex* at = nullptr;
    for (Vertex& vertex : path_) {
      if (vertex.point.p == direct.point.p) at = &vertex;
    }
    if (at == nullptr || !(direct.point.n == at->point.n) ||
        !(direct.point.albedo == at->point.albedo)) {
      return wrong("follows_the_new_ray", "direct light at a point that the path did not reach",
                   "direct light at the points of the path");
    }
    const std::string where = "at point " + std::to_string(at->bounce);
    if (direct.by_lights != (settings_.direct == PathSettings::Direct::lights)) {
      wrong("starts_with_direct_light", "the other estimator of direct light " + where,
            "the one in the settings");
    }
    if (direct.samples != settings_.light_samples) {
      wrong("takes_the_light_samples_asked_for",
            std::to_string(direct.samples) + " samples of direct light " + where,
            std::to_string(settings_.light_samples) + ", as the settings say");
    }
    if (!is_wanted(at->bounce)) return;  // some look before they see that it is not wanted
    if (at->is_lit) wrong("adds_up_the_bounces_asked_for", "direct light twice " + where, "once");
    at->is_lit = true;
    sum_ += at->throughput * direct.light;
    more_ += kNoLight * max_channel(direct.light);
  }

  void operator()(const Direction& direction) {
    passes(direction.before, direction.after);
    since_direction_ = 0;
    Vertex& at = path_.back();
    const Vec3 wo = at.point.frame.to_local(at.point.wo);
    if (!(direction.albedo == at.point.albedo) || !(length(direction.wo - wo) < 1e-5)) {
      wrong(
          "follows_the_new_ray", "a direction for another albedo or another wo",
          "diffuse_sample with the albedo and the local wo of point " + std::to_string(at.bounce));
    }
    at.directions.push_back(direction.sample);
  }

  void operator()(const TracedRay& traced) {
    const Vec3 wi = normalize(traced.ray.direction);
    for (Vertex& vertex : path_) {
      if (!(length(traced.ray.origin - vertex.point.p) <= 1e-6 * vertex.point.scale)) continue;
      for (const pt::BsdfSample& sample : vertex.directions) {
        const Vec3 way = vertex.point.frame.to_world(sample.wi);
        if (length(wi - way) < 1e-4) return follow(vertex, sample, way, traced);
      }
    }
    wrong("follows_the_new_ray", "a ray that no direction of diffuse_sample leads to",
          "rays from the points of the path, along the directions of diffuse_sample");
  }

  Explanation end() {
    for (const Vertex& at : path_) {
      const bool can_be_lit =
          settings_.direct == PathSettings::Direct::hemisphere || !scene_.lights.empty();
      if (!at.is_lit && is_wanted(at.bounce) && max_channel(at.throughput) > kNoLight &&
          !is_black(at.point.albedo) && can_be_lit) {
        wrong("adds_up_the_bounces_asked_for",
              "no direct light at point " + std::to_string(at.bounce),
              "direct light at each point from " + std::to_string(settings_.from) + " to " +
                  std::to_string(settings_.to));
      }
    }
    count_survival(numbers_between(last_, told_.after));
    check_end();
    check_going_on();
    if (found_.fault == Fault::structure) return found_;
    if (!close(told_.result, sum_, 1e-4, more_)) {
      return {Fault::value,
              "adds_up_the_bounces_asked_for",
              brief(told_.result),
              "throughput times direct light, added over the points of this path: " + brief(sum_),
              sum_,
              told_.result - sum_};
    }
    return found_;
  }

 private:
  bool is_wanted(int bounce) const { return settings_.from <= bounce && bounce <= settings_.to; }

  void wrong(const char* promise, const std::string& got, const std::string& expected,
             Fault fault = Fault::structure) {
    if (found_.fault == Fault::none || found_.fault == Fault::habit) {
      found_ = {fault, promise, got, expected};
    }
  }

  // An inner call drew from the sampler.
  void passes(const State& before, const State& after) {
    const int drawn = numbers_between(last_, before);
    if (drawn < 0) {
      wrong("draws_from_the_sampler_alone",
            "an inner call with another sampler, or with one that went back",
            "inner calls with the sampler of the call, as it was left");
    }
    count_survival(drawn);
    since_direction_ += drawn;
    last_ = after;
  }

  // One number that the task drew itself is that of the survival.
  void count_survival(int drawn) {
    if (drawn == 1) survived_ += pt::Sampler(last_).next_1d() < settings_.survival;
  }

  void follow(Vertex& from, const pt::BsdfSample& sample, Vec3 way, const TracedRay& traced) {
    if (from.is_left) {
      wrong("follows_the_new_ray", "two rays from point " + std::to_string(from.bounce), "one");
    }
    from.is_left = true;
    const pt::Ray right = spawn_ray(from.point, way);
    const auto hit = exact_.closest(scene_.primitives, right);
    if (hit.has_value() != traced.hit.has_value() ||
        (hit && hit->primitive != traced.hit->primitive)) {
      wrong("follows_the_new_ray", "a ray that meets another surface than the one from spawn_ray",
            "the first surface in the direction of diffuse_sample");
    }
    if (!traced.hit) return;
    Vertex next{surface_point(scene_, traced.ray, *traced.hit)};
    next.throughput = from.throughput * sample.f * (std::abs(sample.wi.z) / sample.pdf);
    if (from.bounce > 1) next.throughput /= settings_.survival;
    next.bounce = from.bounce + 1;
    path_.push_back(next);  // `from` is not valid from here on
  }

  // A path goes on from a later point if a number says so.
  void check_going_on() {
    const auto gone_on = std::ranges::count_if(
        path_, [](const Vertex& vertex) { return vertex.is_left && vertex.bounce > 1; });
    if (settings_.survival >= 1 || gone_on <= survived_) return;
    wrong("does_not_depend_on_survival",
          "a path that goes on from " + std::to_string(gone_on) + " points after the first, with " +
              std::to_string(survived_) + " random numbers below the survival",
          "one such number for each of them", Fault::habit);
  }

  // A path ends because it left the scene, at the last bounce, where nothing is reflected, or by a random number.
  void check_end() {
    const int drawn = numbers_between(last_, told_.after);
    if (drawn < 0) {
      const bool stands = told_.after == told_.before;
      return wrong("draws_from_the_sampler_alone",
                   stands ? "a call that leaves the sampler as it was before"
                          : "a sampler that is not the one with which the path was made",
                   "a sampler that has moved on by all numbers that were drawn");
    }
    const Vertex& at = path_.back();
    if (at.is_left || at.bounce >= settings_.to || settings_.from > settings_.to ||
        is_black(at.point.albedo) || !(max_channel(at.throughput) > kNoLight)) {
      return;
    }
    if (!at.directions.empty()) {
      const pt::BsdfSample& way = at.directions.back();
      const bool brings_light = way.pdf > 0 && way.wi.z > 0 && !is_black(way.f);
      if (!brings_light) return;
    }
    const std::string where = "a path that ends at point " + std::to_string(at.bounce) + " of " +
                              std::to_string(settings_.to);
    if (at.bounce == 1) {
      return wrong("takes_the_first_bounce_always", where,
                   "a path that always goes on from its first point");
    }
    if (since_direction_ + drawn == 0 || (!at.directions.empty() && drawn == 0)) {
      return wrong("reaches_the_last_bounce", where + ", and no random number says so",
                   "a path that only a random number ends before its last point");
    }
    if (since_direction_ + drawn > 1 || !at.directions.empty()) return;
    const double xi = number_drawn();
    if (xi >= 0 && xi < settings_.survival * (1 - 1e-6)) {
      wrong("reaches_the_last_bounce", where + ", where the random number is " + brief(xi),
            "a path that goes on with a number below the survival, " + brief(settings_.survival),
            Fault::habit);
    }
  }

  // The number before the end; -1 if it was drawn earlier.
  double number_drawn() const {
    if (numbers_between(last_, told_.after) != 1) return -1;
    return pt::Sampler(last_).next_1d();
  }

  const pt::Scene& scene_;
  const pt::Tracer& exact_;
  const PathSettings& settings_;
  const Told& told_;
  State last_;           // of the sampler, after the last inner call
  int since_direction_;  // numbers that the task itself drew after the last direction
  int survived_ = 0;     // its own numbers that are below the survival
  std::vector<Vertex> path_;
  Rgb sum_;
  double more_ = 0;  // the error of a throughput that float does not have
  Explanation found_;
};

}  // namespace

Explanation explain_path(const pt::Scene& scene, const pt::Tracer& exact,
                         const pt::SurfacePoint& start, const PathSettings& settings,
                         const Told& told) {
  // A hundred points have some hundred inner calls. A longer record would take long to compare.
  constexpr std::size_t kMaxEvents = 5000;
  if (told.events.size() > kMaxEvents) {
    return {Fault::value,
            "stops_after_the_last_bounce",
            std::to_string(told.events.size()) + " inner calls",
            "those of one path",
            {},
            told.result};
  }
  Walk walk(scene, exact, start, settings, told);
  for (const Event& event : told.events) std::visit(walk, event);
  return walk.end();
}

}  // namespace grader::explain
