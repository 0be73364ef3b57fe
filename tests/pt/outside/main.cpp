// outside SCENE.dae PICTURE.png: renders a scene with 16 samples per pixel and at most five bounces.
#include "pt/error.h"
#include "pt/image/image_io.h"
#include "pt/render/render_film.h"
#include "pt/scene/frame_camera.h"
#include "pt/scene/load_collada.h"

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("write: outside SCENE.dae PICTURE.png\n", stderr);
    return 2;
  }
  try {
    pt::LoadedScene loaded = pt::load_collada(argv[1]);
    pt::require_supported(loaded, argv[1]);
    loaded.scene.tracer = pt::Tracer(pt::Engine::wide, loaded.scene.primitives);
    const int width = 80, height = 60;
    const pt::Camera camera = pt::frame_camera(loaded, pt::Framing::fit, width, height);
    const pt::View view{loaded.scene, camera, {.to = 5}, width, height};
    pt::RenderSettings settings;
    settings.samples = 16;
    pt::write_image(argv[2], pt::render_film(view, settings).film);
  } catch (const pt::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
