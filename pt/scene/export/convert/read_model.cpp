#include "pt/error.h"
#include "pt/scene/export/convert/model.h"

#include <algorithm>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

namespace pt {

namespace {

Vec3 vec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }

// glTF has a base colour, the other formats a diffuse one.
Rgb albedo_of(const aiMaterial& material) {
  aiColor4D color(.5F, .5F, .5F, 1);
  if (material.Get(AI_MATKEY_BASE_COLOR, color) != aiReturn_SUCCESS) {
    material.Get(AI_MATKEY_COLOR_DIFFUSE, color);
  }
  const auto part = [](float value) { return value >= 0 ? std::min(1.0, double{value}) : 0.0; };
  return {part(color.r), part(color.g), part(color.b)};
}

void count_lost(const aiScene& scene, Model& model) {
  const auto count = [&](const char* what, std::size_t number) {
    if (number > 0) model.lost[what] += number;
  };
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
    const aiMaterial& material = *scene.mMaterials[i];
    std::size_t textures = 0;
    for (int type = aiTextureType_DIFFUSE; type <= AI_TEXTURE_TYPE_MAX; ++type) {
      textures += material.GetTextureCount(static_cast<aiTextureType>(type));
    }
    count("textures", textures);
    float opacity = 1;
    material.Get(AI_MATKEY_OPACITY, opacity);
    count("transparency of materials", opacity < 1 ? 1 : 0);
    aiColor4D glow(0, 0, 0, 1);
    material.Get(AI_MATKEY_COLOR_EMISSIVE, glow);
    count("emission of materials", glow.r + glow.g + glow.b > 0 ? 1 : 0);
  }
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    count("colours of vertices", scene.mMeshes[i]->HasVertexColors(0) ? 1 : 0);
    count("bones of meshes", scene.mMeshes[i]->HasBones() ? 1 : 0);
  }
  count("animations", scene.mNumAnimations);
  count("lights", scene.mNumLights);
  count("cameras", scene.mNumCameras);
}

// Meshes of points and lines have other faces than triangles.
void add_mesh(const aiMesh& from, const aiScene& scene, Model& model) {
  ModelMesh mesh;
  mesh.albedo = albedo_of(*scene.mMaterials[from.mMaterialIndex]);
  for (unsigned i = 0; i < from.mNumVertices; ++i) {
    mesh.p.push_back(vec3(from.mVertices[i]));
    if (from.HasNormals()) mesh.n.push_back(vec3(from.mNormals[i]));
  }
  // Where a normal is no number, the face's own is taken.
  for (Vec3& n : mesh.n) n = is_finite(n) ? n : Vec3{};
  for (unsigned i = 0; i < from.mNumFaces; ++i) {
    const aiFace& face = from.mFaces[i];
    if (face.mNumIndices != 3) {
      ++model.lost["points and lines"];
      continue;
    }
    const std::array<unsigned, 3> corners{face.mIndices[0], face.mIndices[1], face.mIndices[2]};
    const bool is_right = std::ranges::all_of(
        corners, [&](unsigned c) { return c < mesh.p.size() && is_finite(mesh.p[c]); });
    if (is_right) {
      mesh.faces.push_back(corners);
    } else {
      ++model.lost["faces with a corner that is not a number"];
    }
  }
  std::ranges::replace_if(
      mesh.p, [](Vec3 p) { return !is_finite(p); }, Vec3{});
  if (!mesh.faces.empty()) model.meshes.push_back(std::move(mesh));
}

}  // namespace

Model read_model(const std::filesystem::path& file) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(
      file.string(), aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                         aiProcess_PreTransformVertices | aiProcess_ValidateDataStructure);
  if (scene == nullptr) {
    throw Error("cannot read '" + file.string() + "': " + importer.GetErrorString());
  }
  Model model;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) add_mesh(*scene->mMeshes[i], *scene, model);
  if (model.meshes.empty()) throw Error("'" + file.string() + "' has no faces that can be shown");
  count_lost(*scene, model);
  return model;
}

}  // namespace pt
