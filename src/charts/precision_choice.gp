# caption: Six of these methods: what each error costs, and which errors a picture can show.
# scene
methods = 'symplectic_euler velocity_verlet backward_euler implicit_midpoint_clamped xpbd_1 projective_dynamics_5'
array colours[6] = [orange, blue, red, sky, green, pink]
here(k) = is('scene', scene) && is('method', word(methods, k)) && is('end', 'bounded') && \
  column('error') + column('cost_s_per_s') >= 0
least_error = 1e9; most_error = 0; least_cost = 1e9; most_cost = 0
noted(error, cost) = (least_error = least(least_error, error), most_error = most(most_error, error), \
  least_cost = least(least_cost, cost), most_cost = most(most_cost, cost), particles = column('particles'), 0)
# The cheapest of the six within an error, and its cost
cheapest = 0; best = 1e9
better(k, cost) = cost < best ? (best = cost, cheapest = k, 0) : 0
# Names stand at the most exact point of a method, or (first and fifth) at its cheapest
at_cheapest(k) = k == 1 || k == 5
eval forget
do for [k = 1:6] {
  stats table using (here(k) ? noted(column('error'), column('cost_s_per_s')) : 0) nooutput
  stats table using (here(k) && column('error') <= 1e-2 ? better(k, column('cost_s_per_s')) : 0) nooutput
  if (!at_cheapest(k)) { stats table using (first(k, here(k), column('error'), column('cost_s_per_s'))) nooutput }
}
rough = cheapest; rough_cost = best; cheapest = 0; best = 1e9
do for [k = 1:6] {
  stats table using (here(k) && column('error') <= 1e-4 ? better(k, column('cost_s_per_s')) : 0) nooutput
  if (at_cheapest(k)) {
    lowest = 1e9
    stats table using (here(k) && column('cost_s_per_s') < lowest ? (lowest = column('cost_s_per_s'), \
      further(k, column('error'), column('cost_s_per_s'))) : 0) nooutput
  }
}
if (most_error == 0) { exit status 3 }
eval paper(450)
title_of(k) = k > 0 ? name_of(word(methods, k)) : 'none'
eval headline(cheapest == 0 || rough == 0 ? 'Not all errors are reached' : \
  sprintf('Within 1 %%, %s is cheapest; %s gives 0.01 %% for %.1f times as much', in_words(title_of(rough)), in_words(title_of(cheapest)), best / rough_cost), \
  sprintf('%s, %d x %d particles', scene eq 'contact' ? 'A sheet falls on a ball' : 'A sheet swings from two corners', \
  particles, particles))
eval frame(70, 20, 55, 70)
set logscale xy
set format '10^{%L}'
set xlabel 'error: RMS distance from the converged cloth, of its side'
set ylabel 'CPU time per simulated second [s]'
set xrange [least_error / 12:most_error * 4]
set yrange [least_cost / 2:most_cost * 2.5]
set object 1 rectangle from 1e-3, graph 0 to 1e-2, graph 1 behind fc rgb '#f0f0e0' fs noborder
set label 11 'enough for a picture' at 3.2e-3, graph 0.95 center tc rgb grey
set label 12 'a hundredth of one core' at graph 0.01, first 0.01 offset 0,0.6 tc rgb grey
do for [k = 1:6] {
  label_text = title_of(k); label_colour = ink(colours[k])
  if (end_x[k] == end_x[k]) { set label k label_text at end_x[k],end_y[k] right offset -1,at_cheapest(k) ? -0.6 : 0 tc rgb label_colour }
}
plot 0.01 with lines dt 3 lc rgb grey, \
     for [k = 1:6] table using (only(here(k), column('error'))):(column('cost_s_per_s')) with linespoints lw 1.5 pt 7 ps 0.7 \
       lc rgb colours[k]
