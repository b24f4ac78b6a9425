# caption: Error of a falling sheet after half a second against the CPU time of a simulated second, by steps of 1/60 s
# caption: and of a half, a quarter and an eighth of it: with one Newton step in each, and with two.
eval paper(430)
eval frame(60, 40, 55, 70)
set logscale xy
set format xy '%g'
set ytics (0.1, 0.2, 0.5, 1, 2, 5, 10)
set xlabel 'error after half a second [mm]'
set ylabel 'CPU time of a simulated second [s]'
eval room_about_data
colour(k) = word(blue.' '.green.' '.red, k)
here(method, steps) = is('part', 'newton') && is('method', method) && column('newton_steps') == steps
error = "(1e3 * column('step_error_m'))"
cost = "(column('cost_s') / column('step_s'))"
# Errors at the longest step, and at half of it, over that of one Newton step at the longest
longest = 0
stats table using (is('part', 'newton') ? (longest = most(longest, column('step_s')), 0) : 0) nooutput
near(a, b) = abs(a - b) < 0.01 * b
array one[3]; array two[3]; array half[3]
second_least = 1e9; second_most = 0; half_least = 1e9; half_most = 0
eval forget
do for [k = 1:words(methods)] {
  method = word(methods, k)
  one[k] = NaN; two[k] = NaN; half[k] = NaN
  stats table using (here(method, 1) && near(column('step_s'), longest) ? (one[k] = @error, 0) : \
                     here(method, 2) && near(column('step_s'), longest) ? (two[k] = @error, 0) : \
                     here(method, 1) && near(2 * column('step_s'), longest) ? (half[k] = @error, 0) : 0) nooutput
  second_least = least(second_least, two[k] / one[k]); second_most = most(second_most, two[k] / one[k])
  half_least = least(half_least, half[k] / one[k]); half_most = most(half_most, half[k] / one[k])
  stats table using (first(k, here(method, 2), @error, @cost)) nooutput
}
eval headline(sprintf('At %.3g ms a second Newton step cuts the error to %.0f to %.0f %%, half the step to %.0f to %.0f %%', 1e3 * longest, \
  100 * second_least, 100 * second_most, 100 * half_least, 100 * half_most), \
  sprintf('Steps of %.3g ms and of a half, a quarter and an eighth of it; solid: two Newton steps a step, dashed: one', 1e3 * longest))
do for [k = 1:words(methods)] { set label k name_of(word(methods, k)) at end_x[k], end_y[k] left offset 1.2,0.5 tc rgb colour(k) }
plot for [k=1:words(methods)] table using (only(here(word(methods, k), 1), @error)):@cost \
       with linespoints lw 2 pt 6 dt 2 lc rgb colour(k), \
     for [k=1:words(methods)] '' using (only(here(word(methods, k), 2), @error)):@cost \
       with linespoints lw 2 pt 7 lc rgb colour(k)
