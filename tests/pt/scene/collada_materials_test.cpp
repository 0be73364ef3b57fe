#include "collada_text.h"
#include "pt/error.h"

namespace pt {
namespace {

TEST(Materials, are_bound_a_set_of_faces) {
  SceneText text;
  text.geometries =
      "<geometry id=\"g\"><mesh>" + float_source("p", "0 0 0 1 0 0 0 1 0 0 0 1", 12) +
      position_inputs("g").replace(position_inputs("g").find("#g-p"), 4, "#p") +
      "<triangles count=\"1\" material=\"a\"><input semantic=\"VERTEX\" source=\"#g-v\" "
      "offset=\"0\"/><p>0 1 2</p></triangles>"
      "<polylist count=\"1\" material=\"b\"><input semantic=\"VERTEX\" source=\"#g-v\" "
      "offset=\"0\"/><vcount>3</vcount><p>0 2 3</p></polylist></mesh></geometry>";
  text.nodes = node(
      "<instance_geometry url=\"#g\"><bind_material><technique_common>"
      "<instance_material symbol=\"b\" target=\"#red\"/>"
      "<instance_material symbol=\"a\" target=\"#green\"/></technique_common></bind_material>"
      "</instance_geometry>");
  text = with_material(text, "red", common_diffuse(".75 .125 .25 1"));
  text = with_material(text, "green", common_diffuse(".125 .75 .25"));
  const Scene scene = load(text).scene;
  ASSERT_EQ(scene.material_of.size(), 2u);
  EXPECT_EQ(scene.materials[scene.material_of[0]].albedo, (Rgb{.125, .75, .25}));
  EXPECT_EQ(scene.materials[scene.material_of[1]].albedo, (Rgb{.75, .125, .25}));
  EXPECT_EQ(scene.materials[scene.material_of[1]].name, "red");
}

Material load_material(const std::string& effect_content, const LoadOptions& options = {}) {
  SceneText text;
  text.geometries = triangle_mesh();
  text.nodes = node(instance("tri", "mat"));
  const LoadedScene loaded = load(with_material(text, "mat", effect_content), options);
  EXPECT_EQ(loaded.scene.materials.size(), 1u);
  return loaded.scene.materials.at(0);
}

TEST(Materials, take_the_courses_technique_first) {
  const std::string diffuse = course("<diffuse><reflectance>.25 .5 .75</reflectance></diffuse>");
  EXPECT_EQ(load_material(common_diffuse("1 1 1") + diffuse).albedo, (Rgb{.25, .5, .75}));
  const Material lamp = load_material(common_diffuse(".5 .5 .25") +
                                      course("<emission><radiance>1 2 3</radiance></emission>"));
  EXPECT_EQ(lamp.emission, (Rgb{1, 2, 3}));
  EXPECT_EQ(lamp.albedo, (Rgb{.5, .5, .25}));
}

TEST(Materials, may_be_of_every_shader) {
  const auto albedo = [](const std::string& shader) {
    return load_material("<profile_COMMON><technique sid=\"c\"><" + shader +
                         "><diffuse><color>.25 .5 .75 1</color></diffuse></" + shader +
                         "></technique></profile_COMMON>")
        .albedo;
  };
  for (const char* shader : {"phong", "lambert", "blinn"}) {
    EXPECT_EQ(albedo(shader), (Rgb{.25, .5, .75})) << shader;
  }
}

// An exporter's emission is not the course's, so somebody will look for this light.
TEST(Materials, whose_emission_is_ignored_are_noted) {
  const auto loaded = [](const std::string& emission) {
    SceneText text;
    text.geometries = triangle_mesh();
    text.nodes = node(instance("tri", "mat"));
    return load(with_material(
        text, "mat",
        "<profile_COMMON><technique sid=\"c\"><phong>" + emission +
            "<diffuse><color>1 1 1</color></diffuse></phong></technique></profile_COMMON>"));
  };
  const std::string note = "material 'mat' has an emission colour in profile_COMMON";
  EXPECT_TRUE(has_note(loaded("<emission><color>0 0 1 1</color></emission>"), note));
  EXPECT_FALSE(has_note(loaded("<emission><color>0 0 0 1</color></emission>"), note));
  EXPECT_FALSE(has_note(loaded(""), note));
}

TEST(Materials, know_the_old_profile_and_no_other) {
  const std::string emission = "<emission><radiance>2 2 2</radiance></emission>";
  const auto extra = [&](const std::string& profile) {
    return "<extra><technique profile=\"" + profile + "\">" + emission + "</technique></extra>";
  };
  EXPECT_EQ(load_material(extra("CMU462")).emission, gray(2));
  EXPECT_EQ(load_material(extra("blender")).emission, gray(0));
}

TEST(Materials, default_to_one_half) {
  EXPECT_EQ(load_material("").albedo, gray(0.5));
  SceneText text;
  text.geometries = triangle_mesh();
  text.nodes = node(instance("tri"));
  const LoadedScene bare = load(text);
  EXPECT_EQ(bare.scene.materials.at(0).albedo, gray(0.5));
  EXPECT_TRUE(has_note(bare, "without a material (1, the first"));
}

TEST(Materials, reflect_at_most_all) {
  EXPECT_EQ(load_material(common_diffuse("2 .5 1")).albedo, (Rgb{1, .5, 1}));
  EXPECT_EQ(load_material(common_diffuse("1 2 .5")).albedo, (Rgb{1, 1, .5}));
  EXPECT_EQ(load_material(common_diffuse(".5 1 2")).albedo, (Rgb{.5, 1, 1}));
}

TEST(Materials, outside_the_model_load_and_are_refused_for_light_transport) {
  for (const std::string kind : {"mirror", "glass", "refraction", "microfacet"}) {
    SceneText text;
    text.geometries = triangle_mesh();
    text.nodes = node(instance("tri", "shiny"));
    text = with_material(text, "shiny", common_diffuse("1 1 1") + course("<" + kind + "/>"));
    const LoadedScene loaded = load(text);
    EXPECT_EQ(loaded.scene.materials.at(0).unsupported, kind);
    try {
      require_supported(loaded, "box.dae");
      ADD_FAILURE() << kind << " was accepted";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("box.dae: material 'shiny'"), std::string::npos);
    }
    const LoadedScene lambertian = load(text, {.lambertian = true});
    EXPECT_NO_THROW(require_supported(lambertian, "box.dae"));
    EXPECT_EQ(lambertian.scene.materials.at(0).albedo, gray(0.5));
    EXPECT_TRUE(has_note(lambertian, "'shiny' (" + kind + ") is treated as"));
  }
}

}  // namespace
}  // namespace pt
