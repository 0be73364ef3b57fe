#include "grader/worker/store.h"

namespace grader::worker {

using remote::Definition;
using remote::Handle;
using remote::ObjectKind;
using remote::Reader;

Store& store() {
  static Store instance;
  return instance;
}

void Store::define(const Definition& definition) {
  Reader in(definition.content);
  switch (definition.kind) {
    case ObjectKind::scene:
      scenes_[definition.handle] = std::make_unique<pt::Scene>(remote::get<pt::Scene>(in));
      break;
    case ObjectKind::primitives:
      primitives_[definition.handle] =
          std::make_unique<pt::Primitives>(remote::get<pt::Primitives>(in));
      break;
    case ObjectKind::bvh:
      trees_[definition.handle] = std::make_unique<pt::Bvh>(remote::get<pt::Bvh>(in));
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
  remote::Writer content;
  remote::put(content, scene);
  return remote::content_hash(ObjectKind::scene, content.bytes());
}

}  // namespace grader::worker
