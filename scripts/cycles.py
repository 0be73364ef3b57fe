# Renders a scene with Blender's Cycles, for ./run judge:
#     blender --background --factory-startup --python scripts/cycles.py -- {scene} {samples} {seed} {out}
# {scene} is what ./run export --to blender writes. World coordinates are used as they are, with y up: nothing here depends on Blender's own
# up direction. Cycles has no spheres: an icosahedron whose triangles are cut into 4^6 each stands for one.
import array
import json
import math
import sys

import bmesh
import bpy
from mathutils import Matrix, Vector

SPHERE_LEVEL = 7
FARTHEST = 1e5  # for a camera whose view has no end


def material_of(described):
    """Diffuse on both sides; emits on the side from which corners run anticlockwise."""
    material = bpy.data.materials.new(described["name"])
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (*described["albedo"], 1)
    diffuse.inputs["Roughness"].default_value = 0  # Lambert's law
    surface = diffuse.outputs["BSDF"]
    radiance = max(described["emission"])
    if radiance > 0:
        emission = nodes.new("ShaderNodeEmission")
        emission.inputs["Color"].default_value = (*[e / radiance for e in described["emission"]], 1)
        emission.inputs["Strength"].default_value = radiance
        front = nodes.new("ShaderNodeAddShader")
        links.new(emission.outputs["Emission"], front.inputs[0])
        links.new(diffuse.outputs["BSDF"], front.inputs[1])
        side = nodes.new("ShaderNodeMixShader")
        links.new(nodes.new("ShaderNodeNewGeometry").outputs["Backfacing"], side.inputs["Fac"])
        links.new(front.outputs["Shader"], side.inputs[1])
        links.new(diffuse.outputs["BSDF"], side.inputs[2])
        surface = side.outputs["Shader"]
    links.new(surface, output.inputs["Surface"])
    material.cycles.sample_as_light = True
    return material


def add_object(mesh, material):
    mesh.materials.append(material)
    thing = bpy.data.objects.new(mesh.name, mesh)
    # Cycles moves shading points of smooth surfaces away from their triangles; we do not.
    thing.cycles.shadow_terminator_offset = 0
    thing.cycles.shadow_terminator_geometry_offset = 0
    bpy.context.scene.collection.objects.link(thing)


def add_triangles(group, material):
    """Triangles that share no corner, so that each has its own normals."""
    corners = array.array("f", group["corners"])
    count = len(corners) // 3
    mesh = bpy.data.meshes.new("triangles")
    mesh.vertices.add(count)
    mesh.vertices.foreach_set("co", corners)
    mesh.loops.add(count)
    mesh.loops.foreach_set("vertex_index", array.array("i", range(count)))
    mesh.polygons.add(count // 3)
    mesh.polygons.foreach_set("loop_start", array.array("i", range(0, count, 3)))
    mesh.polygons.foreach_set("loop_total", array.array("i", [3] * (count // 3)))
    smooth = "normals" in group
    mesh.polygons.foreach_set("use_smooth", [smooth] * (count // 3))
    mesh.update(calc_edges=True)
    if smooth:
        n = group["normals"]
        mesh.use_auto_smooth = True
        mesh.normals_split_custom_set([n[i : i + 3] for i in range(0, len(n), 3)])
    add_object(mesh, material)


def add_sphere(sphere, level, material):
    """An icosahedron, each of its triangles cut into 4^(level - 1), all corners on the sphere; smooth normals."""
    mesh = bpy.data.meshes.new("sphere")
    shape = bmesh.new()
    bmesh.ops.create_icosphere(shape, subdivisions=level, radius=sphere["radius"],
                               matrix=Matrix.Translation(sphere["center"]))
    shape.to_mesh(mesh)
    shape.free()
    mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    add_object(mesh, material)


def turned(z, y):
    """The matrix of a lamp, which shines along its -z: its z axis is z, and its y axis is y made perpendicular to z."""
    z = Vector(z).normalized()
    x = Vector(y).cross(z).normalized()
    return Matrix((x, z.cross(x), z)).transposed().to_4x4()


def add_lamp(described):
    """A light without a surface. A point of P watts sends P / (4 pi) in every direction."""
    kind = described["kind"]
    data = bpy.data.lights.new(kind, {"point": "POINT", "directional": "SUN"}[kind])
    if kind == "point":
        data.shadow_soft_size = 0
        color, watts = described["intensity"], 4 * math.pi
        place = Matrix.Translation(described["position"])
    else:
        data.angle = 0
        color, watts = described["irradiance"], 1
        z = [-x for x in described["direction"]]
        place = turned(z, (1, 0, 0) if abs(z[0]) < 0.9 else (0, 1, 0))
    data.color = [c / max(color) for c in color]
    data.energy = watts * max(color)
    lamp = bpy.data.objects.new(kind, data)
    lamp.matrix_world = place
    bpy.context.scene.collection.objects.link(lamp)


def add_camera(described, width, height):
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "HORIZONTAL"
    data.angle = described["hfov"]
    data.clip_start = max(described["near"], 1e-4)
    data.clip_end = min(described["far"], FARTHEST)
    camera = bpy.data.objects.new("camera", data)
    x, y, z = (Vector(axis) for axis in described["frame"])
    camera.matrix_world = (Matrix.Translation(described["position"])
                           @ Matrix((x, y, z)).transposed().to_4x4())
    scene = bpy.context.scene
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.render.resolution_percentage = 100


def settings(described):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.use_denoising = False
    cycles.use_adaptive_sampling = False
    cycles.light_sampling_threshold = 0  # no lamp is left out because it is dim
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.use_fast_gi = False
    cycles.use_auto_tile = False
    cycles.blur_glossy = 0
    # With the default pattern of Blender 3.4 a wall came out 0.2 % darker than with this one.
    cycles.sampling_pattern = "SOBOL"
    cycles.pixel_filter_type = "BOX"  # the pixel's own square
    # Blender does not count direct light as a bounce.
    cycles.max_bounces = cycles.diffuse_bounces = described["bounces"] - 1
    cycles.min_light_bounces = 0  # Russian roulette from the first bounce on
    # Radiance as it is, in floats.
    scene.view_settings.view_transform = "Standard"
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.image_settings.exr_codec = "ZIP"
    scene.render.use_compositing = scene.render.use_sequencer = False
    scene.world = bpy.data.worlds.new("nothing")
    scene.world.color = (0, 0, 0)


def build(described):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    settings(described)
    materials = [material_of(each) for each in described["materials"]]
    for group in described["triangles"]:
        add_triangles(group, materials[group["material"]])
    for sphere in described["spheres"]:
        add_sphere(sphere, SPHERE_LEVEL, materials[sphere["material"]])
    for lamp in described["lamps"]:
        add_lamp(lamp)
    add_camera(described["camera"], described["width"], described["height"])


def main():
    file, samples, seed, picture = sys.argv[sys.argv.index("--") + 1 :]
    with open(file) as text:
        build(json.load(text))
    scene = bpy.context.scene
    scene.cycles.samples = int(samples)
    scene.cycles.seed = int(seed)
    bpy.ops.render.render()
    bpy.data.images["Render Result"].save_render(picture, scene=scene)


main()
