#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace grader {

// What a task may call outside its own file. Functions that are whole in a header are the task's
// own once it includes them, and are not listed. The contract of the task names the same tasks, in
// the sentence "May call: ...".
struct MayCall {
  std::string slug;
  std::vector<std::string> tasks;      // slugs
  std::vector<std::string> framework;  // functions: "pt::Scene::closest"

  bool allows(std::string_view function) const;
};

// Of a task of the course. Throws pt::Error if there is no such task.
const MayCall& may_call(std::string_view slug);

// "hit_bvh may only call hit_box and pt::radiance", or that it calls nothing: for a person to read.
std::string in_words(const MayCall& task);

}  // namespace grader
