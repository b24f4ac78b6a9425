# What the vector kernels buy, by stage of a step and number of particles.
# stages; data: stage, particles, and plain time / vector time
set datafile missing NaN
eval paper(1200, 560)
set multiplot layout 1,2 margins 0.075,0.985,0.235,0.88 spacing 0.08,0 \
  title 'Vector kernels and the plain core' font ',13'
eval room_about_data
eval legend(0.065)
set logscale xy
set xlabel 'particles'
set xtics (64, 256, 1024, 4096, 16384, 65536, 262144, 1048576)
colour(stage) = stage eq 'step' ? blue : stage eq 'build' ? red : stage eq 'query' ? green : pink
marker(stage) = stage eq 'step' ? 7 : stage eq 'build' ? 5 : stage eq 'query' ? 9 : 13
dash(kernels) = kernels eq 'plain' ? 2 : 1
here(stage, kernels) = is('stage', stage) && is('kernels', kernels) ? column('particles') : NaN
set ylabel 'time of the stage [us]'
plot for [stage in stages] for [kernels in 'vector plain'] table using (here(stage, kernels)):(1e6 * column('time_s')) \
       :(1e6 * column('time_lower_s')):(1e6 * column('time_upper_s')) with yerrorlines lw 1.5 ps 0.8 pt marker(stage) \
       dt dash(kernels) lc rgb colour(stage) notitle, \
     for [stage in stages] keyentry with points pt marker(stage) lc rgb colour(stage) title readable(stage), \
     for [kernels in 'vector plain'] keyentry with lines lw 1.5 dt dash(kernels) lc rgb grey title kernels
unset key
set ylabel 'plain time / vector time'
set yrange [0.5:*]
set ytics (0.5, 1, 2, 5, 10, 20, 50, 100)
plot for [stage in stages] data using (only(is('stage', stage), column('particles'))):(column('ratio')) \
       with linespoints lw 1.5 ps 0.8 pt marker(stage) lc rgb colour(stage), \
     1 with lines lc rgb grey dt 2
unset multiplot
