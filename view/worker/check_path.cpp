#include "pt/geometry/spawn_ray.h"
#include "view/worker/check.h"

#include <array>
#include <cstdio>

namespace view {

namespace {

using Findings = std::vector<Finding>;

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

// A ray that leaves a surface starts off it, or its range does.
void check_start(int bounce, const char* cell, const char* task, const pt::SurfacePoint& point,
                 const pt::Ray& ray, const char* promise, Findings& found) {
  const double height = std::abs(dot(point.geometric_normal, ray.origin - point.p));
  const bool is_off = height >= 0.25 * pt::kOffset * point.scale || ray.t_min > 0;
  if (is_off) return;
  found.push_back({bounce, cell, task, promise, "the ray starts on the surface that it leaves"});
}

const char* promise_of(const pt::Light& light) {
  constexpr std::array<const char*, 6> kPromises{
      "matches_a_rectangle",         "matches_a_sphere",
      "matches_a_rectangle",         "matches_a_point_light",
      "matches_a_directional_light", "matches_the_sky"};
  return kPromises[light.index()];
}

// What the draws of direct_lights amount to: the sum over all lights of the mean of f L cos / pdf.
std::optional<pt::Rgb> sum_of_draws(const pt::Scene& scene, const pt::Tracer& exact,
                                    const Bounce& at, const Direct& direct) {
  std::vector<pt::Rgb> sums(scene.lights.size());
  std::vector<int> draws(scene.lights.size());
  for (const Draw& draw : direct.draws) {
    if (draw.light < 0) return std::nullopt;  // the task has made a light of its own
    ++draws[draw.light];
    if (!(draw.cosine > 0) || is_black(draw.sample.radiance)) continue;
    const pt::Ray shadow = shadow_ray(at.point, draw.sample.wi, draw.sample.distance);
    const bool is_hidden =
        draw.was_traced ? draw.is_hidden : exact.occluded(scene.primitives, shadow);
    if (is_hidden) continue;
    sums[draw.light] +=
        (at.point.albedo / pt::kPi) * draw.sample.radiance * (draw.cosine / draw.sample.pdf);
  }
  pt::Rgb sum;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (draws[i] == 0) return std::nullopt;
    sum += sums[i] / draws[i];
  }
  return sum;
}

pt::Rgb mean_of_rays(const Bounce& at, const Direct& direct) {
  pt::Rgb sum;
  for (const Draw& draw : direct.draws) {
    sum += (at.point.albedo / pt::kPi) * draw.sample.radiance * (draw.cosine / draw.sample.pdf);
  }
  return sum / static_cast<double>(std::max<std::size_t>(1, direct.draws.size()));
}

// The reflected part of the light of a draw, as the task that is linked says. With a wrong f, direct light is wrong without a
// mistake in the task that adds it up.
bool has_right_f(const Bounce& at, const Draw& draw) {
  const pt::Frame& frame = at.point.frame;
  return !(draw.cosine > 1e-6) || close(diffuse_f(at.point.albedo, frame.to_local(at.point.wo),
                                                  frame.to_local(draw.sample.wi)),
                                        at.point.albedo / pt::kPi);
}

void check_shadow_rays(int bounce, const Bounce& at, const Direct& direct, Findings& found) {
  for (const Draw& draw : direct.draws) {
    if (!draw.was_traced) continue;
    check_start(bounce, "direct", direct.task.data(), at.point, draw.ray, "starts_off_the_surface",
                found);
    if (draw.light < 0 || !(draw.sample.distance < pt::kInfinity)) continue;
    const double reach = draw.ray.t_max * length(draw.ray.direction) / draw.sample.distance;
    if (!(reach < 1)) {
      found.push_back({bounce, "direct", "direct_lights", "is_not_hidden_by_the_light_itself",
                       "the shadow ray does not end before the light"});
    } else if (!(reach > 0.998)) {
      found.push_back({bounce, "direct", "direct_lights", "casts_shadows",
                       "the shadow ray ends at " + number(reach) + " of the way to the light"});
    }
  }
}

// A prediction of the light of later bounces that is off by a ratio, and the mistake that it is typical of.
void explain(int bounce, double step, const Bounce& before, const pt::PathSettings& settings,
             Findings& found) {
  const pt::BsdfSample& sample = before.next[0];
  const auto add = [&](const char* promise, const char* text) {
    found.push_back({bounce, "part", "trace_path", promise,
                     "it is " + number(step) + " times the throughput and direct light: " + text});
  };
  if (bounce > 2) return add("does_not_depend_on_survival", "it is multiplied by the survival");
  const double cosine = std::abs(sample.wi.z);
  if (close(step * cosine, 1)) return add("weighs_by_the_cosine", "the cosine is missing");
  if (close(step, cosine)) return add("weighs_by_the_cosine", "the cosine is there twice");
  if (close(step, sample.pdf)) {
    return add("divides_by_the_pdf_of_the_sample", "it is not divided by the pdf");
  }
  if (close(step * settings.survival, 1)) {
    return add("takes_the_first_bounce_always", "it is divided by the survival");
  }
  add("divides_by_the_pdf_of_the_sample", "this is not f cos / pdf of the direction");
}

// The parts of the sum against f cos / pdf and direct light. `settings.survival` need not be the task's own.
void check_parts(const pt::PathSettings& settings, Path& path) {
  pt::Rgb throughput = pt::gray(1);  // without survival
  double so_far = 1;                 // the ratio at the last point that tells one
  std::size_t told = 0;
  for (std::size_t i = 0; i < path.bounces.size(); ++i) {
    const Bounce& at = path.bounces[i];
    const int bounce = static_cast<int>(i) + 1;
    const auto add = [&](const char* promise, const char* text) {
      path.findings.push_back({bounce, "part", "trace_path", promise, text});
    };
    if (!at.direct.empty() && !is_black(at.direct[0].light)) {
      const pt::Rgb expected = throughput * at.direct[0].light;
      if (bounce < settings.from || bounce > settings.to) {
        if (!is_black(at.part)) add("adds_up_the_bounces_asked_for", "this bounce is not wanted");
      } else if (!is_black(expected)) {
        const double ratio = luminance(at.part) / luminance(expected);
        if (!close(at.part, ratio * expected, 1e-3)) {
          return add(bounce == 1 ? "starts_with_direct_light" : "tints_at_each_bounce",
                     "the channels are not those of the throughput times direct light");
        }
        if (bounce == 1 && !close(ratio, 1)) {
          return add("starts_with_direct_light", "direct light is not added as it is");
        }
        const double step = ratio / so_far;
        // From the third point on a task may have a survival of its own, or share the light between two directions that go on.
        const bool is_fine =
            bounce <= 2 ? close(step, 1) : step > 1 - 1e-4 || !close(step, settings.survival);
        if (!is_fine && told + 1 == i) {
          return explain(bounce, step, path.bounces[i - 1], settings, path.findings);
        }
        if (!is_fine) return;
        so_far = ratio;
        told = i;
      } else if (!is_black(at.part)) {
        return add("tints_at_each_bounce", "a black surface before it reflects nothing");
      }
    }
    if (!at.next.empty()) throughput *= factor(at.next[0]);
  }
}

// Every direction is followed, as far as the settings say.
void check_way(const pt::PathSettings& settings, Path& path) {
  for (std::size_t i = 0; i < path.bounces.size(); ++i) {
    const Bounce& at = path.bounces[i];
    const int bounce = static_cast<int>(i) + 1;
    const auto add = [&](const char* cell, const char* promise, const std::string& text) {
      path.findings.push_back({bounce, cell, "trace_path", promise, text});
    };
    // Some find the next point before they see that it is not wanted.
    const bool is_used = !at.direct.empty() || !at.next.empty();
    if (bounce > settings.to && is_used)
      add("point", "stops_after_the_last_bounce", "the path has too many points");
    if (!at.direct.empty()) {
      const bool by_lights = settings.direct == pt::PathSettings::Direct::lights;
      if ((at.direct[0].task == "direct_lights") != by_lights) {
        add("direct", "starts_with_direct_light", "it is not by the method in the settings");
      } else if (at.direct[0].samples != settings.light_samples) {
        add("direct", "takes_the_light_samples_asked_for",
            std::to_string(at.direct[0].samples) + " samples are taken");
      }
    }
    if (at.ray && !at.next.empty()) {
      const pt::Vec3 wi = at.point.frame.to_world(at.next[0].wi);
      if (!(length(normalize(at.ray->direction) - wi) <= 1e-4)) {
        add("wi", "follows_the_new_ray", "the path goes on in another direction");
      }
      if (!(length(at.ray->origin - at.point.p) <= 1e-6 * at.point.scale)) {
        add("wi", "follows_the_new_ray", "the path goes on from another point");
      }
    }
    const bool could_go_on = bounce < settings.to && !is_black(at.point.albedo);
    // No number is needed at the first point: one that is drawn there may say where the path ends.
    const bool has_number = !at.drawn.empty() || !path.bounces[0].drawn.empty();
    if (at.next.empty() && could_go_on && (bounce == 1 || !has_number)) {
      add("survival", bounce == 1 ? "takes_the_first_bounce_always" : "reaches_the_last_bounce",
          "the path ends here, and no random number says so");
    }
  }
}

}  // namespace

