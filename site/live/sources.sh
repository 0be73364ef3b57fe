# shellcheck shell=bash
# What the reference for pages is made of: for browsers (scripts/site.sh) and, to compare, for this machine (tests/site). To be
# sourced at the root.
live_sources=(site/live/*.cpp pt/{todo,file}.cpp pt/geometry/bvh_builder.cpp pt/scene/{light,recorder,scene,tracer}.cpp
  pt/accel/{binary_tree,collapse,kernel,wide_bvh,kernel_plain}.cpp pt/render/radiance_path.cpp)
for live_source in reference/*/*.cpp; do
  case $live_source in */hit_box.cpp | */hit_sphere.cpp) ;; *) live_sources+=("$live_source") ;; esac # in site/live/recorded.cpp
done
