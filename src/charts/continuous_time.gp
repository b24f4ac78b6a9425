# Times of discrete and continuous detection, against the number of particles.
# detections: what was measured
set datafile missing NaN
eval paper(1000, 520)
set multiplot layout 1,2 margins 0.085,0.985,0.215,0.88 spacing 0.09,0 \
  title 'Discrete and continuous detection' font ',13'
eval room_about_data
eval legend(0.05)
set logscale xy
set xlabel 'particles'
set xtics (256, 1024, 4096, 16384, 65536, 262144)
colour(detection) = detection eq 'discrete' ? blue : red
marker(detection) = detection eq 'discrete' ? 7 : 5
here(detection) = is('part', 'time') && is('detection', detection) ? column('particles') : NaN
do for [stage in 'build search'] {
  set ylabel stage.' [us]'
  plot for [detection in detections] table using (here(detection)):(1e6 * column(stage.'_s')) \
         :(1e6 * column(stage.'_lower_s')):(1e6 * column(stage.'_upper_s')) with yerrorlines lw 1.5 ps 0.8 \
         pt marker(detection) lc rgb colour(detection) title detection
  unset key
}
unset multiplot
