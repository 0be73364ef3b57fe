#include "pt/tasks/estimate_pixel.h"

#include "pt/todo.h"

namespace pt {

namespace {

// Helper functions of your own go here: nothing outside this file sees them.

}  // namespace

// TODO: average the radiance along `samples` camera rays through the pixel.
Rgb estimate_pixel(const View& view, int x, int y, int samples, Sampler& sampler) {
  todo("estimate_pixel");
  return {};
}

}  // namespace pt
