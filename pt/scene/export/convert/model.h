#pragma once

#include "pt/math/rgb.h"
#include "pt/math/vec3.h"

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pt {

// The part of a model in another format that is kept: triangles with one diffuse colour per mesh.
struct ModelMesh {
  std::vector<Vec3> p;
  std::vector<Vec3> n;  // one per corner, or none
  std::vector<std::array<unsigned, 3>> faces;
  Rgb albedo;
};

struct Model {
  std::vector<ModelMesh> meshes;
  std::map<std::string, std::size_t> lost;  // "textures" -> 3: what the file has besides
};

// Reads a model with assimp. Throws Error if it cannot, or if the file has no faces.
Model read_model(const std::filesystem::path& file);

enum class Surroundings { none, box, sky };

// The model as COLLADA. In the box, scenes/box_empty.dae, it stands on the floor, a metre wide or high; else it
// has its own size and place. `z_up` says which axis of the model is up.
std::string to_collada(const Model& model, Surroundings around, bool z_up);

}  // namespace pt
