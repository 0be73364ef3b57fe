// Files of other programs: what they write within the specification, and mistakes that leave a
// scene that can still be shown.
#include "collada_text.h"
#include "pt/error.h"

#include <string>
#include <string_view>

namespace pt {
namespace {

std::string error_of(const std::string& text) {
  try {
    load_text(text);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  EXPECT_TRUE(contains(text, old)) << old;
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size()) {
    text.replace(at, old.size(), by);
  }
  return text;
}

// The scene is that of one_triangle(), bit for bit.
void expect_one_triangle(const LoadedScene& loaded) {
  ASSERT_EQ(loaded.scene.primitives.triangles.size(), 1u);
  const Triangle& t = loaded.scene.primitives.triangles[0];
  EXPECT_EQ(t.p0, (Vec3{0, 0, 0}));
  EXPECT_EQ(t.p1, (Vec3{1, 0, 0}));
  EXPECT_EQ(t.p2, (Vec3{0, 1, 0}));
  EXPECT_EQ(t.n0, (Vec3{0, 0, 1}));
}

Rgb albedo_of(const LoadedScene& loaded) {
  return loaded.scene.materials.at(loaded.scene.material_of.at(0)).albedo;
}

LoadedScene load_effect(const std::string& effect_content, const std::string& set = "",
                        const LoadOptions& options = {}) {
  SceneText text = one_triangle();
  text.nodes = node(instance("tri", "mat"));
  text = with_material(text, "mat", effect_content);
  text.materials =
      replaced(text.materials, "\"/></material>", "\">" + set + "</instance_effect></material>");
  return load(text, options);
}

std::string shader(const std::string& channels, const std::string& params = "",
                   const std::string& kind = "phong") {
  return "<profile_COMMON>" + params + "<technique sid=\"c\"><" + kind + ">" + channels + "</" +
         kind + "></technique></profile_COMMON>";
}

const std::string kTint = "<diffuse><param ref=\"tint\"/></diffuse>";

TEST(Parameters, are_found_in_the_material_and_around_the_shader) {
  const auto declared = [](const std::string& color) {
    return "<newparam sid=\"other\"><float>1</float></newparam><newparam sid=\"tint\"><semantic>X"
           "</semantic><float4>" +
           color + "</float4></newparam>";
  };
  const std::string set = "<setparam ref=\"tint\"><float3>.75 0 0</float3></setparam>";
  const std::string in_profile = shader(kTint, declared(".25 .5 .75 1"));
  EXPECT_EQ(albedo_of(load_effect(in_profile)), (Rgb{.25, .5, .75}));
  EXPECT_EQ(albedo_of(load_effect(declared(".5 .5 .75 1") + shader(kTint))), (Rgb{.5, .5, .75}));
  EXPECT_EQ(albedo_of(load_effect(declared("1 1 1 1") + in_profile)), (Rgb{.25, .5, .75}));
  EXPECT_EQ(albedo_of(load_effect(in_profile, set)), (Rgb{.75, 0, 0}));
  EXPECT_FALSE(has_note(load_effect(in_profile), "tint"));
  const LoadedScene lost = load_effect(shader(kTint));
  EXPECT_EQ(albedo_of(lost), gray(.5));
  EXPECT_TRUE(has_note(lost, "that is the parameter 'tint', which the file does not define"));
  const LoadedScene wrong =
      load_effect(shader(kTint, "<newparam sid=\"tint\"><sampler2D/></newparam>"));
  EXPECT_TRUE(has_note(wrong, "is the parameter 'tint', which is no colour"));
}

TEST(Materials, say_what_they_have_in_place_of_a_colour) {
  const LoadedScene image = load_effect(shader("<diffuse><texture texture=\"i\"/></diffuse>"));
  EXPECT_EQ(albedo_of(image), gray(.5));
  EXPECT_TRUE(has_note(image, "has a diffuse colour that is a texture, which is not read"));
  EXPECT_TRUE(has_note(load_effect(shader("")), "states no diffuse colour"));
  const std::string glow = "<emission><color>2 3 4 1</color></emission>";
  for (const char* kind : {"constant", "lambert"}) {
    const LoadedScene dark = load_effect(shader(glow, "", kind));
    EXPECT_TRUE(has_note(dark, "has an emission colour in profile_COMMON, which is ignored"));
    EXPECT_TRUE(dark.ignores_emission && !dark.has_own_light);
    const LoadedScene lit = load_effect(shader(glow, "", kind), "", {.common_emission = true});
    EXPECT_FALSE(lit.ignores_emission);
    EXPECT_EQ(std::get<MeshLight>(lit.scene.lights.at(0)).radiance, (Rgb{2, 3, 4}));
  }
  EXPECT_TRUE(has_note(load_effect(shader("<emission><texture texture=\"i\"/></emission>")),
                       "has an emission colour that is a texture"));
}

TEST(Materials, say_which_properties_are_ignored) {
  const auto is_transparent = [](const std::string& channels) {
    return has_note(load_effect(shader(channels)), "material 'mat' is transparent");
  };
  const auto color = [](const std::string& mode, const std::string& rgba) {
    return "<transparent" + (mode.empty() ? "" : " opaque=\"" + mode + "\"") + "><color>" + rgba +
           "</color></transparent>";
  };
  const auto factor = [](const std::string& value) {
    return "<transparency><float>" + value + "</float></transparency>";
  };
  EXPECT_FALSE(is_transparent(""));
  EXPECT_FALSE(is_transparent(factor("1")));
  EXPECT_TRUE(is_transparent(factor(".5")));
  EXPECT_FALSE(is_transparent(color("", "0 0 0 1") + factor("1")));
  EXPECT_TRUE(is_transparent(color("A_ONE", "1 1 1 .5")));
  EXPECT_FALSE(is_transparent(color("RGB_ZERO", "0 0 0 1") + factor("1")));
  EXPECT_FALSE(is_transparent(color("RGB_ZERO", "1 1 1 1") + factor("0")));
  EXPECT_TRUE(is_transparent(color("RGB_ZERO", ".5 .5 .5 1")));
  EXPECT_FALSE(is_transparent(color("A_ZERO", "1 1 1 0")));
  // The mode is that of the channel, also if a parameter has the colour.
  const std::string by_param =
      shader("<transparent opaque=\"RGB_ZERO\"><param ref=\"t\"/></transparent>",
             "<newparam sid=\"t\"><float4>0 0 0 0</float4></newparam>");
  EXPECT_FALSE(has_note(load_effect(by_param), "is transparent"));
  EXPECT_TRUE(is_transparent(color("RGB_ONE", "1 1 .5 1")));
  EXPECT_TRUE(is_transparent("<transparent><texture texture=\"i\"/></transparent>"));
  const auto reflects = [](const std::string& value) {
    return has_note(
        load_effect(shader("<reflectivity><float>" + value + "</float></reflectivity>")),
        "has a reflectivity");
  };
  EXPECT_TRUE(reflects(".5"));
  EXPECT_FALSE(reflects("0"));
}

TEST(Materials, that_are_missing_have_albedo_one_half) {
  SceneText text = one_triangle();
  text.nodes = node(instance("tri", "gone"));
  const LoadedScene loaded = load(text);
  EXPECT_EQ(albedo_of(loaded), gray(.5));
  EXPECT_TRUE(has_note(loaded, "no <material> with the id that '#gone' names: the albedo is 0.5."));
  for (const char* content : {"", "<instance_effect/>", "<instance_effect url=\"#gone\"/>"}) {
    text.materials = "<material id=\"gone\">" + std::string(content) + "</material>";
    EXPECT_TRUE(has_note(load(text), "material 'gone' names no effect of the file")) << content;
  }
  const LoadedScene unnamed = load_text(replaced(text.str(), " target=\"#gone\"", ""));
  EXPECT_EQ(albedo_of(unnamed), gray(.5));
  EXPECT_TRUE(has_note(unnamed, "no <material> is named: the albedo is 0.5."));
}

TEST(Vertices, with_colours_say_that_these_are_ignored) {
  const std::string colour = "<input semantic=\"COLOR\" source=\"#none\" offset=\"0\"/>";
  SceneText text = one_triangle();
  text.geometries = replaced(text.geometries, "<p>", colour + "<p>");
  EXPECT_TRUE(has_note(load(text), "has colours at its corners"));
  text.geometries = replaced(triangle_mesh(), "</vertices>", colour + "</vertices>");
  EXPECT_TRUE(has_note(load(text), "has colours at its corners"));
}

std::string error_of_geometry(const std::string& content) {
  SceneText text;
  text.geometries = "<geometry id=\"g\">" + content + "</geometry>";
  text.nodes = node(instance("g"));
  return error_of(text.str());
}

TEST(NoSurface, comes_with_the_notes_that_explain_it) {
  EXPECT_TRUE(contains(error_of_geometry("<mesh><lines/></mesh>"), "geometry 'g' has lines"));
  EXPECT_TRUE(contains(error_of_geometry("<spline/>"), "geometry 'g' is neither a mesh nor"));
  EXPECT_TRUE(contains(error_of_geometry("<mesh><tristrips count=\"0\"/></mesh>"), "no faces"));
  EXPECT_TRUE(contains(error_of_geometry("<mesh><vertices/></mesh>"), "geometry 'g' has no faces"));
  SceneText text = one_triangle();
  text.nodes = node(instance("gone"));
  EXPECT_TRUE(contains(error_of(text.str()), "'#gone' names"));
  text.nodes = node("");
  EXPECT_TRUE(contains(error_of(text.str()), "no surface; put an <instance_geometry> in it"));
}

TEST(MissingParts, of_a_scene_are_left_out_with_a_note) {
  SceneText text = one_triangle();
  text.nodes += node(instance("gone")) + node("<instance_node url=\"#gone\"/>") +
                node("<instance_controller url=\"#gone\"/>") +
                node("<instance_geometry url=\"tri\"/>") +
                node("<instance_geometry url=\"other.dae#tri\"/>") + node("<instance_light/>");
  const LoadedScene loaded = load(text);
  expect_one_triangle(loaded);
  for (const char* kind : {"geometry", "node", "controller"}) {
    EXPECT_TRUE(has_note(loaded, "no <" + std::string(kind) + "> with the id that '#gone' names"));
  }
  EXPECT_TRUE(has_note(loaded, "'other.dae#tri' is in another file, which is not read"));
  EXPECT_TRUE(has_note(loaded, "no <light> is named: the instance is left out."));
}

TEST(References, may_begin_with_the_files_own_name) {
  const std::string own = scratch_file("").filename();
  SceneText text = one_triangle();
  for (const char* folder : {"", "./", "file:///C|/models/", "..\\models\\"}) {
    text.nodes = node("<instance_geometry url=\"" + (folder + own) + "#tri\"/>");
    expect_one_triangle(load(text));
  }
  text.nodes += node("<instance_geometry url=\"x" + own + "#tri\"/>");
  EXPECT_TRUE(has_note(load(text), "is in another file"));
}

const std::string kSkin =
    "<library_controllers><controller id=\"skin\"><skin source=\"#SOURCE\"><bind_shape_matrix>"
    "1 0 0 0 0 1 0 0 0 0 1 7 0 0 0 1</bind_shape_matrix></skin></controller>"
    "<controller id=\"morph\"><morph source=\"#tri\"/></controller></library_controllers>";

std::string with_skin_of(const std::string& source) {
  SceneText text = one_triangle();
  text.nodes =
      node("<scale>2 2 2</scale><instance_controller url=\"#skin\">" +
           instance("tri", "red").substr(std::string("<instance_geometry url=\"#tri\">").size()));
  text.nodes = replaced(text.nodes, "</instance_geometry>", "</instance_controller>");
  text = with_material(text, "red", common_diffuse("1 0 0"));
  return replaced(text.str(), "<library_nodes>",
                  replaced(kSkin, "SOURCE", source) + "<library_nodes>");
}

TEST(Controllers, are_shown_as_they_were_bound) {
  for (const char* source : {"tri", "morph"}) {
    const LoadedScene loaded = load_text(with_skin_of(source));
    ASSERT_EQ(loaded.scene.primitives.triangles.size(), 1u);
    EXPECT_EQ(loaded.scene.primitives.triangles[0].p1, (Vec3{2, 0, 14}));
    EXPECT_EQ(albedo_of(loaded), (Rgb{1, 0, 0}));
    EXPECT_TRUE(has_note(loaded, "animated mesh 'tri' is shown as it was bound"));
  }
  EXPECT_TRUE(contains(error_of(with_skin_of("skin")), "refer to each other"));
  EXPECT_TRUE(contains(error_of(with_skin_of("gone")), "no <geometry> with the id that '#gone'"));
}

TEST(Transforms, that_look_at_a_point_have_z_away_from_it) {
  SceneText text = one_triangle();
  text.nodes = node("<lookat>1 2 3  1 2 -9  0 5 0</lookat>" + instance("tri"));
  expect_near(load(text).scene.primitives.triangles.at(0).p1, {2, 2, 3});
  text.nodes = node("<lookat>1 2 3  9 2 3  3 1 0</lookat>" + instance("tri"));
  const Triangle t = load(text).scene.primitives.triangles.at(0);
  expect_near(t.p1, {1, 2, 4});  // x to the right of somebody who looks along x
  expect_near(t.p2, {1, 3, 3});
  for (const char* up : {"0 0 1", "0 0 0"}) {
    text.nodes = node("<lookat>0 0 0 0 0 -9 " + std::string(up) + "</lookat>" + instance("tri"));
    expect_one_triangle(load(text));
    EXPECT_TRUE(has_note(load(text), "up direction along its view")) << up;
  }
  text.nodes = node("<lookat>0 0 0 0 9 0 0 -2 0</lookat>" + instance("tri"));
  expect_near(load(text).scene.primitives.triangles.at(0).n0, {0, -1, 0});
  text.nodes = node("<lookat>1 2 3 1 2 3 0 1 0</lookat>" + instance("tri"));
  EXPECT_TRUE(contains(error_of(text.str()), "<lookat> looks at its own place"));
}

// A source as exporters write it: an array with an id, and an accessor that names it.
std::string with_accessor(const std::string& numbers, const std::string& stride,
                          const std::string& params, const std::string& array = "a",
                          const std::string& more = "") {
  SceneText text = one_triangle();
  const std::string old = float_source("tri-p", "0 0 0 1 0 0 0 1 0", 9);
  text.geometries = replaced(text.geometries, old,
                             more + "<source id=\"tri-p\"><float_array id=\"a\">" + numbers +
                                 "</float_array><technique_common><accessor source=\"#" + array +
                                 "\" count=\"3\" stride=\"" + stride + "\">" + params +
                                 "</accessor></technique_common></source>");
  return text.str();
}

TEST(Accessors, skip_numbers_without_a_name) {
  const std::string x = "<param name=\"X\"/>", y = "<param name=\"Y\"/>", z = "<param name=\"Z\"/>";
  const std::string none = "<param type=\"float\"/>";
  expect_one_triangle(load_text(with_accessor("9 0 0 0 9 1 0 0 9 0 1 0", "4", none + x + y + z)));
  expect_one_triangle(
      load_text(with_accessor("0 9 0 0 1 9 0 0 0 9 1 0", "4", x + "<param name=\"\"/>" + y + z)));
  const LoadedScene skipped =
      load_text(with_accessor("0 9 0 9 0 1 9 0 9 0 0 9 1 9 0", "5", x + none + y + none + z));
  expect_one_triangle(skipped);
  EXPECT_TRUE(has_note(skipped, "skips numbers"));
  for (const std::string& params : {x + y + z, x + y + z + none, none + none + none}) {
    const LoadedScene plain = load_text(with_accessor("0 0 0 9 1 0 0 9 0 1 0 9", "4", params));
    expect_one_triangle(plain);
    EXPECT_FALSE(has_note(plain, "skips"));
    EXPECT_EQ(has_note(plain, "no <param> of an <accessor> has a name"), !contains(params, "name"));
  }
  EXPECT_TRUE(contains(error_of(with_accessor("0 0 0 1 0 0 0 1 0", "3", none + y + z)),
                       "names 2 numbers of a vector"));
}

TEST(Accessors, of_two_numbers_give_a_flat_shape) {
  const LoadedScene flat = load_text(with_accessor("0 0 1 0 0 1", "2", ""));
  expect_one_triangle(flat);
  EXPECT_TRUE(has_note(flat, "of two numbers: the third is 0"));
}

// The specification's types for names and references ignore white space around them.
TEST(Attributes, have_no_blanks_around_them) {
  std::string text = with_accessor("0 0 0 1 0 0 0 1 0", "3", "");
  for (const char* part : {"id=\"tri-p\"", "source=\"#a\"", "stride=\"3\""}) {
    const std::string blank = std::string(part).insert(std::string(part).find('"') + 1, " \n");
    ASSERT_TRUE(contains(text, part));
    text = replaced(text, part, blank);
  }
  expect_one_triangle(load_text(text));
}

TEST(Accessors, read_the_array_that_they_name) {
  const std::string other =
      "<source id=\"o\"><float_array id=\"b\">0 0 0 1 0 0 0 1 0</float_array></source>";
  const std::string nines = "9 9 9 9 9 9 9 9 9";
  expect_one_triangle(load_text(with_accessor(nines, "3", "", "b", other)));
  const std::string without_own = replaced(with_accessor(nines, "3", "", "b", other),
                                           "<float_array id=\"a\">" + nines + "</float_array>", "");
  expect_one_triangle(load_text(without_own));
  const LoadedScene lost = load_text(with_accessor("0 0 0 1 0 0 0 1 0", "3", "", "gone"));
  expect_one_triangle(lost);
  EXPECT_TRUE(has_note(lost, "names no array of the file ('#gone')"));
}

TEST(Arrays, may_hold_more_than_they_announce) {
  SceneText text = one_triangle();
  text.geometries = replaced(text.geometries, "count=\"9\"", "count=\"8\"");
  const LoadedScene loaded = load(text);
  expect_one_triangle(loaded);
  EXPECT_TRUE(has_note(loaded, "announces 8 numbers and holds 9: all are read"));
}

TEST(Scenes, that_nothing_names_are_the_only_one) {
  const std::string text = one_triangle().str();
  const std::string scene = "<scene><instance_visual_scene url=\"#Scene\"/></scene>";
  for (const char* other : {"", "<scene/>", "<scene><instance_visual_scene url=\"#x\"/></scene>"}) {
    const LoadedScene loaded = load_text(replaced(text, scene, other));
    expect_one_triangle(loaded);
    EXPECT_TRUE(has_note(loaded, "it is the only <visual_scene> of the file")) << other;
  }
  const std::string two = replaced(text, "</visual_scene>", "</visual_scene><visual_scene/>");
  EXPECT_TRUE(load_text(two).notes.size() == load_text(text).notes.size());
  EXPECT_TRUE(contains(error_of(replaced(two, scene, "")), "names one of its 2 <visual_scene>s"));
}

TEST(Scenes, may_hold_instances_without_a_node) {
  SceneText text = one_triangle();
  text.library_nodes = "<node id=\"part\">" + instance("tri") + "</node>";
  text.up_axis = "Z_UP";
  for (const std::string& content :
       {std::string("<instance_node url=\"#part\"/>"), instance("tri")}) {
    text.nodes = content;
    expect_near(load(text).scene.primitives.triangles.at(0).p1, {-1, 0, 0});
  }
}

TEST(UpAxis, may_have_blanks_around_it_and_says_where_the_front_is) {
  SceneText text = one_triangle();
  const auto front = [&](const std::string& axis) {
    text.up_axis = axis;
    return load(text).front;
  };
  EXPECT_EQ(front("\n   Y_UP\t\n"), (Vec3{0, 0, 1}));
  EXPECT_EQ(front(" "), (Vec3{0, 0, 1}));
  EXPECT_EQ(front(" Z_UP"), (Vec3{0, 0, -1}));
  EXPECT_EQ(front("X_UP "), (Vec3{0, 0, -1}));
}

TEST(Assets, of_parts_are_ignored_with_a_note) {
  SceneText text = one_triangle();
  const auto noted = [&](const std::string& asset) {
    text.nodes = node(asset + instance("tri"));
    return has_note(load(text), "the <asset> of a <node> states its own");
  };
  EXPECT_TRUE(noted("<asset><up_axis>Z_UP</up_axis></asset>"));
  EXPECT_TRUE(noted("<asset><unit meter=\".01\"/></asset>"));
  EXPECT_FALSE(noted("<asset><unit meter=\"1\"/><up_axis>Y_UP</up_axis></asset>"));
  EXPECT_FALSE(noted("<asset/>"));
}

TEST(Spellings, of_a_file_are_read_alike) {
  const std::string text = one_triangle().str();
  expect_one_triangle(load_text(replaced(text, "0 0 0 1", "0 <!-- a -->0 0<!----> 1")));
  expect_one_triangle(load_text(replaced(text, "0 1 2", "<!-- a -->0 1<!-- b -->2")));
  expect_one_triangle(load_text(replaced(text, "0 1 2", "<![CDATA[0 1 ]]>2")));
  std::string prefixed = replaced(replaced(text, "<", "<ns0:"), "<ns0:/", "</ns0:");
  prefixed = replaced(prefixed, "<ns0:?xml", "<?xml");
  expect_one_triangle(load_text(prefixed));
  expect_one_triangle(load_text(replaced(prefixed, "ns0:", "collada:")));
  EXPECT_TRUE(contains(error_of("<a:svg/><b:COLLADA/>"), "outermost element"));
}

std::string as_utf16(const std::string& text, bool big, bool mark) {
  std::string out = !mark ? "" : big ? "\xfe\xff" : "\xff\xfe";
  for (const char c : text) out += big ? std::string{'\0', c} : std::string{c, '\0'};
  return out;
}

TEST(Spellings, of_characters_may_have_16_bits) {
  const std::string text = one_triangle().str();
  for (const bool big : {false, true}) {
    for (const bool mark : {false, true}) expect_one_triangle(load_text(as_utf16(text, big, mark)));
  }
  // A letter of two bytes, one of three, a pair of units and half a pair, in references.
  const auto named = [&](const std::string& units) {
    const std::string parts = replaced(text, "tri\"", "?\"");
    std::string out = as_utf16(parts, false, true);
    return replaced(out, std::string("?\0\"", 3), units + std::string("\"", 1));
  };
  for (const std::string& name :
       {std::string("\xfc\0", 2), std::string("\xac\x20"), std::string("\x3d\xd8\x00\xde", 4)}) {
    expect_one_triangle(load_text(named(name)));
  }
  EXPECT_TRUE(contains(error_of(named("\x3d\xd8")), "is not valid UTF-16"));
  EXPECT_TRUE(contains(error_of(as_utf16("hello", false, true)), "not a COLLADA file"));
}

TEST(Spellings, with_decimal_commas_are_read_if_no_number_has_a_point) {
  SceneText text = one_triangle();
  text.geometries =
      replaced(text.geometries, "0 0 0 1 0 0 0 1 0", "0,0 0 0,00 1,0 0 -0,0 0 1,0e0 0");
  const LoadedScene loaded = load(text);
  expect_one_triangle(loaded);
  EXPECT_TRUE(has_note(loaded, "decimal commas"));
  expect_one_triangle(load_text(replaced(text.str(), "0,0 0 0,00 1,0 0 -0,0 0 1,0e0 0",
                                         "0 0 0 1 0 <!-- and --> 0 0 1,0e0 0")));
  // Programs write versions and names of files everywhere, but these are not numbers.
  const std::string asset =
      "<asset><contributor><authoring_tool>T 1.5</authoring_tool></contributor>"
      "<revision>1.0</revision>";
  std::string other = replaced(text.str(), "<asset>", asset);
  other =
      replaced(other, "<library_effects>",
               "<!-- 1.5 > 1.4 --><library_images><image><init_from>w1.5.png</init_from></image>"
               "</library_images><library_effects>");
  expect_one_triangle(load_text(other));
  text.nodes += node("<translate>0.5 0.5 0</translate>");
  EXPECT_TRUE(contains(error_of(text.str()), "'0,0' in <float_array> is not a finite number"));
  for (const char* list : {"0,0,0,1,0,0,0,1,0", "0, 0, 0, 1, 0, 0, 0, 1, 0", "0,0 0,0,0 1"}) {
    const std::string mixed = replaced(one_triangle().str(), "0 0 0 1 0 0 0 1 0", list);
    EXPECT_TRUE(contains(error_of(mixed), "is not a finite number")) << list;
  }
}

TEST(Notes, of_one_kind_are_one) {
  SceneText text = one_triangle();
  for (int i = 0; i < 300; ++i) {
    const std::string id = "m" + std::to_string(i);
    text = with_material(text, id, "");
    text.nodes +=
        node("<translate>" + std::to_string(i + 1) + " 0 0</translate>" + instance("tri", id));
  }
  const LoadedScene loaded = load(text);
  ASSERT_EQ(loaded.notes.size(), 3u);  // and that there is no light
  EXPECT_TRUE(has_note(loaded,
                       "material 'm0' states no diffuse colour: its albedo is 0.5. (299 more like "
                       "this.)"));
}

TEST(FramingRule, is_the_courses_for_its_own_files) {
  const auto is_course = [](const std::string& tool, const std::string& effect_content) {
    SceneText text = with_material(one_triangle(), "m", effect_content);
    return load_text(replaced(text.str(), "<asset>",
                              "<asset><contributor><authoring_tool>" + tool +
                                  "</authoring_tool></contributor>"))
        .is_course;
  };
  EXPECT_TRUE(is_course("Any", course("<mirror/>")));
  EXPECT_TRUE(is_course("Any", "<extra><technique profile=\"CMU462\"/></extra>"));
  EXPECT_TRUE(is_course("Blender 2.74.0 commit date:2015-03-31", ""));
  EXPECT_FALSE(is_course("Blender 2.79.0", ""));
  EXPECT_FALSE(is_course("Any", "<extra><technique profile=\"blender\"/></extra>"));
}

}  // namespace
}  // namespace pt
