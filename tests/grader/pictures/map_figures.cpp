#include "tests/grader/pictures/map_figures.h"

#include "grader/pictures/recipes/render.h"
#include "grader/pictures/statistics/sample_map_verdict.h"

namespace grader::tests {

namespace {

MapFigures figures(const pictures::SampleMapReference& reference, const pt::SampleMap& map) {
  const pictures::SampleMapVerdict v = pictures::judge_sample_map(reference, map);
  return {v.pass, v.ratio, v.a, v.b, v.correlation};
}

pictures::Rendered run_of(pictures::Recipe recipe, const pictures::RecipeScene& scene,
                          double survival, int number) {
  recipe.settings.survival = survival;
  return pictures::render(recipe, pictures::view(recipe, scene), pt::render_rows, 1,
                          pictures::batch_seed({"survival", 1}, recipe, 0, number));
}

}  // namespace

MapFigures figures_of(const std::string& counts, const std::string& rates) {
  return figures(pictures::read_reference(rates), pt::read_counts(counts));
}

std::vector<MapFigures> figures_of_survivals(pictures::Recipe recipe,
                                             const std::vector<double>& survivals) {
  recipe.settings.to = kSurvivalBounces;
  const pictures::RecipeScene scene = pictures::load_scene(recipe, pt::Engine::wide);
  std::vector<pt::SampleMap> maps;
  std::vector<pt::RunningMoments> pixels(static_cast<std::size_t>(recipe.width) * recipe.height);
  for (int i = 0; i < kSurvivalRuns; ++i) {
    const pictures::Rendered run = run_of(recipe, scene, 0.7, i);
    maps.push_back(run.counts);
    for (std::size_t k = 0; k < pixels.size(); ++k) pixels[k].add(run.mean.pixels[k]);
  }
  pt::Film picture(recipe.width, recipe.height);
  for (std::size_t k = 0; k < pixels.size(); ++k) picture.pixels[k] = pixels[k].pixel();
  const pictures::SampleMapReference reference =
      pictures::reference_of(maps, picture, *recipe.adaptive);
  std::vector<MapFigures> all;
  for (std::size_t i = 0; i < survivals.size(); ++i) {
    const int fresh = kSurvivalRuns + static_cast<int>(i);
    all.push_back(figures(reference, run_of(recipe, scene, survivals[i], fresh).counts));
  }
  return all;
}

}  // namespace grader::tests
