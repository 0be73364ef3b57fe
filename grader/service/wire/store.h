#pragma once

#include "grader/service/wire/message.h"

#include <map>
#include <memory>

// The worker's end: the objects that calls name.

namespace grader::wire {

// Objects that the judge has sent once and then names by handle, and the handles of objects.
class Store {
 public:
  void define(const Definition& definition);
  void forget();

  template <class Object>
  const Object& find(Handle handle) const {
    const auto& objects = objects_of<Object>();
    const auto found = objects.find(handle);
    if (found == objects.end()) throw BadMessage("an unknown handle");
    return *found->second;
  }

  // The name of a scene that the judge has sent, or of an exact copy.
  Handle name(const pt::Scene& scene) const;

 private:
  template <class Object>
  using Objects = std::map<Handle, std::unique_ptr<const Object>>;

  template <class Object>
  const Objects<Object>& objects_of() const {
    if constexpr (std::is_same_v<Object, pt::Scene>) return scenes_;
    if constexpr (std::is_same_v<Object, pt::Primitives>) return primitives_;
    if constexpr (std::is_same_v<Object, pt::Bvh>) return trees_;
  }

  Objects<pt::Scene> scenes_;
  Objects<pt::Primitives> primitives_;
  Objects<pt::Bvh> trees_;
};

// The store of this worker.
Store& store();

}  // namespace grader::wire
