# gnuplot -e "folder='docs/performance'" bench/chart.gp: draws the time of a ray against the number of
# triangles, from folder/rays.csv to folder/rays.svg.
set datafile separator ","
set datafile missing NaN
set terminal svg size 800,560 background 'white'
set output folder."/rays.svg"
set logscale xy
set xlabel "triangles"
set ylabel "nanoseconds per ray"
set key top left
set grid
of(kind, column) = stringcolumn(3) eq kind && strstrt(stringcolumn(1), "blob") == 1 ? column : NaN
csv = folder."/rays.csv"
plot csv using 2:(of("bounce", $4)) with linespoints lt 1 lw 2 title "bounce, wide", \
     csv using 2:(of("bounce", $5)) with linespoints lt 1 lw 2 dt 2 title "bounce, Embree 3", \
     csv using 2:(of("shadow", $4)) with linespoints lt 2 lw 2 title "shadow, wide", \
     csv using 2:(of("shadow", $5)) with linespoints lt 2 lw 2 dt 2 title "shadow, Embree 3", \
     csv using 2:(of("shadow x8", $4)) with linespoints lt 3 lw 2 title "shadow in groups of 8, wide"
