# gnuplot -e "folder='.'; type='svg'" bench/verdict_power.gp: draws how many wrong pictures are found against
# the samples per pixel of the first round, from folder/verdict_power.csv to folder/verdict_power.svg (type
# 'png': .png).
set datafile separator ","
if (type eq 'svg') { set terminal svg size 1240,380 background 'white' } else { set terminal pngcairo size 1240,380 }
set output folder."/verdict_power.".type
set logscale x 2
set xrange [14:580]
set yrange [-5:105]
set xtics (16, 32, 64, 128, 256, 512)
set xlabel "samples per pixel in round 1"
set ylabel "found, %"
set grid
array Error[5] = ["1 % too bright", "10 % too dark in a 2 % block", "a shadow missing on 1 %", "indirect light 5 % low", "one bounce too few"]
array Spread[3] = ["diffuse", "fireflies", "mostly zero"]
rows(s, e) = "< grep '^".s.",".e.",' ".folder."/verdict_power.csv"
set multiplot layout 1,4
unset key
do for [s=1:3] {
  set title Spread[s]
  plot for [e=1:5] rows(Spread[s], Error[e]) using 3:(100 * $4) with linespoints lt (e < 5 ? e : 8) lw 2 pt e
}
# The fourth panel is the legend alone.
unset title; unset border; unset tics; unset xlabel; unset ylabel; unset grid
set lmargin 0
set key center left Left reverse samplen 2
plot for [e=1:5] NaN with linespoints lt (e < 5 ? e : 8) lw 2 pt e title Error[e]
unset multiplot
