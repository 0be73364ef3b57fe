#include "grader/service/wire/store.h"

namespace grader::wire {

Store& store() {
  static Store instance;
  return instance;
}

void Store::define(const Definition& definition) {
  Reader in(definition.content);
  switch (definition.kind) {
    case ObjectKind::scene:
      scenes_[definition.handle] = std::make_unique<pt::Scene>(get<pt::Scene>(in));
      break;
    case ObjectKind::primitives:
      primitives_[definition.handle] = std::make_unique<pt::Primitives>(get<pt::Primitives>(in));
      break;
    case ObjectKind::bvh:
      trees_[definition.handle] = std::make_unique<pt::Bvh>(get<pt::Bvh>(in));
      break;
  }
}

void Store::forget() {
  scenes_.clear();
  primitives_.clear();
  trees_.clear();
}

Handle Store::name(const pt::Scene& scene) const {
  for (const auto& [handle, known] : scenes_) {
    if (known.get() == &scene) return handle;
  }
  Writer content;
  put(content, scene);
  return content_hash(ObjectKind::scene, content.bytes());
}

}  // namespace grader::wire
