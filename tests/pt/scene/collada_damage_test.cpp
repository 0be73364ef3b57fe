#include "collada_text.h"
#include "pt/error.h"
#include "pt/sampling/sampler.h"

namespace pt {
namespace {

// A scene with one element of every kind, to be damaged.
std::string rich_scene() {
  SceneText text;
  text.up_axis = "Z_UP";
  text.geometries = quad_mesh() + sphere("ball", ".5") +
                    mesh("tri", "0 0 0 1 0 0 0 1 0", 9, "triangles", "count=\"1\"",
                         "<input semantic=\"NORMAL\" source=\"#n\" offset=\"1\"/>"
                         "<p>0 1 1 0 2 1</p>",
                         float_source("n", "0 0 2 0 3 4", 6));
  text.lights =
      "<light id=\"l\"><technique_common><point><color>1 2 3</color></point>"
      "</technique_common>" +
      course("<area><color>4 5 6</color></area>") + "</light>";
  text.cameras =
      "<camera id=\"cam\"><optics><technique_common><perspective><xfov>60</xfov>"
      "<aspect_ratio>2</aspect_ratio></perspective></technique_common></optics></camera>";
  text.library_nodes = "<node id=\"part\"><scale>2 2 2</scale>" + instance("tri") + "</node>";
  text.nodes =
      node("<rotate>1 0 0 30</rotate>" + instance("quad", "lamp") +
           "<instance_light url=\"#l\"/>") +
      node("<matrix>1 0 0 1 0 1 0 2 0 0 1 3 0 0 0 1</matrix>" + instance("ball", "matte")) +
      node(
          "<translate>0 0 1</translate><instance_node url=\"#part\"/>"
          "<instance_camera url=\"#cam\"/>");
  text = with_material(text, "lamp", course("<emission><radiance>1 1 1</radiance></emission>"));
  return with_material(text, "matte", common_diffuse(".5 .5 .5 1")).str();
}

std::size_t any(std::size_t n, Sampler& sampler) {
  return static_cast<std::size_t>(sampler.next_1d() * static_cast<double>(n));
}

// Replaces a digit, or inserts a point, sign or space, so that the markup stays valid.
void damage_number(std::string& text, Sampler& sampler) {
  std::size_t at = any(text.size(), sampler);
  at = text.find_first_of("0123456789", at);
  if (at != std::string::npos) text[at] = "0123456789.-e "[any(14, sampler)];
}

void damage_text(std::string& text, Sampler& sampler) {
  const std::size_t at = any(text.size(), sampler);
  const std::size_t from = any(text.size(), sampler);
  const std::size_t span = 1 + any(30, sampler);
  switch (any(5, sampler)) {
    case 0:
      text.resize(at);
      break;
    case 1:
      text[at] = static_cast<char>(any(256, sampler));
      break;
    case 2:
      text.erase(at, span);
      break;
    case 3:
      text.insert(at, text.substr(from, span));
      break;
    default:
      text.insert(at, std::string(span, "9-.e#<"[any(6, sampler)]));
      break;
  }
}

std::string damaged(const std::string& good, Sampler& sampler) {
  std::string text = good;
  const bool numbers = any(2, sampler) == 0;
  for (std::size_t changes = 1 + any(3, sampler); changes > 0 && !text.empty(); --changes) {
    numbers ? damage_number(text, sampler) : damage_text(text, sampler);
  }
  return text;
}

// Each damaged file loads as a sound scene or is refused with one sentence.
TEST(Damage, of_any_kind_ends_in_a_scene_or_an_error) {
  const std::string good = rich_scene();
  ASSERT_EQ(load_text(good).scene.primitives.size(), 4);
  Sampler sampler(20'240'917);
  int loaded = 0, refused = 0;
  for (int i = 0; i < 6000; ++i) {
    const std::string text = damaged(good, sampler);
    try {
      const LoadedScene scene = load_text(text);
      ++loaded;
      ASSERT_EQ(static_cast<int>(scene.scene.material_of.size()), scene.scene.primitives.size());
      for (const Triangle& t : scene.scene.primitives.triangles) {
        for (const Vec3 n : {t.n0, t.n1, t.n2}) ASSERT_NEAR(length(n), 1, 1e-14) << text;
        for (const Vec3 p : {t.p0, t.p1, t.p2}) ASSERT_TRUE(is_finite(p)) << text;
      }
      for (const Sphere& s : scene.scene.primitives.spheres) ASSERT_GT(s.radius, 0);
    } catch (const Error& error) {
      ++refused;
      ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
  // The damage neither leaves every file intact nor makes every file unreadable.
  EXPECT_GT(loaded, 600);
  EXPECT_GT(refused, 600);
}

}  // namespace
}  // namespace pt
