#include "grader/check/mocks/scripted_radiance.h"

#include "pt/render/radiance.h"

#include <utility>

namespace grader::check {

namespace {

std::function<pt::Rgb(int, const pt::Ray&)> current_script;
int numbers_per_call = 0;
std::vector<RadianceCall> calls;

}  // namespace

void script_radiance(std::function<pt::Rgb(int, const pt::Ray&)> script, int numbers) {
  current_script = std::move(script);
  numbers_per_call = numbers;
  calls.clear();
}

const std::vector<RadianceCall>& radiance_calls() { return calls; }

}  // namespace grader::check

namespace pt {

Rgb radiance(const Scene&, const Ray& ray, const PathSettings& settings, Sampler& sampler) {
  using namespace grader::check;
  calls.push_back({ray, settings, sampler.state()});
  for (int i = 0; i < numbers_per_call; ++i) sampler.next_1d();
  return current_script ? current_script(static_cast<int>(calls.size()) - 1, ray) : Rgb{};
}

}  // namespace pt
