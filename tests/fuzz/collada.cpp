// Scene files: each loads as a sound scene or is refused with one sentence.
#include "pt/error.h"
#include "pt/scene/load_collada.h"
#include "tests/fuzz/input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  try {
    const pt::LoadedScene loaded = pt::load_collada(fuzz::as_file(fuzz::as_text(bytes, size)));
    const pt::Scene& scene = loaded.scene;
    fuzz::expect(scene.primitives.size() > 0);
    fuzz::expect(static_cast<int>(scene.material_of.size()) == scene.primitives.size());
    for (const int material : scene.material_of) {
      fuzz::expect(material >= 0 && material < static_cast<int>(scene.materials.size()));
    }
    for (const pt::Triangle& t : scene.primitives.triangles) {
      for (const pt::Vec3 p : {t.p0, t.p1, t.p2, t.n0, t.n1, t.n2}) fuzz::expect(is_finite(p));
    }
    for (const pt::Sphere& s : scene.primitives.spheres) {
      fuzz::expect(is_finite(s.center) && s.radius > 0);
    }
    for (const std::string& note : loaded.notes) fuzz::expect_sentence(note);
    require_supported(loaded, "scene.dae");
  } catch (const pt::Error& error) {
    fuzz::expect_reason(error);
  }
  return 0;
}
