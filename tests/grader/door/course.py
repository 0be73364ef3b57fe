#!/usr/bin/env python3
"""course.py PROGRAMS [right | mistakes | doors]: grades clones of the look-alike of a course's skeleton. Right work has all points in
the dialect of its year (right_clones.py has the other years); what is handed out earns nothing; each mistake fails in its own task; messages name the learner's files."""
import json
import os
import re
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from clones import DIALECTS, PROGRAMS, broken, expect, finish, folder, grade, made  # noqa: E402


def right_work(years):
    for year in years:
        said, results = grade(made(f"right{year}", year))
        expect(results["passed"] and said.startswith(f"Judged by {DIALECTS[year]};"), f"right work of {year}", said[:3000])
        points = [(task["points"], task["max_points"]) for task in results["tasks"]]
        expect(len(points) == 12 and all(a == b for a, b in points), f"points of {year}", points)


def unwritten(years):
    for year in years:
        _, results = grade(made(f"unwritten{year}", year, unwritten=True))
        states = {(task["slug"], task["state"], task["points"]) for task in results["tasks"] if task["state"] != "not_attempted" or task["points"]}
        expect(not states and len(results["tasks"]) == 12, f"what is handed out in {year}", states)


# The task that fails, a promise that says so, the name that the mistake gets, and the edit. Those without a name break it in a way of which no known
# mistake is the only explanation.
MISTAKES = [
    ("camera_ray", "fills_the_field_of_view", "angle_not_halved",
     ("camera.cpp", "tan(hFov * PI / 360), h = tan(vFov * PI / 360)", "tan(hFov * PI / 180), h = tan(vFov * PI / 180)")),
    ("camera_ray", "keeps_the_clip_range", "clip_range_unset", ("camera.cpp", "  ray.min_t = nClip;\n  ray.max_t = fClip;\n", "")),
    ("hit_triangle", "interpolates_the_corner_normals", "weights_exchanged", ("triangle.cpp", "n2 * u + n3 * v", "n3 * u + n2 * v")),
    ("hit_triangle", "misses_outside", "sum_of_weights_unchecked", ("triangle.cpp", "v >= 0 && u + v <= 1 &&", "v >= 0 &&")),
    ("hit_triangle", "keeps_t_inside_the_ray", "only_in_front", ("triangle.cpp", "&& t >= r.min_t && t <= r.max_t", "&& t >= 0")),
    ("hit_sphere", "hits_from_inside", "near_root_only", ("sphere.cpp", "t1 >= r.min_t ? t1 : t2;", "t1;")),
    ("hit_sphere", "returns_the_outward_unit_normal", "normal_inwards", ("sphere.cpp", "(r.at_time(t) - o).unit()", "(o - r.at_time(t)).unit()")),
    ("build_bvh", "keeps_leaves_small", "", ("bvh.cpp", "<= max_leaf_size", "<= 2 * max_leaf_size")),
    ("build_bvh", "separates_along_the_longest_axis", "axis_by_position",
     ("bvh.cpp", "if (centroids.extent[i] > centroids.extent[axis])", "if (centroids.centroid()[i] > centroids.centroid()[axis])")),
    ("hit_box", "misses_beside_the_box", "", ("bbox.cpp", "if (enters > leaves) return false;", "")),
    ("hit_bvh", "finds_the_nearest_hit", "", ("bvh.cpp", "hit = (*p)->intersect(r, i) || hit;", "hit = hit || (*p)->intersect(r, i);")),
    ("hit_bvh", "finds_any_hit", "both_children_must_hit",
     ("bvh.cpp", "return has_intersection(ray, node->l) || has", "return has_intersection(ray, node->l) && has")),
    ("diffuse_bsdf", "f_reflects_the_albedo", "f_without_pi", ("bsdf.cpp", "reflectance * (1 / PI)", "reflectance")),
    ("diffuse_bsdf", "samples_estimate_the_albedo", "sample_f_with_cosine", ("bsdf.cpp", "return f(wo, *wi);", "return f(wo, *wi) * wi->z;")),
    ("direct_hemisphere", "sees_a_light_of_known_size", "half_of_f, pdf_of_half_the_hemisphere", ("pathtracer.cpp", "w_in.z * 2 * PI", "w_in.z * PI")),
    ("direct_lights", "is_not_hidden_by_the_light_itself", "unbounded_shadow_ray", ("pathtracer.cpp", "ray.max_t = distance - EPS_F;", "")),
    ("trace_path", "matches_the_furnace", "not_divided", ("pathtracer.cpp", "w_in.z / pdf / goes_on", "w_in.z / pdf")),
    ("trace_path", "takes_the_first_bounce_always", "roulette_on_the_first_bounce", ("pathtracer.cpp", "r.depth == max_ray_depth ? 1 : 0.7", "0.7")),
    ("adaptive_pixel", "stops_where_the_interval_is_narrow", "", ("pathtracer.cpp", "1.96", "2.96")),
    ("estimate_pixel", "covers_the_whole_pixel", "", ("pathtracer.cpp", "(x + in_pixel.x)", "(x + 0.9 * in_pixel.x)")),
]
# A mistake in raytrace_pixel is one in both tasks.
SHARED = {"estimate_pixel": {"adaptive_pixel"}}
IN_PATHTRACER = ["estimate_pixel", "direct_hemisphere", "direct_lights", "trace_path", "adaptive_pixel"]


