#include "pt/render/choose_engine.h"

#include "pt/tasks/hit_bvh.h"
#include "pt/todo.h"

namespace pt {

void choose_engine(Scene& scene, Engine engine, int max_leaf) {
  scene.tracer = Tracer(engine, scene.primitives, max_leaf);
  if (engine != Engine::task || scene.primitives.size() == 0) return;
  const Vec3 target = bounds(scene.primitives, 0).center();
  const Ray probe{target - Vec3{1, 2, 3}, {1, 2, 3}, 0, kInfinity};
  hit_bvh(scene.tracer.bvh(), scene.primitives, probe);
  occluded_bvh(scene.tracer.bvh(), scene.primitives, probe);
  for (const std::string_view slug : kTreeTasks) {
    if (!todo_reached(slug)) continue;
    scene.tracer = Tracer(Engine::linear, scene.primitives);
    return;
  }
}

}  // namespace pt
