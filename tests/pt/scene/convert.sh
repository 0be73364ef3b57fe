#!/usr/bin/env bash
# convert.sh BUILD: models in other formats become scenes of as many triangles, which stand in the box, and what is lost is said.
. "$(dirname "${BASH_SOURCE[0]}")/../../fixtures/shell.sh"
build=$1
convert=$build/pt/convert render=$build/pt/render
# convert says itself that the library has crashed, also in a build with sanitizers.
export ASAN_OPTIONS=handle_segv=0:handle_sigbus=0:handle_abort=0:handle_sigfpe=0:handle_sigill=0

# A tetrahedron with corners at 0 and 10 along each axis, in four formats.
cat >"$folder/t.obj" <<'END'
mtllib t.mtl
v 0 0 0
v 10 0 0
v 0 10 0
v 0 0 10
usemtl red
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
END
printf 'newmtl red\nKd 1 0 0\nmap_Kd red.png\n' >"$folder/t.mtl"
cat >"$folder/t.ply" <<'END'
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 4
property list uchar int vertex_indices
end_header
0 0 0
10 0 0
0 10 0
0 0 10
3 0 2 1
3 0 1 3
3 0 3 2
3 1 2 3
END
{
  echo 'solid t'
  for face in '0 0 0 0 10 0 10 0 0' '0 0 0 10 0 0 0 0 10' '0 0 0 0 0 10 0 10 0' '10 0 0 0 10 0 0 0 10'; do
    # shellcheck disable=SC2086 # nine numbers
    printf 'facet normal 0 0 0\nouter loop\nvertex %s %s %s\nvertex %s %s %s\nvertex %s %s %s\nendloop\nendfacet\n' $face
  done
  echo 'endsolid t'
} >"$folder/t.stl"

for format in obj ply stl; do
  expect 0 '4 triangles' "$convert" "$folder/t.$format" "$folder/$format.dae"
  expect 0 '4 primitives' "$render" "$folder/$format.dae" -f "$folder/$format.png" -s 4 -r 24 18
  # The empty box has five walls and a panel.
  expect 0 'wrote' "$convert" "$folder/t.$format" "$folder/box.dae" --box
  expect 0 '16 primitives' "$render" "$folder/box.dae" -f "$folder/box.png" -s 4 -r 24 18
  expect 0 'wrote' "$convert" "$folder/t.$format" "$folder/sky.dae" --sky --up z
  expect 0 '1 lights' "$render" "$folder/sky.dae" -f "$folder/sky.png" -s 4 -r 24 18
  ! grep -q 'no light' "$folder/said" || complain "the sky is not in sky.dae"
  expect 2 './run convert' "$render" "$folder/t.$format" -f "$folder/no.png"
done
expect 0 'not kept: textures (1)' "$convert" "$folder/t.obj" "$folder/obj.dae"
grep -q '<color>1 0 0 1</color>' "$folder/obj.dae" || complain "the colour of t.mtl is not in obj.dae"

# A bad input leaves no file.
echo 'v 0 0 0' >"$folder/none.obj"
head -c 3000 /dev/urandom >"$folder/noise.glb"
for bad in none.obj noise.glb; do
  expect 2 '' "$convert" "$folder/$bad" "$folder/bad.dae"
done
# Assimp of Debian 12 crashes on a header that is cut.
printf 'ply\nformat binary_little_endian 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty \0\0\0\t\a\0\0\0' >"$folder/cut.ply"
expect 2 'cannot read' "$convert" "$folder/cut.ply" "$folder/bad.dae"
expect 2 'has to end in .dae' "$convert" "$folder/t.obj" "$folder/bad.xml"
[ ! -e "$folder/bad.dae" ] || complain "bad.dae was written"
finish