def mistakes():
    for number, (slug, promise, name, edit) in enumerate(MISTAKES):
        # The texts of the other tasks are those of right work. Every third is judged in all tasks of its file.
        others = IN_PATHTRACER if edit[0] == "pathtracer.cpp" and number % 3 == 0 else [slug, *SHARED.get(slug, [])]
        said, results = grade(made(f"wrong{number}", 2022, edits=[edit]), *others)
        failing = {task["slug"]: broken(task) for task in results["tasks"] if task["state"] not in ("pass", "blocked")}
        expect(promise in failing.get(slug, []) and set(failing) <= {slug} | SHARED.get(slug, set()), f"{slug}, {edit}", failing)
        named = {task["slug"]: task["mistake"]["name"] for task in results["tasks"] if task["mistake"].get("name")}
        expect(named == ({slug: name} if name else {}), f"the name of {edit}", named)
        expect("your " in said and "::" in said, f"the learner's name in {slug}", said[:500])


# What only this door can see. The year, the task, what is broken of it, and the edits: one cause costs one promise.
VARIANCE = "std::max(0.0, (s2 - s1 * s1 / n) / (n - 1))"
SAMPLE = "const Vector3D sample = est_radiance_global_illumination(ray);"
JITTER = "Vector2D in_pixel = gridSampler->get_sample();"
FROM_A_TABLE = "static std::vector<Vector2D> table; while (table.size() < 256) table.push_back(gridSampler->get_sample()); Vector2D in_pixel = table[n % 256];"
ADDS = "if (accumulates || r.depth == 1) sum +="
EITHER_CHILD = "node->l->bb.intersect(r, l0, l1), right = node->r->bb.intersect(r, r0, r1);"
SEEN_HERE = [
    (2022, "hit_triangle", ["has_intersection_agrees_with_intersect"], [("triangle.cpp", "return test(r, t, u, v);", "return test(r, t, u, v) && u > 0.5;")]),
    (2019, "hit_sphere", ["has_intersection_agrees_with_intersect"], [("sphere.cpp", "bool Sphere::intersect(const Ray& r) const {", "bool Sphere::intersect(const Ray& r) const { if (r.min_t > 0) return false;")]),
    (2023, "trace_path", ["shows_one_bounce_alone"], [("pathtracer.cpp", ADDS, "sum +=")]),
    (2023, "trace_path", ["shows_one_bounce_alone"], [("pathtracer.cpp", ADDS, "if (accumulates || r.depth == max_ray_depth) sum +=")]),
    (2022, "estimate_pixel", ["traces_each_ray_once"], [("pathtracer.cpp", SAMPLE, "est_radiance_global_illumination(ray); " + SAMPLE)]),
    (2022, "adaptive_pixel", [], [("pathtracer.cpp", SAMPLE, "est_radiance_global_illumination(ray); " + SAMPLE)]),
    (2022, "estimate_pixel", ["covers_the_whole_pixel"], [("pathtracer.cpp", JITTER, FROM_A_TABLE)]),
    (2022, "adaptive_pixel", ["covers_the_whole_pixel"], [("pathtracer.cpp", JITTER, FROM_A_TABLE)]),
    (2022, "adaptive_pixel", [], [("pathtracer.cpp", VARIANCE, "(s2 - s1 * s1 / n) / (n - 1)")]),
    (2022, "hit_bvh", [], [("bbox.cpp", "  t0 = enters;\n  t1 = leaves;\n", ""),
                           ("bvh.cpp", "double l0, l1, r0, r1;", "double l0 = r.min_t, r0 = r.min_t;"),
                           ("bvh.cpp", EITHER_CHILD, re.sub("[lr][01]", lambda found: "r.max_t" if found.group()[1] == "1" else "r.min_t", EITHER_CHILD))]),
]
BONUS = {"adaptive_pixel": "stops_where_all_samples_are_equal_bonus", "hit_bvh": "works_with_any_box_bonus"}


