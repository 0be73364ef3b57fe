#include "collada_text.h"
#include "pt/error.h"

namespace pt {
namespace {

// The message must be one line, name the file and a line, contain `what`, and end with advice.
void expect_error(const std::string& content, const std::string& what) {
  try {
    load_text(content);
    ADD_FAILURE() << "no error; expected: " << what;
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(what), std::string::npos) << message << "\nexpected: " << what;
    EXPECT_NE(message.find(".dae:"), std::string::npos) << message;
    EXPECT_NE(message.find("; "), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

void expect_error(const SceneText& text, const std::string& what) {
  expect_error(text.str(), what);
}

SceneText triangle_of(const std::string& faces, const std::string& positions = "0 0 0 1 0 0 0 1 0",
                      int count = 9) {
  SceneText text;
  text.geometries = mesh("tri", positions, count, "triangles", "count=\"1\"", faces);
  text.nodes = node(instance("tri"));
  return text;
}

SceneText with_node(const std::string& content) {
  SceneText text = triangle_of("<p>0 1 2</p>");
  text.nodes += node(content);
  return text;
}

TEST(BadFiles, are_named) {
  EXPECT_THROW(load_collada(std::filesystem::path(::testing::TempDir()) / "none.dae"), Error);
  EXPECT_THROW(load_collada(::testing::TempDir()), Error);
  expect_error("", "is empty");
  expect_error("hello", "not a COLLADA file");
  expect_error("# cube\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
               "but a Wavefront OBJ; ./run convert");
  expect_error("ply\nformat ascii 1.0\n", "but a PLY; ./run convert");
  expect_error("solid s\n facet normal 0 0 1\n", "but an STL; ./run convert");
  expect_error(std::string(80, 'x') + std::string("\1\0\0\0", 4) + std::string(50, 'y'),
               "but a binary STL; ./run convert");
  expect_error("{\"asset\": {\"version\": \"2.0\"}}", "but a glTF; ./run convert");
  expect_error("glTF\2", "but a binary glTF; ./run convert");
  expect_error("Kaydara FBX Binary  ", "but an FBX; ./run convert");
  expect_error("<svg/>", "not a COLLADA file");
  expect_error("<a><COLLADA/></a>", "outermost element");
  expect_error(std::string("<COLLADA>\0</COLLADA>", 20), "zero byte");
  expect_error("<COLLADA></COLLADA>", "has no <scene>");
}

TEST(BadFiles, of_any_size_are_refused_at_once) {
  std::string garbage(100 << 20, 'x');
  expect_error(garbage, "not a COLLADA file");
  garbage.replace(0, 9, "<COLLADA>");
  expect_error(garbage, "cannot be read: ");
  std::string tags = "<COLLADA>";
  for (int i = 0; i < 2'000'001; ++i) tags += "<a/>";
  expect_error(tags + "</COLLADA>", "two million");
}

TEST(BadFiles, with_too_many_attributes_in_a_tag_are_refused_at_once) {
  const auto attributes = [](int count, const std::string& value) {
    std::string text;
    for (int i = 0; i < count; ++i) text += " a" + std::to_string(i) + "=" + value;
    return text;
  };
  for (const char* value : {"\"1\"", "'>'", "\"'\"", "\"<>\""}) {
    expect_error("<COLLADA>\n<a b=\"c\"/>\n<a" + attributes(400'000, value) + "/></COLLADA>",
                 ":3: a tag has more than 250");
  }
  expect_error("<COLLADA>\n<!-- don't <a --><a" + attributes(251, "\"\"") + "/></COLLADA>",
               ":2: a tag has");
  // Attributes of several tags, and text, which may be a program.
  std::string many = "<asset/>";
  for (int i = 0; i < 20; ++i) many += "<extra" + attributes(20, "'1'") + "/>";
  for (const std::string& text : {many, "<extra>" + attributes(400, "b;") + "</extra>",
                                  "<!-- <a" + attributes(400, "\"") + " -->",
                                  "<extra><![CDATA[ <a" + attributes(400, "'") + "]]></extra>"}) {
    SceneText scene;
    scene.geometries = triangle_mesh();
    scene.nodes = node(instance("tri"));
    scene.geometries += "<geometry id=\"unused\"><mesh/>" + text + "</geometry>";
    EXPECT_EQ(load(scene).scene.primitives.triangles.size(), 1u);
  }
}

TEST(BadXml, is_named_with_its_line) {
  const std::string good = triangle_of("<p>0 1 2</p>").str();
  expect_error(good.substr(0, good.size() / 2), "cannot be read: ");
  expect_error("<COLLADA>\n\n<a>\n</b></COLLADA>",
               ":3: the XML cannot be read: an element is not closed, or closed by another name; ");
  std::string deep = "<COLLADA>";
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  expect_error(deep, "nested more than 100 deep");
}

TEST(BadNumbers, are_named) {
  expect_error(triangle_of("<p>0 1 2</p>", "0 0 0 1 0 0 0 1 nan"), "'nan' in <float_array>");
  expect_error(triangle_of("<p>0 1 2</p>", "0 0 0 1 0 0 0 1 inf"), "is not a finite number");
  expect_error(triangle_of("<p>0 1 2</p>", "0 0 0 1 0 0 0 1 1e999"), "is not a finite number");
  expect_error(triangle_of("<p>0 1 2</p>", "0 0 0 1 0 0 0 1 2m"), "'2m' in");
  expect_error(triangle_of("<p>0 1 2</p>", "0 0 0 1 0 0 0 1 1e200"), "beyond 1e30");
  expect_error(triangle_of("<p>0 1 2.5</p>"), "is not an integer");
  expect_error(triangle_of("<p>0 1 99999999999</p>"), "is not an integer");
  expect_error(triangle_of("<p>0 <b/> 1 2</p>"), "more than numbers");
  expect_error(with_node("<scale>1 1</scale>"), "holds 2 numbers; write 3");
  expect_error(with_node("<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0</matrix>"), "holds 15 numbers");
  expect_error(with_node("<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1</matrix>"), "last row");
  expect_error(with_node("<scale>1e20 1 1</scale><scale>1e20 1 1</scale>"), "beyond 1e30");
}

TEST(BadMeshes, are_named) {
  expect_error(triangle_of("<p>0 1 3</p>"), "position 3 of 3");
  expect_error(triangle_of("<p>0 1 -1</p>"), "position -1 of 3");
  expect_error(triangle_of("<p>0 1 2 0</p>"), "fewer indices than the 4");
  expect_error(triangle_of("<p>0 1</p>"), "announces 1 faces and holds 0");
  expect_error(triangle_of("<p>0 1 2</p>", "0 0 0 1 0 0 0 1", 9),
               "announces 9 numbers and holds 8");
  expect_error(triangle_of("<input semantic=\"NORMAL\" source=\"#no\" offset=\"0\"/><p>0 1 2</p>"),
               "'#no'");
  expect_error(triangle_of("<input semantic=\"TEXCOORD\" offset=\"99999999\"/><p>0 1 2</p>"),
               "offset");
  SceneText text;
  text.nodes = node(instance("g"));
  const auto polylist = [&](const std::string& vcount, const std::string& p) {
    text.geometries = mesh("g", "0 0 0 1 0 0 0 1 0", 9, "polylist", "",
                           "<vcount>" + vcount + "</vcount><p>" + p + "</p>");
    return text;
  };
  expect_error(polylist("3 3", "0 1 2"), "more indices than the 3");
  expect_error(polylist("2000000000 2000000000", "0 1 2"), "more indices than the 3");
  expect_error(polylist("2", "0 1"), "no surface");
  expect_error(polylist("-3", "0 1 2"), "a face has -3 corners");
  text.geometries = mesh("g", "0 0 0", 3, "polygons", "", "<ph/>");
  expect_error(text, "<ph> has no <p>");
  text.geometries = mesh("g", "0 0 0 1 0 0 2 0 0", 9, "triangles", "", "<p>0 1 2</p>");
  expect_error(text, "no surface");
  text.geometries = mesh("g", "0 0 0", 3, "triangles", "count=\"-1\"", "<p>0 0 0</p>");
  expect_error(text, "is not a count");
}

TEST(BadAccessors, are_named) {
  const auto with_accessor = [](const std::string& attributes) {
    SceneText text = triangle_of("<p>0 1 2</p>");
    const std::string end = "</float_array>";
    text.geometries.insert(text.geometries.find(end) + end.size(),
                           "<technique_common><accessor " + attributes + "/></technique_common>");
    return text;
  };
  expect_error(with_accessor("stride=\"1\""), "correct the stride");
  expect_error(with_accessor("stride=\"3\" count=\"4\""), "asks for 4 vectors");
  expect_error(with_accessor("stride=\"3\" offset=\"4000000000\" count=\"1\""), "array has 0");
  expect_error(with_accessor("stride=\"3\" count=\"2\""), "position 2 of 2");
}

TEST(BadSpheres, are_named) {
  const auto placed = [](const std::string& radius, const std::string& transform) {
    SceneText text;
    text.geometries = sphere("ball", radius);
    text.nodes = node(transform + instance("ball"));
    return text;
  };
  expect_error(placed("0", ""), "above 0");
  expect_error(placed("-1", ""), "above 0");
  expect_error(placed("1 2", ""), "holds 2 numbers");
  expect_error(placed("1", "<scale>1 1 1.001</scale>"), "uniform");
  expect_error(placed("1", "<scale>0 0 0</scale>"), "uniform");
  expect_error(placed("1", "<matrix>1 .1 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>"), "uniform");
  expect_error(placed("1e31", ""), "beyond 1e30");
}

TEST(BadReferences, are_named) {
  SceneText twice = triangle_of("<p>0 1 2</p>");
  twice.geometries += twice.geometries;
  expect_error(twice, "'#tri' may be the <geometry> of line");
}

TEST(BadNodes, that_contain_themselves_or_never_end_are_named) {
  SceneText text = triangle_of("<p>0 1 2</p>");
  text.nodes += "<node id=\"a\"><instance_node url=\"#a\"/></node>";
  expect_error(text, "contains itself");

  text = triangle_of("<p>0 1 2</p>");
  text.library_nodes =
      "<node id=\"a\"><instance_node url=\"#b\"/></node>"
      "<node id=\"b\"><instance_node url=\"#a\"/></node>";
  text.nodes = node("<instance_node url=\"#b\"/>");
  expect_error(text, "contains itself");

  // Each node contains the next twice: 2^40 in all. And a chain of 300 nodes.
  for (const int copies : {2, 1}) {
    text.library_nodes.clear();
    const int length_of = copies == 2 ? 40 : 300;
    for (int i = 0; i < length_of; ++i) {
      const std::string next = "<instance_node url=\"#n" + std::to_string(i + 1) + "\"/>";
      text.library_nodes +=
          "<node id=\"n" + std::to_string(i) + "\">" + next + (copies == 2 ? next : "") + "</node>";
    }
    text.library_nodes += "<node id=\"n" + std::to_string(length_of) + "\"/>";
    text.nodes = node("<instance_node url=\"#n0\"/>");
    expect_error(text, copies == 2 ? "100,000 nodes" : "200 deep");
  }
}

TEST(BadCamerasAndLights, are_named) {
  const auto camera = [](const std::string& perspective) {
    SceneText text = with_node("<instance_camera url=\"#cam\"/>");
    text.cameras = "<camera id=\"cam\"><optics><technique_common><perspective>" + perspective +
                   "</perspective></technique_common></optics></camera>";
    return text;
  };
  expect_error(camera(""), "has no xfov");
  expect_error(camera("<xfov>180</xfov>"), "between 0 and 180");
  expect_error(camera("<xfov>nan</xfov>"), "is not a finite number");
  SceneText flat = camera("<xfov>50</xfov>");
  flat.nodes += node("<scale>1 1 0</scale><instance_camera url=\"#cam\"/>");
  expect_error(flat, "looks nowhere");

  const auto light = [](const std::string& content, const std::string& scale = "1 1 1") {
    SceneText text = with_node("<scale>" + scale + "</scale><instance_light url=\"#l\"/>");
    text.lights = "<light id=\"l\"><technique_common>" + content + "</technique_common></light>";
    return text;
  };
  expect_error(light("<glow><color>1 1 1</color></glow>"), "not a kind of light");
  expect_error(light("<point/>"), "has no <color>");
  expect_error(light("<point><color>1 1</color></point>"), "red, green and blue");
  for (const std::string color : {"-1 1 1", "1 -1 1", "1 1 -1"}) {
    expect_error(light("<point><color>" + color + "</color></point>"), "negative");
  }
  expect_error(light("<area><color>1 1 1</color></area>", "0 1 1"), "no area");
  expect_error(light("<directional><color>1 1 1</color></directional>", "1 1 0"), "no direction");
  SceneText up = triangle_of("<p>0 1 2</p>");
  up.up_axis = "W_UP";
  expect_error(up, "write X_UP, Y_UP or Z_UP");
}

}  // namespace
}  // namespace pt
