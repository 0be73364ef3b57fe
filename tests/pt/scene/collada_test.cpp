#include "collada_text.h"

#include <cmath>

namespace pt {
namespace {

Triangle only_triangle(const LoadedScene& loaded) {
  EXPECT_EQ(loaded.scene.primitives.triangles.size(), 1u);
  return loaded.scene.primitives.triangles.at(0);
}

LoadedScene load_one(const std::string& node_content, const std::string& up_axis = "Y_UP") {
  SceneText text;
  text.up_axis = up_axis;
  text.geometries = triangle_mesh();
  text.nodes = node(node_content + instance("tri"));
  return load(text);
}

// A triangle with a normal at each corner, scaled.
Triangle load_with_normals(const std::string& positions, const std::string& normals,
                           const std::string& scale) {
  SceneText text;
  text.geometries = mesh("tri", positions, 9, "triangles", "count=\"1\"",
                         "<input semantic=\"NORMAL\" source=\"#n\" offset=\"0\"/><p>0 1 2</p>",
                         float_source("n", normals, 9));
  text.nodes = node("<scale>" + scale + "</scale>" + instance("tri"));
  return only_triangle(load(text));
}

TEST(Transforms, act_in_document_order_the_last_listed_first) {
  // Scaled by 2, then turned so that x goes to y, then moved.
  const Triangle t = only_triangle(
      load_one("<translate>1 2 3</translate><rotate>0 0 5 90</rotate><scale>2 2 2</scale>"));
  expect_near(t.p0, {1, 2, 3});
  expect_near(t.p1, {1, 4, 3});
  expect_near(t.p2, {-1, 2, 3});
}

// 3ds Max writes 0 0 0 0.
TEST(Transforms, about_no_axis_turn_nothing) {
  for (const char* rotate : {"0 0 0 0", "0 0 0 90"}) {
    const LoadedScene loaded =
        load_one("<translate>1 2 3</translate><rotate>" + std::string(rotate) + "</rotate>");
    expect_near(only_triangle(loaded).p1, {2, 2, 3});
    EXPECT_EQ(has_note(loaded, "turns nothing"), std::string(rotate) == "0 0 0 90");
  }
}

TEST(Transforms, matrices_are_row_major) {
  const Triangle t =
      only_triangle(load_one("<matrix>0 -1 0 10 1 0 0 20 0 0 1 30 0 0 0 1</matrix>"));
  expect_near(t.p0, {10, 20, 30});
  expect_near(t.p1, {10, 21, 30});
  expect_near(t.p2, {9, 20, 30});
}

TEST(Transforms, of_nested_and_instanced_nodes_multiply) {
  SceneText text;
  text.geometries = triangle_mesh();
  text.library_nodes =
      "<node id=\"part\"><translate>0 0 1</translate>" + instance("tri") + "</node>";
  text.nodes = node("<scale>2 2 2</scale>" + node("<translate>1 0 0</translate>" + instance("tri") +
                                                  "<instance_node url=\"#part\"/>"));
  const LoadedScene loaded = load(text);
  ASSERT_EQ(loaded.scene.primitives.triangles.size(), 2u);
  expect_near(loaded.scene.primitives.triangles[0].p1, {4, 0, 0});
  expect_near(loaded.scene.primitives.triangles[1].p1, {4, 0, 2});
}

// Each axis map is a rotation, so a triangle still faces the same side.
TEST(UpAxis, maps_as_stated) {
  const Triangle z_up = only_triangle(load_one("<translate>1 2 3</translate>", "Z_UP"));
  expect_near(z_up.p0, {-1, 3, 2});
  expect_near(z_up.p1, {-2, 3, 2});
  expect_near(z_up.n0, {0, 1, 0});
  const Triangle x_up = only_triangle(load_one("<translate>1 2 3</translate>", "X_UP"));
  expect_near(x_up.p0, {2, 1, -3});
  expect_near(x_up.n0, {0, 0, -1});
}

// Mirrored in x, a square that faces +z still does, because its corners are reversed.
TEST(Transforms, that_mirror_turn_the_winding_order) {
  const Triangle t = load_with_normals("0 0 0 1 0 0 0 1 0", "1 0 1 0 0 3 0 1 1", "-1 1 1");
  EXPECT_EQ(geometric_normal(t), (Vec3{0, 0, 1}));
  const double r = std::sqrt(0.5);
  expect_near(t.p0, {0, 0, 0});
  expect_near(t.n0, {-r, 0, r});
  expect_near(t.p1, {0, 1, 0});
  expect_near(t.n1, {0, r, r});
  expect_near(t.p2, {-1, 0, 0});
  expect_near(t.n2, {0, 0, 1});
}

TEST(Meshes, fan_faces_of_more_than_three_corners) {
  SceneText text;
  text.geometries = mesh("pent", "0 0 0 2 0 0 3 1 0 1 2 0 -1 1 0", 15, "polylist", "count=\"2\"",
                         "<vcount>5 3</vcount><p>0 1 2 3 4 0 1 3</p>");
  text.nodes = node(instance("pent"));
  const LoadedScene loaded = load(text);
  const std::vector<Triangle>& all = loaded.scene.primitives.triangles;
  ASSERT_EQ(all.size(), 4u);
  for (int i = 0; i < 3; ++i) {
    expect_near(all[i].p0, {0, 0, 0});
    expect_near(all[i].n0, {0, 0, 1});
  }
  expect_near(all[1].p1, {3, 1, 0});
  expect_near(all[1].p2, {1, 2, 0});
  expect_near(all[2].p1, {1, 2, 0});
  expect_near(all[2].p2, {-1, 1, 0});
}

// Two sets of texture coordinates share the normals' offset: a corner has two indices.
TEST(Meshes, may_share_offsets) {
  SceneText text;
  text.geometries = mesh("tri", "0 0 0 1 0 0 0 1 0", 9, "triangles", "count=\"1\"",
                         "<input semantic=\"NORMAL\" source=\"#n\" offset=\"1\"/>"
                         "<input semantic=\"TEXCOORD\" source=\"#none\" offset=\"1\" set=\"0\"/>"
                         "<input semantic=\"TEXCOORD\" source=\"#none\" offset=\"1\" set=\"1\"/>"
                         "<p>0 1 1 0 2 1</p>",
                         float_source("n", "0 0 2 0 3 4", 6));
  text.nodes = node(instance("tri"));
  const Triangle t = only_triangle(load(text));
  expect_near(t.n0, {0, 0.6, 0.8});
  expect_near(t.n1, {0, 0, 1});
  expect_near(t.n2, {0, 0.6, 0.8});
}

TEST(Meshes, take_normals_of_vertices_and_the_face_normal_for_zero_ones) {
  SceneText text;
  text.geometries = "<geometry id=\"g\"><mesh>" + float_source("p", "0 0 0 1 0 0 0 1 0", 9) +
                    float_source("n", "0 0 0 0 -2 0 1 0 0", 9) +
                    "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/>"
                    "<input semantic=\"NORMAL\" source=\"#n\"/></vertices><polygons count=\"1\">"
                    "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1 2</p></polygons>"
                    "</mesh></geometry>";
  text.nodes = node(instance("g"));
  const Triangle t = only_triangle(load(text));
  expect_near(t.n0, {0, 0, 1});
  expect_near(t.n1, {0, -1, 0});
  expect_near(t.n2, {1, 0, 0});
}

TEST(Meshes, take_the_face_normal_where_the_list_of_normals_is_empty) {
  SceneText text;
  text.geometries = mesh("tri", "0 0 0 1 0 0 0 1 0", 9, "triangles", "count=\"1\"",
                         "<input semantic=\"NORMAL\" source=\"#n\" offset=\"1\"/>"
                         "<p>0 0 1 0 2 0</p>",
                         float_source("n", "", 0));
  text.nodes = node(instance("tri"));
  const Triangle t = only_triangle(load(text));
  for (const Vec3 n : {t.n0, t.n1, t.n2}) expect_near(n, {0, 0, 1});
}

// Stretched by 4 in x, a slope's normal turns away from x (the inverse transpose).
TEST(Meshes, keep_normals_perpendicular_when_stretched) {
  const Triangle t = load_with_normals("0 0 0 1 0 -1 0 1 0", "1 0 1 1 0 1 1 0 1", "4 1 1");
  expect_near(t.n0, normalize(Vec3{1, 0, 4}));
}

TEST(Meshes, read_accessors_with_stride_and_offset) {
  SceneText text;
  text.geometries =
      "<geometry id=\"g\"><mesh><source id=\"p\"><float_array count=\"14\">"
      "9 9 0 0 0 7 1 0 0 7 0 1 0 7</float_array><technique_common>"
      "<accessor offset=\"2\" stride=\"4\" count=\"3\"/></technique_common></source>"
      "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>"
      "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
      "<p>0 1 2</p></triangles></mesh></geometry>";
  text.nodes = node(instance("g"));
  expect_near(only_triangle(load(text)).p2, {0, 1, 0});
}

TEST(Meshes, leave_out_triangles_without_area_and_say_so) {
  SceneText text;
  text.geometries = mesh("tri", "0 0 0 1 0 0 0 1 0 2 0 0", 12, "triangles", "count=\"3\"",
                         "<p>0 1 2 0 1 3 1 1 1</p>");
  text.nodes = node(instance("tri"));
  const LoadedScene loaded = load(text);
  only_triangle(loaded);
  EXPECT_TRUE(has_note(loaded, "2 triangles without an area"));
}

TEST(Numbers, come_in_all_spellings) {
  SceneText text;
  text.geometries = mesh("tri", "+0 0.0 -0 1e0 .0e-7\n\t0 0 1.e+0 0", 9, "triangles", "count=\"1\"",
                         "<p> 0\r\n1 2 </p>");
  text.nodes = node(instance("tri"));
  EXPECT_EQ(geometric_normal(only_triangle(load(text))), (Vec3{0, 0, 1}));
}

TEST(Spheres, are_placed_by_their_node) {
  SceneText text;
  text.geometries = sphere("ball", ".5") + triangle_mesh();
  text.nodes = node("<translate>1 2 3</translate><rotate>1 1 0 33</rotate><scale>3 3 -3</scale>" +
                    instance("ball")) +
               node(instance("tri"));
  const LoadedScene loaded = load(text);
  ASSERT_EQ(loaded.scene.primitives.spheres.size(), 1u);
  expect_near(loaded.scene.primitives.spheres[0].center, {1, 2, 3});
  EXPECT_NEAR(loaded.scene.primitives.spheres[0].radius, 1.5, 1e-14);
  EXPECT_EQ(loaded.scene.material_of.size(), 2u);
}

}  // namespace
}  // namespace pt
