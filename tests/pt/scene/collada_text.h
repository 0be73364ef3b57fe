#pragma once

#include "pt/scene/load_collada.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace pt {

// Small COLLADA files, built from the pieces that a test needs. `nodes` is the content of the
// visual scene; the others are the contents of the libraries.
struct SceneText {
  std::string nodes;
  std::string geometries;
  std::string effects;
  std::string materials;
  std::string lights;
  std::string cameras;
  std::string up_axis = "Y_UP";
  std::string library_nodes;
  bool has_asset = true;

  std::string str() const {
    const std::string asset = "<asset><up_axis>" + up_axis + "</up_axis></asset>";
    return "<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\">\n" + (has_asset ? asset : "") +
           "\n<library_lights>" + lights + "</library_lights>\n<library_cameras>" + cameras +
           "</library_cameras>\n<library_effects>" + effects +
           "</library_effects>\n<library_materials>" + materials +
           "</library_materials>\n<library_geometries>" + geometries +
           "</library_geometries>\n<library_nodes>" + library_nodes +
           "</library_nodes>\n<library_visual_scenes><visual_scene id=\"Scene\">\n" + nodes +
           "\n</visual_scene></library_visual_scenes>\n"
           "<scene><instance_visual_scene url=\"#Scene\"/></scene>\n</COLLADA>\n";
  }
};

inline std::string float_source(const std::string& id, const std::string& numbers, int count) {
  return "<source id=\"" + id + "\"><float_array count=\"" + std::to_string(count) + "\">" +
         numbers + "</float_array></source>";
}

inline std::string position_inputs(const std::string& id) {
  return "<vertices id=\"" + id + "-v\"><input semantic=\"POSITION\" source=\"#" + id +
         "-p\"/></vertices>";
}

// A mesh with positions and one set of faces. `faces` is the set's element after its input VERTEX.
inline std::string mesh(const std::string& id, const std::string& positions, int count,
                        const std::string& kind, const std::string& attributes,
                        const std::string& faces, const std::string& sources = "") {
  return "<geometry id=\"" + id + "\"><mesh>" + float_source(id + "-p", positions, count) +
         sources + position_inputs(id) + "<" + kind + " " + attributes +
         "><input semantic=\"VERTEX\" source=\"#" + id + "-v\" offset=\"0\"/>" + faces + "</" +
         kind + "></mesh></geometry>";
}

// The triangle (0,0,0) (1,0,0) (0,1,0), which faces +z.
inline std::string triangle_mesh(const std::string& id = "tri") {
  return mesh(id, "0 0 0 1 0 0 0 1 0", 9, "triangles", "count=\"1\" material=\"m\"",
              "<p>0 1 2</p>");
}

// The unit square of x and y around the origin, which faces +z.
inline std::string quad_mesh(const std::string& id = "quad") {
  return mesh(id, "-.5 -.5 0 .5 -.5 0 .5 .5 0 -.5 .5 0", 12, "polylist",
              "count=\"1\" material=\"m\"", "<vcount>4</vcount><p>0 1 2 3</p>");
}

inline std::string sphere(const std::string& id, const std::string& radius) {
  return "<geometry id=\"" + id + "\"><extra><technique profile=\"CGL\"><sphere><radius>" + radius +
         "</radius></sphere></technique></extra></geometry>";
}

inline std::string instance(const std::string& geometry, const std::string& material = "") {
  const std::string open = "<instance_geometry url=\"#" + geometry + "\">";
  if (material.empty()) return open + "</instance_geometry>";
  return open + "<bind_material><technique_common><instance_material symbol=\"m\" target=\"#" +
         material + "\"/></technique_common></bind_material></instance_geometry>";
}

inline std::string node(const std::string& content, const std::string& name = "n") {
  return "<node name=\"" + name + "\">" + content + "</node>\n";
}

inline std::string material(const std::string& id) {
  return "<material id=\"" + id + "\" name=\"" + id + "\"><instance_effect url=\"#" + id +
         "-e\"/></material>";
}

inline std::string common_diffuse(const std::string& color) {
  return "<profile_COMMON><technique sid=\"c\"><phong><diffuse><color>" + color +
         "</color></diffuse></phong></technique></profile_COMMON>";
}

inline std::string course(const std::string& content) {
  return "<extra><technique profile=\"CGL\">" + content + "</technique></extra>";
}

inline std::string effect(const std::string& material_id, const std::string& content) {
  return "<effect id=\"" + material_id + "-e\">" + content + "</effect>";
}

// The scene with an added material `id` of this effect.
inline SceneText with_material(SceneText text, const std::string& id, const std::string& content) {
  text.materials += material(id);
  text.effects += effect(id, content);
  return text;
}

inline std::filesystem::path scratch_file(const std::string& content) {
  std::filesystem::path file = std::filesystem::path(::testing::TempDir()) /
                               ("collada_" + std::to_string(getpid()) + ".dae");
  std::ofstream(file, std::ios::binary) << content;
  return file;
}

inline LoadedScene load_text(const std::string& content, const LoadOptions& options = {}) {
  const std::filesystem::path file = scratch_file(content);
  struct Remove {
    const std::filesystem::path& file;
    ~Remove() { std::filesystem::remove(file); }
  } remove{file};
  return load_collada(file, options);
}

inline LoadedScene load(const SceneText& text, const LoadOptions& options = {}) {
  return load_text(text.str(), options);
}

// Returns whether some note contains the text.
inline bool has_note(const LoadedScene& loaded, const std::string& text) {
  for (const std::string& note : loaded.notes) {
    if (note.find(text) != std::string::npos) return true;
  }
  return false;
}

inline void expect_near(Vec3 a, Vec3 b, double tolerance = 1e-14) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

inline SceneText one_triangle() {
  SceneText text;
  text.geometries = triangle_mesh();
  text.nodes = node(instance("tri"));
  return text;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace pt
