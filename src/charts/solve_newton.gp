# What a second Newton step buys: error against cost.
eval paper(830, 470)
set title 'At 1/60 s, a second Newton step is worth more than steps of half the length' font ',13'
set logscale xy
set format xy '%g'
set xlabel 'error after half a second [mm]'
set ylabel 'CPU time of a simulated second [s]'
eval room_about_data
set key bottom left
colour(k) = word(blue.' '.green.' '.red, k)
here(method, steps) = is('part', 'newton') && is('method', method) && column('newton_steps') == steps
plot for [k=1:words(methods)] table using (only(here(word(methods, k), 1), 1e3 * column('step_error_m'))):(column('cost_s') / column('step_s')) \
       with linespoints lw 2 pt 6 dt 2 lc rgb colour(k) title readable(word(methods, k)).', one', \
     for [k=1:words(methods)] '' using (only(here(word(methods, k), 2), 1e3 * column('step_error_m'))):(column('cost_s') / column('step_s')) \
       with linespoints lw 2 pt 7 lc rgb colour(k) title readable(word(methods, k)).', two'
