#include "grader/check/mocks/scripted_radiance.h"

#include "pt/render/radiance.h"

#include <iterator>
#include <utility>

namespace grader::check {

namespace {

std::vector<RadianceCall> calls;

}  // namespace

void script_radiance(RadianceScript script) {
  radiance_script() = std::move(script);
  calls.clear();
}

const std::vector<RadianceCall>& radiance_calls() { return calls; }

}  // namespace grader::check

namespace pt {

Rgb radiance(const Scene& scene, const Ray& ray, const PathSettings& settings, Sampler& sampler) {
  using namespace grader::check;
  calls.push_back({ray, settings, sampler.state(), std::ssize(scene.lights)});
  const auto& script = radiance_script();
  if (!script) return {};
  for (int i = 0; i < script->numbers; ++i) sampler.next_1d();
  const std::size_t call = calls.size() - 1;
  return script->of_call ? script->of_call(static_cast<int>(call), ray) : script->at(call);
}

}  // namespace pt
