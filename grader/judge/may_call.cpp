#include "grader/judge/may_call.h"

#include "pt/error.h"

#include <algorithm>

namespace grader {

namespace {

using Names = std::vector<std::string>;

const std::vector<MayCall>& table() {
  static const Names none, radiance{"pt::radiance"},
      scene{"pt::Scene::closest", "pt::Scene::occluded", "pt::surface_point",
            "pt::background",     "pt::sample_light",    "pt::kind_name"};
  static const std::vector<MayCall> all{
      {"estimate_pixel", {"camera_ray"}, radiance},
      {"camera_ray", none, none},
      {"hit_triangle", none, none},
      {"hit_sphere", none, none},
      {"build_bvh", none, none},
      {"hit_box", none, none},
      {"hit_bvh", {"hit_box", "hit_triangle", "hit_sphere"}, none},
      {"diffuse_bsdf", none, none},
      {"direct_hemisphere", {"diffuse_bsdf"}, scene},
      {"direct_lights", {"diffuse_bsdf"}, scene},
      {"trace_path", {"diffuse_bsdf", "direct_hemisphere", "direct_lights"}, scene},
      {"adaptive_pixel", {"camera_ray"}, radiance},
  };
  return all;
}

// The tasks of one function have its name.
bool is_of(std::string_view task, std::string_view function) {
  if (task == "diffuse_bsdf") {
    return function == "pt::diffuse_f" || function == "pt::diffuse_sample" ||
           function == "pt::diffuse_pdf";
  }
  return function == "pt::" + std::string(task);
}

}  // namespace

// What a stub calls may stay in a file that is finished.
bool MayCall::allows(std::string_view function) const {
  return function == "pt::todo" || std::ranges::count(framework, function) > 0 ||
         std::ranges::any_of(tasks, [&](const std::string& task) { return is_of(task, function); });
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
  Names all = task.tasks;
  all.insert(all.end(), task.framework.begin(), task.framework.end());
  if (all.empty()) {
    return task.slug + " may call no other task and no function of the renderer";
  }
  std::string text = task.slug + " may only call ";
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0) text += i + 1 == all.size() ? " and " : ", ";
    text += all[i];
  }
  return text;
}

}  // namespace grader
