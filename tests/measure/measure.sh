#!/usr/bin/env bash
# ./run measure: its known numbers, its report on code that crashes or never ends, and the calls that it refuses.
# measure.sh BUILD: the folder of the programs.
set -euo pipefail
# shellcheck source=tests/fixtures/shell.sh
. "$(dirname "${BASH_SOURCE[0]}")/../fixtures/shell.sh"
program=$1/measure/measure

# number FILE COLUMN PATTERN LOW HIGH: in matching lines, this column is between the two numbers.
number() {
  awk -F, -v name="$2" -v pattern="$3" -v low="$4" -v high="$5" '
    NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) column = i }
    $0 ~ pattern { found = 1; if (!($column != "" && $column >= low && $column <= high)) { bad = 1; print $0 } }
    END { exit !(found && !bad) }' "$1" || complain "$2 of '$3' is not from $4 to $5"
}

expect 2 "'hit_me' is neither a task nor a part" "$program" hit_me
expect 2 "there is no 'hit_sphere.mine'; of hit_sphere there are: " "$program" hit_sphere.mine
expect 2 "there is no 'hit_sphere.no_offset'" "$program" hit_sphere.no_offset
expect 2 '--from takes an implementation' "$program" --from theirs hit_sphere
expect 2 '--from takes an implementation' "$program" --from hit_me=student hit_sphere
expect 2 '--submission' "$program" --submission "$folder/nothing" hit_sphere
expect 2 'leave one out' "$program" --submission "$folder" --from student hit_sphere

# Somebody's code: one task crashes, one never ends, one does not compile, one is wrong, one is missing.
own=$folder/somebody
mkdir -p "$own"/{1_rays,2_bvh,3_direct}
cat >"$own/1_rays/hit_sphere.cpp" <<'END'
#include "pt/tasks/hit_sphere.h"
std::optional<pt::SurfaceHit> pt::hit_sphere(const Sphere&, const Ray&) {
  volatile int* nowhere = nullptr;
  *nowhere = 1;
  return {};
}
END
cat >"$own/1_rays/camera_ray.cpp" <<'END'
#include "pt/tasks/camera_ray.h"
pt::Ray pt::camera_ray(const Camera& camera, double, double) { return camera; }
END
sed 's/\/ samples/\/ (2.0 * samples)/' reference/1_rays/estimate_pixel.cpp >"$own/1_rays/estimate_pixel.cpp"
! cmp -s reference/1_rays/estimate_pixel.cpp "$own/1_rays/estimate_pixel.cpp" || complain 'the reference is not as it was'
cp student/3_direct/diffuse_bsdf.cpp "$own/3_direct"

expect 1 'somebody   ' "$program" hit_sphere.half_b --submission "$own" --seconds 1 --out "$folder/hit_sphere"
grep -q 'somebody .*it read or wrote memory that is not its own' "$folder/said" || complain "the crash is not named: $(cat "$folder/said")"
expect 1 'it does not compile: ' "$program" camera_ray.single_precision --submission "$own" --seconds 1 --out "$folder/camera_ray"
expect 1 'it is not written yet' "$program" 3.1 diffuse_bsdf.uniform --submission "$own" --seconds 1 --out "$folder/bsdf"
expect 1 'its mean is 0.' "$program" estimate_pixel.running_mean --submission "$own" --seconds 1 --out "$folder/pixel"
expect 1 'there is no 2_bvh/hit_box.cpp' "$program" hit_box.some_ulps_wider --submission "$own" --seconds 1

# The closed forms: right solutions have no mistake and only small errors.
expect 0 'hit_bvh' "$program" hit_triangle.watertight hit_box.inverse_direction hit_bvh.recursive_unordered direct_lights.stratified \
  trace_path.recursion adaptive_pixel.divides_by_n --seconds 6 --out "$folder/right"
right=$folder/right/measure.csv
[ "$(grep -c ',$' "$right")" -eq 18 ] || complain "right solutions are wrong, or rows are missing: $(cat "$right")"
number "$right" error_1 '^hit_(triangle|box)' 1e-17 1e-9
number "$right" error_2 '^hit_triangle' 1e-17 1e-6
number "$right" error_1 'watertight' 1e-17 1e-11
# There are 2302 triangles; without an order of children, more are tested.
number "$right" boxes '^hit_bvh,nearest hit,reference' 10 19
number "$right" boxes '^hit_bvh,nearest hit,recursive_unordered' 19 28
number "$right" primitives '^hit_bvh' 1 6
# Two lights, with one shadow ray per sample of each.
number "$right" rays '^direct_lights,1 sample,' 2 2
number "$right" rays '^direct_lights,16 samples,' 32 32
# 1.96 / .05 times the deviation over the mean, squared: 1 / .487 of .9 and sqrt(.43 .57), give 1286 samples.
number "$right" samples '^adaptive_pixel,an edge,' 1260 1310

# Double precision rounds at 1e-16, single precision at 6e-8; hard inputs may enlarge each error.
number "$folder/hit_sphere/measure.csv" error_1 reference 1e-17 1e-9
number "$folder/hit_sphere/measure.csv" error_3 half_b 1e-4 1
number "$folder/camera_ray/measure.csv" error_1 reference 1e-17 1e-15
number "$folder/camera_ray/measure.csv" error_1 single_precision 3e-8 1e-5
# Variances of 8192 calls or more have an error of 1.6 %; the limits are five times that.
# Cosine-weighted directions see the sky of the patches, .5 + .4 x + z^2, with the variance .16 / 4 + 1 / 12 = .123.
number "$folder/bsdf/measure.csv" variance reference .1134 .1332
# .43 of the pixel is 1, the rest .1, the mean .487: of 16 samples, .9^2 .43 .57 / 16 / .487^2 = .0523.
number "$folder/pixel/measure.csv" variance 'an edge,reference' .0481 .0565
number "$folder/pixel/measure.csv" mean 'an edge,running_mean' .99 1.01
number "$folder/pixel/measure.csv" mean 'an edge,somebody' .49 .51
grep -q ',somebody,0,' "$folder/pixel/measure.csv" || complain 'what is wrong is on the front'
! command -v gnuplot >/dev/null || [ -s "$folder/hit_sphere/hit_sphere.svg" ] || complain 'there is no chart'

finish
