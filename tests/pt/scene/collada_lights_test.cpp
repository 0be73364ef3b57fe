#include "collada_text.h"
#include "pt/error.h"
#include "pt/scene/frame_camera.h"

#include <cmath>

namespace pt {
namespace {

const std::string kLamp = course("<emission><radiance>10 10 10</radiance></emission>");

std::string light(const std::string& kind, const std::string& color = "3 4 5") {
  return "<light id=\"l\"><technique_common><" + kind + "><color>" + color + "</color></" + kind +
         "></technique_common></light>";
}

// A light as the course writes it: a point light for other readers, its real kind in an extension.
std::string course_light(const std::string& kind, const std::string& color) {
  return "<light id=\"l\"><technique_common><point><color>1 1 1</color><constant_attenuation>1"
         "</constant_attenuation></point></technique_common>" +
         course("<" + kind + "><color>" + color + "</color></" + kind + ">") + "</light>";
}

const std::string kUse = "<instance_light url=\"#l\"/>";

LoadedScene load_light(const std::string& light_text, const std::string& transform,
                       const std::string& up_axis = "Y_UP") {
  SceneText text;
  text.up_axis = up_axis;
  text.geometries = triangle_mesh();
  text.lights = light_text;
  text.nodes = node(instance("tri")) + node(transform + kUse, "lamp");
  return load(text);
}

template <class Kind>
Kind only_light(const LoadedScene& loaded) {
  EXPECT_EQ(loaded.scene.lights.size(), 1u);
  return std::get<Kind>(loaded.scene.lights.at(0));
}

TEST(LightNodes, of_an_area_are_spanned_by_the_images_of_y_and_x_and_shine_along_minus_z) {
  const auto area = only_light<RectangleLight>(
      load_light(course_light("area", "7 8 9"),
                 "<matrix>.6 0 0 0 0 .8 0 0 0 0 1 1.5 0 0 0 1</matrix>", "Z_UP"));
  expect_near(area.center, {0, 1.5, 0});
  expect_near(area.u, {0, 0, .8});
  expect_near(area.v, {.6, 0, 0});
  expect_near(area.n, {0, -1, 0});
  EXPECT_EQ(area.radiance, (Rgb{7, 8, 9}));
}

TEST(LightNodes, of_an_area_shine_along_minus_z_also_when_mirrored) {
  const auto area = only_light<RectangleLight>(
      load_light(course_light("area", "1 1 1"), "<scale>-1 1 1</scale>"));
  expect_near(area.n, {0, 0, -1});
}

TEST(LightNodes, come_in_the_common_kinds) {
  const auto point = only_light<PointLight>(load_light(
      course_light("point", "3 4 5"), "<translate>1 2 3</translate><scale>9 9 9</scale>"));
  expect_near(point.position, {1, 2, 3});
  EXPECT_EQ(point.intensity, (Rgb{3, 4, 5}));
  const auto sun = only_light<DirectionalLight>(
      load_light(light("directional"),
                 "<translate>5 5 5</translate><rotate>1 0 0 -90</rotate>"
                 "<scale>2 2 2</scale>"));
  expect_near(sun.direction, {0, -1, 0});
  EXPECT_EQ(sun.irradiance, (Rgb{3, 4, 5}));
  EXPECT_EQ(only_light<AmbientLight>(load_light(light("ambient"), "")).radiance, (Rgb{3, 4, 5}));
}

// The triangle's bounding box is 1 x 1 x 0, with its middle at (.5, .5, 0). At (.5, .5, 10) the light
// is 10 away from there; at the middle, half the diagonal counts: its square is .5.
TEST(LightNodes, of_other_programs_are_as_bright_as_the_file_says_in_the_middle_of_the_scene) {
  const auto intensity = [](const std::string& attenuations, const std::string& z,
                            const std::string& note) {
    const LoadedScene loaded =
        load_light("<light id=\"l\"><technique_common><point><color>3 4 5</color>" + attenuations +
                       "</point></technique_common></light>",
                   "<translate>.5 .5 " + z + "</translate>");
    EXPECT_EQ(has_note(loaded, "point light"), !note.empty()) << attenuations;
    EXPECT_TRUE(note.empty() || has_note(loaded, note)) << loaded.notes.at(0);
    return only_light<PointLight>(loaded).intensity.r;
  };
  const auto terms = [](const std::string& c, const std::string& l, const std::string& q) {
    return "<constant_attenuation>" + c + "</constant_attenuation><linear_attenuation>" + l +
           "</linear_attenuation><quadratic_attenuation>" + q + "</quadratic_attenuation>";
  };
  const std::string even = "1 + 0 d + 0 d^2) in the file (COLLADA's default is 1, not at all)";
  EXPECT_EQ(intensity("", "10", even), 300);
  EXPECT_NEAR(intensity("", "0", even), 1.5, 1e-15);
  EXPECT_EQ(intensity(terms("2", "0", "0"), "10", "1 / (2 + 0 d + 0 d^2)"), 150);
  EXPECT_EQ(intensity(terms("0", "0", "0"), "10", even), 300);
  EXPECT_EQ(intensity(terms("1", ".2", ".03"), "10",
                      "here it falls off as 1 / d^2, and is as bright as the file says at the "
                      "distance d = 10."),
            50);
  EXPECT_EQ(intensity(terms("0", "0", "4"), "10", ""), .75);
  EXPECT_THROW(intensity(terms("1", "-1", "0"), "10", ""), Error);
}

TEST(LightNodes, that_are_black_are_left_out_and_several_are_kept) {
  EXPECT_FALSE(load_light(light("point", "0 0 0"), "").has_own_light);
  SceneText text;
  text.geometries = triangle_mesh();
  text.lights = light("point");
  text.nodes = node(instance("tri")) + node(kUse) + node(kUse + kUse);
  EXPECT_EQ(load(text).scene.lights.size(), 3u);
}

TEST(LightNodes, that_are_spots_load_and_are_refused_for_light_transport) {
  const LoadedScene loaded = load_light(light("spot"), "");
  EXPECT_TRUE(has_note(loaded, "spot light 'lamp'"));
  EXPECT_THROW(require_supported(loaded, "box.dae"), Error);
}

TEST(LightNodes, without_a_kind_are_left_out) {
  for (const char* content : {"", "<technique_common/>", "<extra/>"}) {
    const LoadedScene loaded =
        load_light("<light id=\"l\">" + std::string(content) + "</light>", "");
    EXPECT_TRUE(has_note(loaded, "light 'l' has no kind")) << content;
    EXPECT_FALSE(loaded.has_own_light) << content;
  }
}

// A scene without a light is under a sky. A light that is asked for is added to those of the file.
TEST(Light, is_never_missing) {
  const auto kinds = [](const SceneText& text, LightChoice choice) {
    std::string found;
    LoadedScene loaded = load(text, {.light = choice});
    add_camera_light(loaded, frame_camera(loaded, Framing::fit, 4, 3));
    for (const Light& light : loaded.scene.lights) {
      found += std::holds_alternative<AmbientLight>(light) ? "sky " : "point ";
    }
    EXPECT_NO_THROW(require_supported(loaded, "scene.dae"));
    return found + (has_note(loaded, "the file has no light") ? "noted" : "");
  };
  const SceneText dark = one_triangle();
  EXPECT_EQ(kinds(dark, LightChoice::file), "sky noted");
  EXPECT_EQ(kinds(dark, LightChoice::course), "sky noted");
  EXPECT_EQ(kinds(dark, LightChoice::sky), "sky ");
  EXPECT_EQ(kinds(dark, LightChoice::camera), "point ");
  SceneText lit = dark;
  lit.lights = light("point");
  lit.nodes += node(kUse);
  EXPECT_EQ(kinds(lit, LightChoice::file), "point ");
  EXPECT_EQ(kinds(lit, LightChoice::sky), "point sky ");
  EXPECT_EQ(kinds(lit, LightChoice::camera), "point point ");
  SceneText spot = dark;
  spot.lights = light("spot");
  spot.nodes += node(kUse);
  EXPECT_EQ(kinds(spot, LightChoice::sky), "sky ");
  EXPECT_EQ(kinds(spot, LightChoice::camera), "point ");
}

// A white wall that fills the view from 5 away gets the irradiance pi, and so has the radiance 1.
TEST(Light, at_the_camera_is_as_bright_as_white) {
  SceneText text;
  text.geometries = quad_mesh();
  text.nodes = node("<scale>100 100 1</scale>" + instance("quad"));
  LoadedScene loaded = load(text, {.light = LightChoice::camera});
  Camera camera;
  camera.position = {0, 0, 5};
  camera.hfov_deg = camera.vfov_deg = 1;
  add_camera_light(loaded, camera);
  const auto& lamp = std::get<PointLight>(loaded.scene.lights.at(0));
  EXPECT_EQ(lamp.position, camera.position);
  EXPECT_NEAR(lamp.intensity.g, kPi * 25, .01);
}

// Emitting surfaces, each under the transform, with a light node only if one is added.
LoadedScene load_emitter(const std::string& geometry, const std::string& transform,
                         const std::string& more_nodes = "", const std::string& lights = "") {
  SceneText text;
  text.geometries = geometry;
  text.lights = lights;
  text.nodes = node(transform + instance("g", "lamp"), "panel") + more_nodes;
  return load(with_material(text, "lamp", kLamp));
}

TEST(EmittingSurfaces, that_are_parallelograms_are_rectangle_lights) {
  const auto light_of = only_light<RectangleLight>(load_emitter(
      quad_mesh("g"), "<translate>0 2 0</translate><rotate>1 0 0 90</rotate><scale>3 4 1</scale>"));
  expect_near(light_of.center, {0, 2, 0});
  expect_near(light_of.n, {0, -1, 0});
  EXPECT_NEAR(length(cross(light_of.u, light_of.v)), 12, 1e-12);
  EXPECT_NEAR(std::abs(dot(light_of.u, light_of.v)), 0, 1e-12);
  EXPECT_NEAR(std::abs(light_of.u.x) + std::abs(light_of.v.x), 3, 1e-12);
  EXPECT_EQ(light_of.radiance, gray(10));
}

TEST(EmittingSurfaces, are_rectangle_lights_whichever_way_their_triangles_are_listed) {
  for (const std::string faces : {"0 1 2 0 2 3", "1 2 0 3 0 2", "2 0 1 2 3 0", "1 2 3 1 3 0"}) {
    const auto light_of = only_light<RectangleLight>(
        load_emitter(mesh("g", "0 0 0 2 0 0 3 1 0 1 1 0", 12, "triangles",
                          "count=\"2\" material=\"m\"", "<p>" + faces + "</p>"),
                     ""));
    expect_near(light_of.center, {1.5, .5, 0});
    expect_near(light_of.n, {0, 0, 1});
    EXPECT_NEAR(length(cross(light_of.u, light_of.v)), 2, 1e-12);
    // Every corner is the centre plus half of each side, in some direction.
    const Vec3 sum = 0.5 * (light_of.u + light_of.v), difference = 0.5 * (light_of.u - light_of.v);
    const bool has_origin = std::min({length(light_of.center + sum), length(light_of.center - sum),
                                      length(light_of.center + difference),
                                      length(light_of.center - difference)}) < 1e-12;
    EXPECT_TRUE(has_origin);
  }
}

// A kite, a quad with halves that face opposite ways, two quads, and three corners.
TEST(EmittingSurfaces, of_another_shape_are_mesh_lights) {
  struct Case {
    std::string faces;
    int count;
    double area;
  };
  for (const Case& c : {Case{"0 1 2 0 2 4", 2, 1.5}, Case{"0 1 2 0 3 2", 2, 1},
                        Case{"0 1 2 0 2 3 0 3 4", 3, 1.5}, Case{"0 1 2", 1, .5}}) {
    const auto light_of = only_light<MeshLight>(load_emitter(
        mesh("g", "0 0 0 1 0 0 1 1 0 0 1 0 -1 1 0", 15, "triangles",
             "count=\"" + std::to_string(c.count) + "\" material=\"m\"", "<p>" + c.faces + "</p>"),
        ""));
    EXPECT_EQ(light_of.faces.size(), static_cast<std::size_t>(c.count));
    EXPECT_NEAR(light_of.area_up_to.back(), c.area, 1e-12);
  }
}

TEST(EmittingSurfaces, that_are_spheres_are_sphere_lights) {
  const auto light_of = only_light<SphereLight>(
      load_emitter(sphere("g", ".5"), "<translate>1 2 3</translate><scale>4 4 4</scale>"));
  expect_near(light_of.center, {1, 2, 3});
  EXPECT_NEAR(light_of.radius, 2, 1e-14);
  EXPECT_EQ(light_of.radiance, gray(10));
}

TEST(EmittingSurfaces, emit_on_the_side_of_the_winding_order_also_when_mirrored) {
  const auto light_of =
      only_light<RectangleLight>(load_emitter(quad_mesh("g"), "<scale>1 -1 1</scale>"));
  expect_near(light_of.n, {0, 0, 1});
}

TEST(EmittingSurfaces, say_when_their_normals_are_against_their_winding_order) {
  const auto with_normal = [](const std::string& z) {
    return load_emitter(mesh("g", "0 0 0 1 0 0 0 1 0", 9, "triangles", "count=\"1\" material=\"m\"",
                             "<input semantic=\"NORMAL\" source=\"#n\" offset=\"1\"/>"
                             "<p>0 0 1 0 2 0</p>",
                             float_source("n", "0 0 " + z, 3)),
                        "");
  };
  EXPECT_TRUE(has_note(with_normal("-1"), "against its winding order"));
  EXPECT_FALSE(has_note(with_normal("1"), "against its winding order"));
}

// The course's own boxes: sides are swapped, the colour is halved, the centre is off by .004. The
// panel is .8 x .6 in x and z. The node is .6 x .8; it shines down along -z of Z_UP, +y of Y_UP.
const std::string kPanelPlace =
    "<translate>0 1.49 .0043</translate><rotate>1 0 0 90</rotate><scale>.8 .6 1</scale>";
const std::string kNodePlace =
    "<translate>0 1.49 0</translate><rotate>1 0 0 -90</rotate><scale>.6 .8 1</scale>";

TEST(LightNodesOnSurfaces, give_way_to_the_surface) {
  const LoadedScene loaded = load_emitter(quad_mesh("g"), kPanelPlace, node(kNodePlace + kUse),
                                          course_light("area", "5 5 5"));
  const auto light_of = only_light<RectangleLight>(loaded);
  expect_near(light_of.center, {0, 1.49, .0043});
  EXPECT_NEAR(std::abs(light_of.u.x) + std::abs(light_of.v.x), .8, 1e-12);
  EXPECT_EQ(light_of.radiance, gray(10));
  EXPECT_TRUE(has_note(loaded, "'panel', which is the light"));
  EXPECT_TRUE(has_note(loaded, "0.6 x 0 x 0.8 along x, y, z is replaced by 0.8 x 0 x 0.6"));
  EXPECT_TRUE(has_note(loaded, "colour 5 5 5 is replaced by the radiance 10 10 10"));
}

TEST(LightNodesOnSurfaces, that_shine_to_the_other_side_are_noted) {
  for (const std::string angle : {"90", "-90"}) {
    std::string place = "<translate>0 1.49 0</translate><rotate>1 0 0 ";
    place.append(angle).append("</rotate><scale>.6 .8 1</scale>").append(kUse);
    const LoadedScene loaded =
        load_emitter(quad_mesh("g"), kPanelPlace, node(place), course_light("area", "10 10 10"));
    expect_near(only_light<RectangleLight>(loaded).n, {0, -1, 0});
    EXPECT_EQ(has_note(loaded, "it shone to the other side"), angle == "90");
  }
}

TEST(LightNodesOnSurfaces, that_agree_are_not_mentioned) {
  const LoadedScene loaded = load_emitter(quad_mesh("g"), "<rotate>0 1 0 180</rotate>", node(kUse),
                                          course_light("area", "10 10 10"));
  EXPECT_EQ(loaded.scene.lights.size(), 1u);
  EXPECT_FALSE(has_note(loaded, "which is the light"));
}

TEST(LightNodesOnSurfaces, give_way_to_a_flat_mesh_and_to_the_same_lamp_as_a_point) {
  EXPECT_EQ(load_emitter(mesh("g", "-.5 -.5 0 .5 -.5 0 0 1 0", 9, "triangles",
                              "count=\"1\" material=\"m\"", "<p>0 1 2</p>"),
                         "", node(kUse), course_light("area", "5 5 5"))
                .scene.lights.size(),
            1u);
  const LoadedScene point =
      load_emitter(quad_mesh("g"), kPanelPlace, node(kNodePlace + kUse), light("point"));
  only_light<RectangleLight>(point);
  EXPECT_TRUE(has_note(point, "the point light is left out"));
}

// These are different lamps: elsewhere, tilted, a point in front of the surface, a closed surface.
TEST(LightNodesOnSurfaces, are_lights_of_their_own_elsewhere) {
  const auto lights = [](const std::string& place, const std::string& light_text) {
    return load_emitter(quad_mesh("g"), "", node(place + kUse), light_text).scene.lights.size();
  };
  const std::string area = course_light("area", "5 5 5");
  EXPECT_EQ(lights("", area), 1u);
  EXPECT_EQ(lights("<translate>0 0 .1</translate>", area), 2u);
  EXPECT_EQ(lights("<rotate>1 0 0 30</rotate>", area), 2u);
  EXPECT_EQ(lights("<translate>0 0 .01</translate>", light("point")), 2u);
  EXPECT_EQ(lights("", light("directional")), 2u);
  EXPECT_EQ(load_emitter(sphere("g", "1"), "", node(kUse), light("point")).scene.lights.size(), 2u);
}

}  // namespace
}  // namespace pt