void check_sample(int bounce, const Bounce& at, Findings& found) {
  for (const pt::BsdfSample& sample : at.next) {
    const auto add = [&](const char* cell, const char* promise, const std::string& text) {
      found.push_back({bounce, cell, "diffuse_bsdf", promise, text});
    };
    if (!(std::abs(length(sample.wi) - 1) <= 2e-5) || !(sample.wi.z * at.wo.z >= 0)) {
      add("wi", "samples_the_side_of_wo", "wi is not a unit vector on the side of wo");
    }
    const pt::Rgb f = diffuse_f(at.point.albedo, at.wo, sample.wi);
    const double pdf = diffuse_pdf(at.wo, sample.wi);
    if (!close(sample.f, f)) {
      add("f", "a_sample_knows_its_own_f_and_pdf", "diffuse_f says " + number(f.r) + " in red");
    } else if (!(sample.f.r >= 0 && sample.f.g >= 0 && sample.f.b >= 0) ||
               (sample.wi.z > 1e-90 && !close(sample.f, at.point.albedo / pt::kPi))) {
      add("f", "f_reflects_the_albedo", "f is not the albedo divided by pi");
    }
    if (!close(sample.pdf, pdf) || !(sample.pdf >= 0)) {
      add("pdf", "a_sample_knows_its_own_f_and_pdf", "diffuse_pdf says " + number(pdf));
    }
  }
}

