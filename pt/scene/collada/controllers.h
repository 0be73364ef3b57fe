#pragma once

#include "pt/math/transform.h"
#include "pt/scene/collada/document.h"

#include <optional>
#include <string>
#include <vector>

namespace pt {

// An animated mesh as it was when its skeleton was bound to it: the geometry, moved by `shape`.
struct BindPose {
  const XMLElement* geometry;
  Transform shape;
};

// The mesh of an <instance_controller>, below any number of skins and morphs. Their joints, weights
// and targets are ignored. Nothing if it is not in the file. Adds a note in both cases.
std::optional<BindPose> bind_pose(const ColladaDocument& document, const XMLElement& instance,
                                  std::vector<std::string>& notes);

}  // namespace pt
