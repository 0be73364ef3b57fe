#!/usr/bin/env python3
"""drawings.py [--check]: makes the drawings of the handbook, student/drawings/*.svg, or says which of them differ from what it
makes. They are computed from the formulas that they show."""
import os
import sys

sys.dont_write_bytecode = True
from drawn import light, paths, rays, trees  # noqa: E402

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../student/drawings")
DRAWINGS = (rays.pixel_samples, rays.camera_window, rays.barycentric, rays.sphere_quadratic, trees.tree, trees.slabs, trees.tree_walk,
            light.hemisphere, light.frames, light.acne, light.area_to_solid_angle, paths.path, paths.roulette, paths.interval)


def main():
    names, differing = {f"{make.__name__}.svg": make().svg() for make in DRAWINGS}, []
    for name, text in names.items():
        file = os.path.join(FOLDER, name)
        if "--check" not in sys.argv[1:]:
            os.makedirs(FOLDER, exist_ok=True)
            with open(file, "w", encoding="utf-8") as out:
                out.write(text)
        elif not os.path.exists(file) or open(file, encoding="utf-8").read() != text:
            differing.append(name)
    differing += [name for name in os.listdir(FOLDER) if name not in names]
    for name in differing:
        print(f"student/drawings/{name} is not what scripts/drawings.py makes: change the script, and call it")
    return len(differing) > 0


if __name__ == "__main__":
    sys.exit(main())
