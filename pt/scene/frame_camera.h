#pragma once

#include "pt/scene/camera.h"
#include "pt/scene/load_collada.h"

#include <string>

namespace pt {

// Chooses where the camera of a picture is and how much it sees.
//   course  the course's rule, to compare our pictures with theirs: only the direction is the
//           file's. The camera looks at the centre of the scene's bounding box from 1.5 times the
//           box's diagonal, y up. In a file that a program exported, the eye is in the direction
//           position - z axis, as in the course; else on the camera's own z axis. The fields of
//           view are widened to 4:3 (the narrower grows). A picture 600 pixels high shows them
//           whole, any other picture a window of that, pixel for pixel. A file that is not in the
//           course's dialect is framed as `file`.
//   fit     the same distance on the camera's own axis, with the file's whole field in the
//           picture's shape.
//   file    the file's own position, frame and clip range, and its whole field. If it sees no
//           surface from there, it is framed as `fit`.
// All pixels are square. A scene without a camera is seen from its front with the field of view of
// Blender's first camera (49.13 degrees, 4:3), whole, whatever the framing.
enum class Framing { course, fit, file };

// Says that the file's camera sees nothing, or which rule of `course` is used if the file does not
// name its author, or is not the course's; else empty.
std::string note_on_framing(const LoadedScene& loaded, Framing framing);

// width and height in pixels, > 0.
Camera frame_camera(const LoadedScene& loaded, Framing framing, int width, int height);

// The camera's ray through a point of the picture; x and y are in [0, 1], from the bottom left. It calls no task.
Ray look_through(const Camera& camera, double x, double y);

// Returns whether one of a grid of rays through the camera's field meets a surface between its clips.
bool sees_surfaces(const FileCamera& camera, const Primitives& primitives);

// Adds the point light of LightChoice::camera, if the scene was loaded for it: at the camera, so
// bright that a white surface facing it at the usual distance of what is seen has the radiance 1.
void add_camera_light(LoadedScene& loaded, const Camera& camera);

}  // namespace pt