void check_direct(const pt::Scene& scene, const pt::Tracer& exact, int bounce, const Bounce& at,
                  Findings& found) {
  for (const Direct& direct : at.direct) {
    const bool by_lights = direct.task == "direct_lights";
    const auto add = [&](const char* promise, const std::string& text) {
      found.push_back({bounce, "direct", std::string(direct.task), promise, text});
    };
    if (!is_finite(direct.light)) {
      add(by_lights ? "takes_lights_of_any_brightness" : "sees_lights_of_any_brightness",
          "the light is not finite");
    } else if (!(direct.light.r >= 0 && direct.light.g >= 0 && direct.light.b >= 0)) {
      add(by_lights ? "keeps_light_on_its_side" : "adds_no_emission_of_its_own",
          "the light is negative");
    }
    check_shadow_rays(bounce, at, direct, found);
    if (!std::ranges::all_of(direct.draws, [&](const Draw& d) { return has_right_f(at, d); })) {
      found.push_back({bounce, "direct", "diffuse_bsdf", "f_reflects_the_albedo",
                       "diffuse_f is not the albedo divided by pi"});
      continue;
    }
    if (!direct.plain || direct.draws.empty()) continue;
    const std::optional<pt::Rgb> sum =
        by_lights ? sum_of_draws(scene, exact, at, direct) : mean_of_rays(at, direct);
    if (!sum || close(direct.light, *sum, 1e-3)) continue;
    const std::string text = "f L cos / pdf of what was drawn makes " + number(luminance(*sum)) +
                             " (luminance), and not " + number(luminance(direct.light));
    if (!by_lights) {
      add("takes_the_emission_of_what_is_hit", text);
    } else {
      add(scene.lights.size() == 1 ? promise_of(scene.lights[0]) : "adds_the_lights_up", text);
    }
  }
}

void check_path(const pt::PathSettings& settings, Path& path) {
  const auto add = [&](const char* promise, const char* text) {
    path.findings.push_back({0, "result", "trace_path", promise, text});
  };
  if (!is_finite(path.traced)) add("stays_finite", "the result is not finite");
  if (!path.is_one || !is_finite(path.traced)) return;
  if (path.lost_point) add("follows_the_new_ray", "direct light is taken beside the path");
  if (!is_black(path.rest)) {
    add("counts_emission_once", "without direct light the result is not black");
  }
  check_way(settings, path);
  if (path.bounces.empty() || path.lost_point) return;
  const std::size_t before = path.findings.size();
  check_parts(settings, path);
  if (path.findings.size() == before && !close(sum_of_parts(path), path.traced, 1e-3)) {
    add("takes_any_amount_of_light", "the result is not the sum of its parts");
  }
}

}  // namespace view
