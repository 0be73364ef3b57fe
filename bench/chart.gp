# gnuplot -e "folder='.'; type='svg'" bench/chart.gp: the cost of a ray against the number of
# triangles, from folder/bench_rays.csv to folder/bench_rays.svg (type 'png': .png).
set datafile separator ","
if (type eq 'svg') { set terminal svg size 800,560 background 'white' } else { set terminal pngcairo size 800,560 }
set output folder."/bench_rays.".type
set logscale xy
set xlabel "triangles"
set ylabel "nanoseconds a ray"
set key top left
set grid
rows(kind) = "< grep '^blob' ".folder."/bench_rays.csv | grep ',".kind.",'"
plot rows("bounce") using 2:4 with linespoints lt 1 lw 2 title "bounce, wide", \
     rows("bounce") using 2:5 with linespoints lt 1 lw 2 dt 2 title "bounce, Embree 3", \
     rows("shadow") using 2:4 with linespoints lt 2 lw 2 title "shadow, wide", \
     rows("shadow") using 2:5 with linespoints lt 2 lw 2 dt 2 title "shadow, Embree 3"
