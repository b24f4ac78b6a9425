# What a solve may leave: error by its tolerance, beside the error of the step.
eval paper(830, 470)
set title 'Solving to 1e-4 leaves far less than the step itself' font ',13'
set logscale xy
set format xy '10^{%T}'
set xlabel 'tolerance of a solve, part of its right side'
set ylabel 'error after half a second [mm]'
set xrange [5e-8:5e-1]
set key bottom right
colour(k) = word(blue.' '.green.' '.red, k)
here(side) = is('part', 'tolerance') && is('method', 'backward_euler_clamped') && column('side') == side
plot for [k=1:words(sides)] table using (only(here(word(sides, k) + 0), column('tolerance'))):(1e3 * column('solver_error_m')) \
       with linespoints lw 2 pt 7 lc rgb colour(k) title word(sides, k).' a side', \
     for [k=1:words(sides)] '' using (only(here(word(sides, k) + 0), column('tolerance'))):(1e3 * column('step_error_m')) \
       with lines lw 1.5 dt 2 lc rgb colour(k) notitle
