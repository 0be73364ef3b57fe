#include "grader/stand_ins/counting.h"

namespace grader {

namespace {

Tested record;

}  // namespace

const Tested& tested() { return record; }

void forget_tests() { record = {}; }

void count(const pt::Box& box) { record.boxes.push_back(box); }
void count(const pt::Triangle& triangle) { record.triangles.push_back(triangle); }
void count(const pt::Sphere& sphere) { record.spheres.push_back(sphere); }

}  // namespace grader
