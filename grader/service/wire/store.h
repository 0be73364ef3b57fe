#pragma once

#include "grader/service/wire/message.h"

#include <optional>

// The worker's end: the objects that calls name.

namespace grader::wire {

// The objects that the judge has sent, the last one of each kind, and their handles. An object takes the
// place of the one before it: a task that remembers something of an object by its address remembers it of
// the next one too.
class Store {
 public:
  void define(const Definition& definition);

  template <class Object>
  const Object& find(Handle handle) const {
    const Place<Object>& place = place_of<Object>();
    if (!place.object || place.handle != handle) throw BadMessage("an unknown handle");
    return *place.object;
  }

  // The name of a scene that the judge has sent, or of an exact copy.
  Handle name(const pt::Scene& scene) const;

 private:
  template <class Object>
  struct Place {
    Handle handle = 0;
    std::optional<Object> object;

    void take(const Definition& definition);
  };

  template <class Object>
  const Place<Object>& place_of() const {
    if constexpr (std::is_same_v<Object, pt::Scene>) return scene_;
    if constexpr (std::is_same_v<Object, pt::Primitives>) return primitives_;
    if constexpr (std::is_same_v<Object, pt::Bvh>) return tree_;
  }

  Place<pt::Scene> scene_;
  Place<pt::Primitives> primitives_;
  Place<pt::Bvh> tree_;
};

// The store of this worker.
Store& store();

}  // namespace grader::wire
