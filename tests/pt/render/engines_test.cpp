// A picture does not depend on its engine: pictures of the wide engine are judged like a
// submission's, against a golden by the tasks of part 2 with other samples.
#include "grader/pictures/statistics/image_verdict.h"
#include "pt/render/render_film.h"
#include "pt/scene/frame_camera.h"
#include "pt/scene/load_collada.h"

#include <filesystem>

#include <gtest/gtest.h>

namespace pt {
namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 30;

// 32, 64 and 128 samples per pixel; the golden has 16 times the last.
constexpr std::array<grader::pictures::Round, 3> kRounds{{{16, 2}, {16, 4}, {16, 8}}};
constexpr int kGoldenSamples = 16 * 16 * 8;

Film render(const LoadedScene& loaded, int samples, std::uint64_t seed) {
  PathSettings settings;
  settings.light_samples = 1;
  settings.to = 3;
  const View view{loaded.scene, frame_camera(loaded, Framing::course, kWidth, kHeight), settings,
                  kWidth, kHeight};
  return render_film(view, {samples, {}, seed, 2}).film;
}

grader::pictures::ImageVerdict judge_wide_by_task(const char* file, bool broken) {
  LoadedScene loaded = load_collada(std::filesystem::path(FIRSTLIGHT_ROOT) / "scenes" / file);
  loaded.scene.tracer = Tracer(Engine::task, loaded.scene.primitives);
  const Film golden = render(loaded, kGoldenSamples, 1);
  if (broken) {
    // One triangle in fifty is in a wrong place.
    for (std::size_t i = 0; i < loaded.scene.primitives.triangles.size(); i += 50) {
      Triangle& t = loaded.scene.primitives.triangles[i];
      t.p0 = t.p1 = t.p2;
    }
  }
  loaded.scene.tracer = Tracer(Engine::wide, loaded.scene.primitives);
  const auto round = [&](int number, int batches, int samples) {
    grader::pictures::Batches result{samples, {}};
    for (int i = 0; i < batches; ++i) {
      const std::uint64_t seed = 1000u * static_cast<unsigned>(number) + static_cast<unsigned>(i);
      result.images.push_back(mean(render(loaded, samples, seed)));
    }
    return result;
  };
  return judge_image(golden, grader::pictures::NoiseClass::ordinary, round, 3, kRounds);
}

class PictureOf : public ::testing::TestWithParam<const char*> {};

TEST_P(PictureOf, the_wide_engine_is_that_of_the_task) {
  const grader::pictures::ImageVerdict verdict = judge_wide_by_task(GetParam(), false);
  EXPECT_EQ(verdict.outcome, grader::pictures::ImageVerdict::Outcome::pass) << verdict.sentence;
}

INSTANTIATE_TEST_SUITE_P(EveryScene, PictureOf,
                         ::testing::Values("box_blob.dae", "box_spheres.dae"));

TEST(Picture, with_holes_is_found_out) {
  EXPECT_EQ(judge_wide_by_task("box_blob.dae", true).outcome,
            grader::pictures::ImageVerdict::Outcome::wrong);
}

}  // namespace
}  // namespace pt
