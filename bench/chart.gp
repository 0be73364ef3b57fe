# gnuplot -e "folder='build/bench'" bench/chart.gp: the cost of a ray against the number of triangles,
# from folder/bench_rays.csv to folder/bench_rays.svg (and .png).
set datafile separator ","
set logscale xy
set xlabel "triangles"
set ylabel "nanoseconds a ray"
set key top left
set grid
set yrange [10:2000]
rows(kind, column) = sprintf("< grep '^blob' %s/bench_rays.csv | grep ',%s,' | cut -d, -f2,%d", folder, kind, column)
do for [type in "svg png"] {
  set terminal type eq "svg" ? "svg" : "pngcairo"
}
