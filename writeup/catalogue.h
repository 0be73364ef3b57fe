#pragma once

#include "writeup/spec.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

// The figures of the write-up, read from figures.json. docs/writeup.md lists the fields.

namespace writeup {

// The source of a scene: the course's file if there is one here, else a scene of our own in its place.
struct SceneSource {
  std::string title;
  std::string course;             // below the folder of the course's scenes; may be empty
  std::string own;                // below the root of the project, or:
  std::string mesh;               // a kind of the generator, and
  int triangles = 0;              // of the mesh; of the other files, about so many
  bool room = false;              // around the mesh
  std::string camera = "course";  // of our own file: "file" where it is meant for the camera it has
};

// The colouring of a render's numbers.
enum class Look { radiance, rates, boxes, predicted };

struct Picture {
  std::string id, label;
  std::string scene;  // name in the catalogue
  Spec spec;          // in full quality; the scene's path is filled in later
  Look look = Look::radiance;
  bool in_bounces = false;  // from one render of all bounces, which other pictures share
  double exposure = 1;
  std::string mistake;  // rendered by the reference with this wrong solution in it; or "reference"
  std::string time_of;  // take so many samples that it takes as long as this picture
};

// A remedy, and what it is compared with: right solutions of a task, as ./run measure has them.
struct Price {
  std::string id, failure, task;
  std::string plain, remedy;  // names in right/, or "reference"
};

struct Figure {
  std::string id, part, title;
  std::string kind;     // "pictures", "speedup", or what is measured: see Plan::measurements()
  std::string source;   // as it stands in the file
  std::string file;     // of the handbook: where the picture is kept, below the project's root
  std::string caption;  // Markdown; may hold numbers
  bool flip = false;    // the pictures can be laid over each other
  bool small = false;   // few pixels, shown as squares
  std::vector<Picture> pictures;
  std::optional<Picture> golden;    // against which errors are measured
  std::vector<std::string> scenes;  // of a table
  double seconds = 0;               // by the clock, that a measurement may take
  double error = 0;                 // that is wanted
  std::string curve;                // of the kind "curve": "hit_sphere.far_away"
  double threshold = 0;             // of it: an error that is called a failure
  std::vector<std::string> lines;   // of it: those that the texts have numbers of
  std::vector<Price> prices;        // of the kind "prices"
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

// Throws pt::Error, with the figure's name, for what it cannot use.
Catalogue read_catalogue(const std::filesystem::path& file);

}  // namespace writeup
