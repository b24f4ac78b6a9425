# How the time of an implicit step grows with the cloth.
eval paper(830, 470)
set title 'An implicit step in nearly linear time' font ',13'
set logscale xy
set format xy '10^{%T}'
set xlabel 'particles'
set ylabel 'CPU time of a step [ms]'
eval room_about_data
set key top left
here(time) = is('part', 'size') && column('time_s') == time
plot table using (only(here(0.2), column('side')**2)):(1e3 * column('cost_s')) \
       with linespoints lw 2 pt 7 lc rgb blue title 'falling', \
     '' using (only(here(1), column('side')**2)):(1e3 * column('cost_s')) \
       with linespoints lw 2 pt 5 lc rgb red title 'in folds', \
     [1e3:7e4] 1e3 / 60 with lines lw 1 dt 2 lc rgb grey title '60 frames a second'
