#include "pt/tasks/adaptive_pixel.h"

#include "pt/render/radiance.h"
#include "pt/tasks/camera_ray.h"
#include "pt/todo.h"

namespace pt {

namespace {

// Helper functions of your own go here: nothing outside this file sees them.

}  // namespace

// TODO: take samples a batch at a time until their mean is known well enough.
PixelEstimate adaptive_pixel(const View& view, int x, int y, const AdaptiveSettings& settings,
                             Sampler& sampler) {
  todo("adaptive_pixel");
  return {{}, settings.batch};
}

}  // namespace pt
