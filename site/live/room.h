#pragma once

#include "pt/scene/view.h"

namespace site::live {

// The box with two spheres and a square lamp whose side has this length, between 0.02 and 1.8. The light of all lamps has the same power.
const pt::Scene& room(double lamp);

// A camera on a sphere around the middle of the room. Angles of 0 look in through the open side.
pt::Camera camera_at(double yaw, double pitch);

}  // namespace site::live
