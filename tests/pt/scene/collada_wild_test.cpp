// Oddities of files in the course's public repositories, each in a small file of our own: mistakes
// in a file that can still be shown, and parts that are read once or never.
#include "collada_text.h"
#include "pt/error.h"
#include "pt/scene/frame_camera.h"

#include <string>
#include <variant>

#include <fmt/format.h>

namespace pt {
namespace {

SceneText with_last_row(const std::string& row) {
  SceneText text = one_triangle();
  text.nodes = node("<matrix>1 0 0 4 0 1 0 5 0 0 1 6 " + row + "</matrix>" + instance("tri"));
  return text;
}

std::string error_of(const SceneText& text) {
  try {
    load(text);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(LastRows, that_an_exporter_rounded_are_read_with_a_note) {
  for (const char* row : {"0 0 0 1.0000002", "0 0 0 0.9999998", "1e-7 0 0 1", "0 -1e-6 2e-7 1"}) {
    const LoadedScene loaded = load(with_last_row(row));
    expect_near(loaded.scene.primitives.triangles.at(0).p0, {4, 5, 6});
    EXPECT_TRUE(has_note(loaded, "but for rounding")) << row;
  }
  EXPECT_FALSE(has_note(load(with_last_row("0 0 0 1")), "but for rounding"));
}

TEST(LastRows, of_a_projection_are_refused) {
  for (const char* row : {"0 0 0 1.01", "0 0 .001 1", "0 0 0 0", "0 0 -1 1", "0 0 0 -1"}) {
    EXPECT_TRUE(contains(error_of(with_last_row(row)), "last row")) << row;
  }
}

TEST(SmallFaces, have_no_surface_and_are_noted) {
  SceneText text;
  text.nodes = node(instance("g"));
  text.geometries = mesh("g", "0 0 0 1 0 0 0 1 0 0 0 1", 12, "polylist", "",
                         "<vcount>3 2 0 1 3</vcount><p>0 1 2 0 1 2 1 2 3</p>");
  const LoadedScene loaded = load(text);
  ASSERT_EQ(loaded.scene.primitives.triangles.size(), 2u);
  expect_near(loaded.scene.primitives.triangles[0].p2, {0, 1, 0});
  expect_near(loaded.scene.primitives.triangles[1].p2, {0, 0, 1});
  EXPECT_TRUE(has_note(loaded, "3 faces of fewer than three corners"));
}

// References as in a URL: exporters encode blanks and letters outside ASCII like this.
TEST(References, may_be_written_with_codes) {
  SceneText text;
  text.geometries = triangle_mesh("W\xc3\xbcrfel 1%") + triangle_mesh("plain%20");
  for (const char* url : {"W%C3%BCrfel%201%", "W\xc3\xbcrfel 1%25", "plain%20"}) {
    text.nodes = node(instance(url));
    EXPECT_EQ(load(text).scene.primitives.triangles.size(), 1u) << url;
  }
  text.nodes = node(instance("W%C3%B%"));
  EXPECT_TRUE(contains(error_of(text), "'#W%C3%B%'"));
}

TEST(SharedIds, that_nothing_refers_to_are_noted) {
  SceneText text = one_triangle();
  text.lights = "<light id=\"sun\"/><light id=\"sun\"/><light id=\"sun\"/>";
  text.geometries += triangle_mesh("spare") + triangle_mesh("spare");
  const LoadedScene loaded = load(text);
  EXPECT_EQ(loaded.scene.primitives.triangles.size(), 1u);
  // The geometry, the source and the vertices of each unused mesh have these ids.
  EXPECT_TRUE(has_note(loaded, "5 elements have the id of another (the first: <light> 'sun'"));
}

TEST(SharedIds, that_are_referred_to_are_refused_with_both_lines) {
  SceneText text = one_triangle();
  text.geometries += "\n" + triangle_mesh();
  EXPECT_TRUE(contains(error_of(text), "'#tri' may be the <geometry> of line 8 or that of line 9"))
      << error_of(text);
}

// The scene can be shown with one of the two elements.
TEST(SharedIds, of_lights_and_cameras_that_are_shown_are_noted) {
  const auto light = [](const char* color) {
    return std::string("<light id=\"sun\"><technique_common><point><color>") + color +
           "</color><constant_attenuation>0</constant_attenuation><quadratic_attenuation>1"
           "</quadratic_attenuation></point></technique_common></light>\n";
  };
  const auto camera = [](const char* angle) {
    return std::string("<camera id=\"eye\"><optics><technique_common><perspective><xfov>") + angle +
           "</xfov></perspective></technique_common></optics></camera>\n";
  };
  SceneText text = one_triangle();
  text.nodes += node("<instance_light url=\"#sun\"/>") + node("<instance_camera url=\"#eye\"/>");
  text.lights = light("1 0 0") + light("0 1 0");
  text.cameras = camera("30") + camera("60");
  const LoadedScene loaded = load(text);
  ASSERT_EQ(loaded.scene.lights.size(), 1u);
  EXPECT_EQ(std::get<PointLight>(loaded.scene.lights[0]).intensity, (Rgb{1, 0, 0}));
  EXPECT_EQ(loaded.camera.value().hfov_deg, 30);
  EXPECT_TRUE(has_note(loaded, "'#sun' may be the <light> of line"));
  EXPECT_TRUE(has_note(loaded, "'#eye' may be the <camera> of line"));
}

// Some exporters give the same ids to the sources of every mesh.
TEST(SharedIds, mean_those_of_the_own_mesh) {
  const auto mesh_with_common_ids = [](const std::string& id, const std::string& positions) {
    return "<geometry id=\"" + id + "\"><mesh>" + float_source("p", positions, 9) +
           "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
           "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
           "<p>0 1 2</p></triangles></mesh></geometry>";
  };
  SceneText text;
  text.geometries = mesh_with_common_ids("a", "0 0 0 1 0 0 0 1 0") +
                    mesh_with_common_ids("b", "7 0 0 8 0 0 7 1 0");
  text.nodes = node(instance("a")) + node(instance("b"));
  const LoadedScene loaded = load(text);
  ASSERT_EQ(loaded.scene.primitives.triangles.size(), 2u);
  expect_near(loaded.scene.primitives.triangles[0].p0, {0, 0, 0});
  expect_near(loaded.scene.primitives.triangles[1].p0, {7, 0, 0});
  EXPECT_TRUE(has_note(loaded, "2 elements have the id of another"));
  // Two equal ids in one mesh are ambiguous.
  text.geometries = mesh_with_common_ids("a",
                                         "0 0 0 1 0 0 0 1 0</float_array></source><source id=\"p\">"
                                         "<float_array count=\"9\">0 0 0 1 0 0 0 1 0") +
                    mesh_with_common_ids("b", "7 0 0 8 0 0 7 1 0");
  EXPECT_TRUE(contains(error_of(text), "'#p' may be the <source> of line")) << error_of(text);
}

// The same id for elements of two kinds is not ambiguous, because a reference has a kind.
TEST(SharedIds, of_two_kinds_are_right) {
  SceneText text = one_triangle();
  text.lights = "<light id=\"tri\"/>";
  EXPECT_FALSE(has_note(load(text), "have the id"));
}

TEST(MissingParts, that_the_picture_does_not_need_are_noted) {
  SceneText text = one_triangle();
  text.nodes += node("<instance_light url=\"#sun\"/>") + node("<instance_camera url=\"#cam\"/>");
  const LoadedScene loaded = load(text);
  EXPECT_FALSE(loaded.has_own_light);
  EXPECT_FALSE(loaded.camera.has_value());
  EXPECT_TRUE(has_note(loaded, "no <light> with the id that '#sun' names"));
  EXPECT_TRUE(has_note(loaded, "no <camera> with the id that '#cam' names"));
}

// Sixteen nodes that each contain the next twice: 2^15 copies of the last node's content, each in another place.
SceneText doubled(const std::string& content, int steps = 15) {
  SceneText text = one_triangle();
  for (int i = 0; i < steps; ++i) {
    const std::string next = fmt::format("<instance_node url=\"#n{}\"/>", i + 1);
    const std::string moved = node(fmt::format("<translate>{} 0 0</translate>", 1 << i) + next);
    text.library_nodes += fmt::format("<node id=\"n{}\">{}{}</node>", i, next, moved);
  }
  text.library_nodes += "<node id=\"n" + std::to_string(steps) + "\">" + content + "</node>";
  text.nodes = node("<instance_node url=\"#n0\"/>");
  return text;
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(ShortFiles, that_ask_for_too_many_lights_are_refused) {
  SceneText spheres = doubled(instance("ball", "lamp"));
  spheres.geometries += sphere("ball", ".5");
  spheres =
      with_material(spheres, "lamp", course("<emission><radiance>1 1 1</radiance></emission>"));
  EXPECT_TRUE(contains(error_of(spheres), "more than 10,000 emitting surfaces; use fewer"));
  SceneText quads = with_material(doubled(instance("quad", "lamp")), "lamp",
                                  course("<emission><radiance>1 1 1</radiance></emission>"));
  quads.geometries += quad_mesh();
  EXPECT_TRUE(contains(error_of(quads), "more than 10,000 emitting surfaces; use fewer"));
  SceneText lights = doubled(instance("tri") + "<instance_light url=\"#l\"/>");
  lights.lights =
      "<light id=\"l\"><technique_common><point><color>1 1 1</color></point></technique_common>"
      "</light>";
  EXPECT_TRUE(contains(error_of(lights), "more than 10,000 lights; use fewer"));
}

TEST(ShortFiles, that_ask_for_too_many_instances_are_refused) {
  EXPECT_TRUE(
      contains(error_of(doubled(repeated(instance("tri"), 2000))),
               "more than 100,000 instances when each <instance_node> is a copy; use fewer"));
}

// 64 triangles, written once and shown in 2^15 places. As many separate triangles are not too many.
TEST(ShortFiles, that_show_a_geometry_too_often_are_refused) {
  SceneText text = doubled(instance("many"));
  const auto strip = [](const std::string& id, int triangles) {
    return mesh(id, "0 0 0 1 0 0 0 1 0", 9, "triangles",
                "count=\"" + std::to_string(triangles) + "\" material=\"m\"",
                "<p>" + repeated("0 1 2 ", triangles) + "</p>");
  };
  text.geometries += strip("many", 64);
  EXPECT_TRUE(contains(error_of(text), "more than 2 million surfaces of the scene are shown again"))
      << error_of(text);
  text.geometries = triangle_mesh() + strip("many", 60);
  const LoadedScene loaded = load(text);
  EXPECT_EQ(loaded.scene.primitives.triangles.size(), std::size_t{1} << 15);
  EXPECT_TRUE(has_note(loaded, std::to_string(59 << 15) + " surfaces lie exactly on another one"));
}

// Each file takes minutes if the content of a node or an instance is read again for every place
// that shows it.
TEST(ShortFiles, say_much_in_one_place_and_are_read_once) {
  const LoadedScene moved =
      load(doubled(repeated("<translate>0 0 .5</translate>", 2000) + instance("tri")));
  EXPECT_EQ(moved.scene.primitives.triangles.size(), std::size_t{1} << 15);
  expect_near(moved.scene.primitives.triangles.back().p0, {32767, 0, 1000});

  std::string bindings;
  for (int i = 0; i < 20'000; ++i) {
    bindings += "<instance_material symbol=\"s" + std::to_string(i) + "\" target=\"#none\"/>";
  }
  bindings += "<instance_material symbol=\"m\" target=\"#red\"/>";
  const SceneText painted =
      with_material(doubled("<instance_geometry url=\"#tri\"><bind_material><technique_common>" +
                            bindings + "</technique_common></bind_material></instance_geometry>"),
                    "red", common_diffuse("1 0 0"));
  const LoadedScene red = load(painted);
  EXPECT_EQ(red.scene.primitives.triangles.size(), std::size_t{1} << 15);
  ASSERT_EQ(red.scene.materials.size(), 1u);
  EXPECT_EQ(red.scene.materials[0].albedo, (Rgb{1, 0, 0}));
}

// The same for the text of the light and the camera, after 20,000 techniques of other programs.
TEST(ShortFiles, say_much_in_a_light_or_a_camera) {
  const std::string others = repeated("<extra><technique profile=\"X\"/></extra>", 20'000);
  SceneText text = doubled(instance("tri") + "<instance_light url=\"#l\"/>", 13);
  text.lights =
      "<light id=\"l\">" + others + course("<point><color>1 1 1</color></point>") + "</light>";
  EXPECT_EQ(load(text).scene.lights.size(), std::size_t{1} << 13);

  text = doubled(instance("tri") + "<instance_camera url=\"#c\"/>");
  text.cameras = "<camera id=\"c\">" + others +
                 "<optics><technique_common><perspective><xfov>60</xfov></perspective>"
                 "</technique_common></optics></camera>";
  EXPECT_EQ(load(text).camera.value().hfov_deg, 60);
}

// The offset of rays is 2^-33 of the distance from the origin, and a thousandth of the size from a ratio of 8.6e6 on.
TEST(FarAway, is_said_where_rays_start_visibly_off_their_surfaces) {
  const auto is_said = [](const std::string& x, const std::string& scale) {
    SceneText text = one_triangle();
    text.nodes = node("<translate>" + x + " 0 0</translate><scale>" + scale + " 1 1</scale>" +
                      instance("tri"));
    return has_note(load(text), "times the scene's size from the world's origin");
  };
  EXPECT_FALSE(is_said("0", "1"));
  EXPECT_FALSE(is_said("8e6", "1"));
  EXPECT_TRUE(is_said("9e6", "1"));
  EXPECT_TRUE(is_said("-1e10", "1"));
  EXPECT_FALSE(is_said("1e9", "1e9"));
}

// The rule of --camera course depends on who wrote the file.
TEST(MissingParts, that_choose_the_rule_of_the_course_are_noted) {
  SceneText text = one_triangle();
  text.nodes += node("<instance_camera url=\"#c\"/>");
  text.cameras =
      "<camera id=\"c\"><optics><technique_common><perspective><xfov>60</xfov></perspective>"
      "</technique_common></optics></camera>";
  EXPECT_TRUE(
      contains(note_on_framing(load(text), Framing::course), "not in the course's dialect"));
  text = with_material(text, "unused", course("<mirror/>"));
  EXPECT_EQ(note_on_framing(load(text), Framing::course), "");
  text.has_asset = false;
  EXPECT_TRUE(contains(note_on_framing(load(text), Framing::course), "the file has no <asset>"));
  EXPECT_EQ(note_on_framing(load(text), Framing::fit), "");
}

// A program writes its name into the file. A person may add a name and keep the rest of a template.
TEST(Authors, are_programs_where_one_is_named) {
  const auto exported = [](const std::string& contributor) {
    std::string text = one_triangle().str();
    text.insert(text.find("<asset>") + 7, contributor);
    return load_text(text).exported;
  };
  EXPECT_TRUE(exported("<contributor><authoring_tool>Blender 2.7</authoring_tool></contributor>"));
  EXPECT_FALSE(exported("<contributor><author>Ada</author></contributor>"));
  EXPECT_FALSE(exported("<contributor><authoring_tool/></contributor>"));
  EXPECT_FALSE(exported("<contributor/>"));
  EXPECT_FALSE(exported(""));
}

TEST(Bindings, fall_back_on_the_only_one_there_is) {
  SceneText text = with_material(one_triangle(), "red", common_diffuse("1 0 0"));
  text = with_material(text, "blue", common_diffuse("0 0 1"));
  const auto bound = [&](const std::string& bindings) {
    text.nodes = node("<instance_geometry url=\"#tri\"><bind_material><technique_common>" +
                      bindings + "</technique_common></bind_material></instance_geometry>");
    const LoadedScene loaded = load(text);
    return loaded.scene.materials.at(loaded.scene.material_of.at(0)).name;
  };
  const auto binding = [](const std::string& symbol, const std::string& target) {
    return "<instance_material symbol=\"" + symbol + "\" target=\"#" + target + "\"/>";
  };
  EXPECT_EQ(bound(binding("other", "blue")), "blue");
  EXPECT_EQ(bound(binding("other", "blue") + binding("m", "red")), "red");
  EXPECT_EQ(bound(binding("other", "blue") + binding("another", "red")), "default");
  EXPECT_EQ(bound(binding("m", "blue") + binding("m", "red")), "blue");
}

}  // namespace
}  // namespace pt
