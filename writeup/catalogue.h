#pragma once

#include "measure/renders/spec.h"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

// The figures of the write-up, read from figures.json. docs/writeup.md lists the fields.

namespace writeup {

// The source of a scene: the course's file if it is here, otherwise a scene of our own in its place.
struct SceneSource {
  std::string title;
  std::string course;             // below the folder of the course's scenes; may be empty
  std::string own;                // below the root of the project; if empty, a mesh:
  std::string mesh;               // its kind, for the generator
  int triangles = 0;              // of the mesh; of a file, about this many
  bool room = false;              // whether a room is around the mesh
  std::string camera = "course";  // for our own file: "file" if it has its own camera
};

// A render is shown as its light, or as a number of each pixel in colours. `error` is the distance from the goldens, as a
// part of the pixel's brightness.
enum class Look { radiance, rates, boxes, predicted, error };

// A part of a picture: from the left and from the top, its width and its height, all as parts of the picture's.
struct Crop {
  double left = 0, top = 0, width = 1, height = 1;
};

// In place of a mistake: rendered by the reference, whoever is written about.
inline constexpr const char* kReference = "reference";

struct Picture {
  std::string id, label;
  std::string scene;   // name in the catalogue
  measure::Spec spec;  // in full quality; the scene's path is filled in later
  Look look = Look::radiance;
  std::optional<Crop> crop;  // only this part is shown and judged
  bool in_bounces = false;   // from one render of all bounces, which other pictures share
  double exposure = 1;
  std::string mistake;  // rendered by the reference with this wrong solution in it; or kReference
  bool golden = false;  // errors are measured against it, also in a draft
  std::string time_of;  // take as many samples as fit into this picture's time
};

// A remedy, and the plain way that it is compared with: right solutions of a task, as in ./run measure.
struct Price {
  std::string id, failure, task;
  std::string plain, remedy;  // names in right/, or "reference"
};

struct Figure {
  std::string id, part, title;
  std::string kind;     // "pictures", "speedup", or a measurement: see Plan::measurements()
  std::string source;   // its text in the file
  std::string file;     // for the handbook: the picture's path below the project's root
  std::string caption;  // Markdown; may hold numbers
  bool flip = false;    // the pictures can be laid over each other
  bool small = false;   // few pixels, shown as squares
  std::vector<Picture> pictures;
  std::vector<Picture> goldens;  // none, or two that errors are measured against; by the reference
  std::vector<std::string> scenes;  // of a table
  double seconds = 0;               // wall time that a measurement may take
  double error = 0;                 // the wanted error
  std::string curve;                // for the kind "curve": "hit_sphere.far_away"
  double threshold = 0;             // of the curve: larger errors are failures
  std::vector<std::string> lines;   // of the curve: lines whose numbers are in texts
  std::vector<Price> prices;        // for the kind "prices"
  std::array<int, 2> pixel{};       // for the kinds "path" and "ray": x and y, as in ./run view,
  std::array<int, 2> size{};        // in a picture of this size
};

// The task of a figure that is a curve.
inline std::string task_of(const Figure& figure) {
  return figure.curve.substr(0, figure.curve.find('.'));
}

struct Catalogue {
  std::map<std::string, SceneSource> scenes;
  std::vector<Figure> figures;

  const Figure* find(const std::string& id) const;
};

// The name of a submission's code in Picture::mistake. No mistake is called that.
inline std::string other_code(const std::string& label) { return "by " + label; }

// Each picture that is rendered by the code that is written about is there once more by each of these submissions.
void add_codes(Catalogue& catalogue, const std::vector<std::string>& labels);

// Throws pt::Error with the figure's name for anything that it cannot use.
Catalogue read_catalogue(const std::filesystem::path& file);

}  // namespace writeup
