#include "grader/service/wire/store.h"

namespace grader::wire {

Store& store() {
  static Store instance;
  return instance;
}

template <class Object>
void Store::Place<Object>::take(const Definition& definition) {
  Reader in(definition.content);
  handle = definition.handle;
  object.emplace(get<Object>(in));
}

void Store::define(const Definition& definition) {
  switch (definition.kind) {
    case ObjectKind::scene:
      return scene_.take(definition);
    case ObjectKind::primitives:
      return primitives_.take(definition);
    case ObjectKind::bvh:
      return tree_.take(definition);
  }
}

Handle Store::name(const pt::Scene& scene) const {
  if (scene_.object && &scene == &*scene_.object) return scene_.handle;
  Writer content;
  put(content, scene);
  return content_hash(ObjectKind::scene, content.bytes());
}

}  // namespace grader::wire
