# caption: How far a sheet is from where solves to 1e-9 take it in half a second of backward Euler at 1/60 s, by the
# caption: tolerance of the solves; dashed, the error of the step itself.
eval paper(430)
eval frame(65, 190, 55, 70)
set logscale xy
set format xy '10^{%T}'
set xlabel 'tolerance of a solve, relative to the right-hand side'
set ylabel 'error after half a second [mm]'
set xrange [5e-8:2e-1]
colour(k) = word(blue.' '.green.' '.red, k)
here(side) = is('part', 'tolerance') && is('method', 'backward_euler_clamped') && column('side') == side
solved = "(1e3 * column('solver_error_m'))"
by_step = "(1e3 * column('step_error_m'))"
# At the default tolerance, what solves leave over what steps do
share = 0
stats table using (is('part', 'tolerance') && is('method', 'backward_euler_clamped') && abs(column('tolerance') - 1e-4) < 1e-6 ? \
  (share = most(share, column('solver_error_m') / column('step_error_m')), 0) : 0) nooutput
eval headline(sprintf('Solved to 10^{-4} , the error is at most %.2g %% of what the step itself leaves', 100 * share), \
  'Backward Euler at 1/60 s. Solid: distance from solves to 10^{-9} ; dashed: distance from a sixteenth of the step')
eval forget
do for [k = 1:words(sides)] {
  side = word(sides, k) + 0
  stats table using (last(k, here(side), column('tolerance'), @solved)) nooutput
}
stats table using (first(12, here(word(sides, 1) + 0), column('tolerance'), @by_step)) nooutput
eval spread(0.4)
do for [k = 1:words(sides)] { eval label_at(k, sprintf('%s x %s', word(sides, k), word(sides, k)), colour(k), 'left') }
set label 12 'error of the step' at end_x[12], end_y[12] left offset 0,-0.9 tc rgb grey
plot for [k=1:words(sides)] table using (only(here(word(sides, k) + 0), column('tolerance'))):@solved \
       with linespoints lw 2 pt 7 lc rgb colour(k), \
     for [k=1:words(sides)] '' using (only(here(word(sides, k) + 0), column('tolerance'))):@by_step \
       with lines lw 1.5 dt 2 lc rgb colour(k)
