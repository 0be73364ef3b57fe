#include "grader/stand_ins/counting.h"

#include <thread>
#include <utility>

namespace grader {

namespace {

Tested record;
std::optional<pt::Ray> other_ray;
Interruption next_interruption;
bool sends_interruptions = false;
std::optional<pt::Ray> due;

void interrupt_if_due() {
  if (next_interruption.tests == 0 || --next_interruption.tests > 0) return;
  if (sends_interruptions) {
    due = next_interruption.ray;
  } else {
    std::thread([] { next_interruption.run(next_interruption.ray); }).join();
  }
}

}  // namespace

const Tested& tested() { return record; }

void forget_tests() { record = {}; }

void count(const pt::Box& box) { record.boxes.push_back(box); }
void count(const pt::Triangle& triangle) { record.triangles.push_back(triangle); }
void count(const pt::Sphere& sphere) { record.spheres.push_back(sphere); }

void answer_for(const std::optional<pt::Ray>& other) { other_ray = other; }

void interrupt(const Interruption& interruption) { next_interruption = interruption; }

pt::Ray asked(const pt::Ray& ray) {
  ++record.answered_here;
  interrupt_if_due();
  if (!other_ray) return ray;
  return {other_ray->origin, other_ray->direction, ray.t_min, ray.t_max};
}

void send_interruptions() { sends_interruptions = true; }

std::optional<pt::Ray> take_interruption() { return std::exchange(due, std::nullopt); }

}  // namespace grader