def seen_here():
    for number, (year, slug, lost, edits) in enumerate(SEEN_HERE):
        said, results = grade(made(f"seen{number}", year, edits=edits), slug)
        task = results["tasks"][0]
        expect(broken(task) == lost and task["points"] == task["max_points"] - len(lost) and not task["printed"], f"{slug}, {edits[0][2]}", said)
        names = [promise["name"] for promise in task["promises"] if not promise["held"]]
        expect(lost or BONUS[slug] in names or "est_radiance" in edits[0][2], f"the bonus of {slug}", names)
        expect("table" not in edits[0][2] or "other generator" in task["mistake"]["sentence"], f"the name of the table in {slug}", task["mistake"])
    _, results = grade(made("no_fallback", 2022, edits=[("bvh.cpp", "  if (cut == start || cut == end) cut = start + (end - start) / 2;\n", "")]), "build_bvh")
    task = results["tasks"][0]
    expect(len(broken(task)) > 4 and task["points"] == task["max_points"] - 1, "equal centroids", (task["points"], broken(task)))
    # Whoever prints our lines loses promises, and gains none.
    forged = [("pathtracer.cpp", "1.96", "(fprintf(stderr, \"not kept: jitter_from_a_table: forged\\n\") > 0 ? 2.96 : 1.96)")]
    _, honest = grade(made("honest", 2022, edits=[("pathtracer.cpp", "1.96", "2.96")]), "adaptive_pixel")
    _, results = grade(made("forged", 2022, edits=forged), "adaptive_pixel")
    expect(verdicts(results) == verdicts(honest), "forged lines", verdicts(results))


def messages():
    clone = made("misspelt", 2022, edits=[("bbox.cpp", "t0 = enters;", "t0 = enter;")])
    with open(clone + "/src/scene/bbox.cpp", encoding="utf-8") as file:
        line = 1 + [line.strip() for line in file].index("t0 = enter;")
    _, results = grade(clone, "hit_box")
    expect(results["tasks"][0]["compiler_output"].startswith(f"src/scene/bbox.cpp:{line}:"), "the file and line", results["tasks"][0])
    other = made("other_tree", 2022)
    for name in ("bvh.h", "bvh.cpp"):
        with open(f"{other}/src/scene/{name}", "r+", encoding="utf-8") as file:
            text = re.sub(r"\bbb\b", "bounds", file.read())
            file.seek(0)
            file.write(text)
    _, results = grade(other, "build_bvh", "hit_box")
    said = {task["slug"]: (task["state"], task["reason"]) for task in results["tasks"]}
    expect(said == {"build_bvh": ("rejected", "not judged: BVHNode is not the course's"), "hit_box": ("pass", "")}, "another tree", said)


def packed():
    """A clone in an archive, in a folder with other files, or in a class has the verdicts of the clone."""
    clone = made("packed", 2020, edits=[("bbox.cpp", "if (enters > leaves) return false;", "")])
    _, plain = grade(clone, "2")
    klass = os.path.join(folder.name, "class")
    os.makedirs(klass + "/Bob/mine")
    shutil.copytree(clone, klass + "/Ada")
    shutil.copytree(clone, klass + "/Bob/mine/p1")
    for name, form in ("Cem", "zip"), ("Dia", "gztar"):
        shutil.make_archive(f"{klass}/{name}", form, folder.name, "packed")
    for name in ("Bob", "Cem.zip", "Dia.tar.gz"):
        _, results = grade(f"{klass}/{name}", "2")
        expect(verdicts(results) == verdicts(plain), name, verdicts(results))
    made("class/Eve", 2022)
    run = subprocess.run([PROGRAMS + "/grade_class", klass, "--out", klass + "-out", "--not-isolated", "--", "--no-pictures", "2"],
                         capture_output=True, text=True, check=False)
    expect(run.returncode == 0, "grade-class", run.stdout + run.stderr)
    for name in ("Ada", "Bob", "Cem", "Dia", "Eve"):
        with open(f"{klass}-out/{name}.json", encoding="utf-8") as file:
            results = json.load(file)
        year = 2022 if name == "Eve" else 2020
        expect(results["dialect"] == DIALECTS[year], f"the dialect of {name}", results["dialect"])
        expect((verdicts(results) == verdicts(plain)) != (name == "Eve"), f"{name} in a class", verdicts(results))


def verdicts(results):
    return [(task["slug"], task["state"], task["points"], broken(task)) for task in results["tasks"]]


if sys.argv[2] == "right":
    right_work([2023])
    unwritten([2019, 2020, 2023])
elif sys.argv[2] == "doors":
    packed()
else:
    mistakes()
    seen_here()
    messages()
finish()
