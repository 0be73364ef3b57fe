#include "grader/judge/may_call.h"

#include "pt/error.h"

#include <algorithm>

namespace grader {

namespace {

using Names = std::vector<std::string>;

Names operator+(Names all, const Names& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

const std::vector<MayCall>& table() {
  static const Names none, pixel{"pt::camera_ray", "pt::radiance"},
      bsdf{"pt::diffuse_f", "pt::diffuse_sample", "pt::diffuse_pdf"},
      tracing{"pt::Scene::closest", "pt::Scene::occluded", "pt::surface_point"};
  static const std::vector<MayCall> all{
      {"estimate_pixel", pixel},
      {"camera_ray", none},
      {"hit_triangle", none},
      {"hit_sphere", none},
      {"build_bvh", none},
      {"hit_box", none},
      {"hit_bvh", {"pt::hit_box", "pt::hit_triangle", "pt::hit_sphere"}},
      {"diffuse_bsdf", none},
      {"direct_hemisphere", bsdf + tracing + Names{"pt::background"}},
      {"direct_lights", bsdf + tracing + Names{"pt::sample_light"}},
      {"trace_path", bsdf + tracing + Names{"pt::direct_hemisphere", "pt::direct_lights"}},
      {"adaptive_pixel", pixel},
  };
  return all;
}

}  // namespace

// What a stub calls may stay in a file that is finished.
bool MayCall::allows(std::string_view function) const {
  return function == "pt::todo" || std::ranges::count(functions, function) > 0;
}

const MayCall& may_call(std::string_view slug) {
  const auto found = std::ranges::find(table(), slug, &MayCall::slug);
  if (found == table().end()) {
    throw pt::Error("nothing says which functions " + std::string(slug) +
                    " may call: write it into grader/judge/may_call.cpp");
  }
  return *found;
}

std::string in_words(const MayCall& task) {
  if (task.functions.empty()) {
    return task.slug + " may call no other task and no function of the renderer";
  }
  std::string text = task.slug + " may only call ";
  for (std::size_t i = 0; i < task.functions.size(); ++i) {
    if (i > 0) text += i + 1 == task.functions.size() ? " and " : ", ";
    text += task.functions[i];
  }
  return text;
}

}  // namespace grader
