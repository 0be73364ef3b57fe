#pragma once

#include "writeup/catalogue.h"
#include "writeup/measurements.h"
#include "writeup/scenes.h"
#include "writeup/store.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace writeup {

enum class Quality { full, draft };

// The programs that make renders and measurements.
struct Codes {
  Code chosen;
  std::optional<Code> accuracy;          // the same, in the program that measures
  std::optional<Code> stability;         // the program that measures curves; hash by task
  std::optional<Code> measure;           // the program that takes the time of tasks
  std::optional<Code> view;              // the program that writes what the paths of a pixel did
  std::map<std::string, Code> others;    // submissions that are shown beside it, by label
  std::optional<Code> several;           // the program that measures all of them
  bool reference_rays = false;           // `chosen` traces with the reference's tasks
  std::map<std::string, Code> mistakes;  // by wrong solution; empty in the learners' edition
};

// The renders and measurements that make each figure.
class Plan {
 public:
  Plan(const Catalogue& catalogue, const Codes& codes, const Scenes& scenes, const Store& store,
       const Measurements& measured, Quality quality);

  // The renders whose sum is the picture. If the number of samples depends on unknown times, it is a
  // pilot render instead, which has to be made first.
  std::vector<Unit> units(const Figure& figure, const Picture& picture) const;

  // All renders of a figure that are known so far.
  std::vector<Unit> units(const Figure& figure) const;

  // The measurements for a figure: of the kind "converge", method against method in its scene; of the
  // kinds "needs", "left_out" and "scene_needs", the needs of each of its scenes; of the kind "curve",
  // all curves of its task, which other figures share; of the kind "prices", the time of right solutions;
  // of the kinds "path" and "ray", what the paths of a pixel did, as ./run view writes it.
  std::vector<Measurement> measurements(const Figure& figure) const;

  // Processor seconds of all renders and measurements, each once.
  double seconds(const Figure& figure) const;

  // The uniform render from which the rates of an adaptive picture are predicted.
  Unit uniform(const Picture& picture) const;

  // The settings of an adaptive picture, which are coarser in a draft.
  pt::AdaptiveSettings adaptive(const Picture& picture) const {
    return *unit(picture).spec.adaptive;
  }

  // A cell of a speed-up table: a scene and an engine, rendered in each turn from 0 to kTurns - 1.
  Unit cell(const std::string& scene, pt::Engine engine, int turn) const;

  // Returns whether the files of all its scenes are there; prepare() makes them.
  bool is_prepared(const Figure& figure) const;
  void prepare(const Figure& figure) const;

  // The reason why this edition cannot make the picture; empty if it can.
  std::string unavailable(const Picture& picture) const;

  Quality quality() const { return quality_; }
  const Store& store() const { return store_; }
  const Measurements& measured() const { return measured_; }
  const Scenes& scenes() const { return scenes_; }

 private:
  const Code& code_of(const Picture& picture) const;
  std::vector<Measurement> of_scenes(const Figure& figure) const;
  Measurement of_curve(const Figure& figure) const;
  std::vector<Measurement> of_prices(const Figure& figure) const;
  Measurement of_view(const Figure& figure) const;
  bool traces_as_reference(const Picture& picture) const;
  Unit unit(const Picture& picture) const;
  std::vector<Unit> in_bounces(const Unit& whole, const std::string& scene) const;
  Unit for_time_of(const Picture& target, Unit pilot) const;

  const Codes& codes_;
  const Scenes& scenes_;
  const Store& store_;
  const Measurements& measured_;
  Quality quality_;
  // The wanted bounces, by all other settings.
  std::map<std::string, std::vector<pt::BounceRange>> ranges_;
};

inline constexpr int kTurns = 3;
inline constexpr pt::Engine kEngines[] = {pt::Engine::linear, pt::Engine::task, pt::Engine::wide};

}  // namespace writeup
