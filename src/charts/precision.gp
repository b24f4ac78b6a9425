# caption: Error at the horizon against the CPU time of a simulated second (medians, quartiles as bars) over a ladder of
# caption: steps: left is more exact, down is cheaper. The order is fitted to the finest points. Where a ball is hit,
# caption: errors are averaged over phases of the first impact within a step, and from it on every method is of order 1.
# caption: The reference is in error by $reference_error$; a small error at the start grows $growth$ times.
# A work-precision diagram: a panel for each family of methods, a line for each method, a point for each step.
# scene
families = 'explicit implicit positional'
explicit = 'explicit_euler symplectic_euler velocity_verlet rk4 dormand_prince'
implicit = 'backward_euler implicit_midpoint_clamped implicit_midpoint_exact bdf2_clamped bdf2_exact'
positional = 'xpbd_1 xpbd_5 xpbd_20 projective_dynamics_5 projective_dynamics_20'
here = "(is('scene', scene) && is('end', 'bounded') && column('error') + column('cost_s_per_s') >= 0)"
point(method) = is('method', method) && @here
# All points: how many, of which methods, and within which ranges
methods = ''; points = 0; least_error = 1e9; most_error = 0; least_cost = 1e9; most_cost = 0
noted(method, error, cost) = (points = points + 1, methods = listed(methods, method), \
  least_error = least(least_error, error), most_error = most(most_error, error), \
  least_cost = least(least_cost, cost), most_cost = most(most_cost, cost), \
  particles = column('particles'), stiffness = column('stiffness_N_per_m'), 0)
stats table using (@here ? noted(strcol('method'), column('error'), column('cost_s_per_s')) : 0) nooutput
if (points == 0) { exit status 3 }
eval paper(900)
# The Pareto front: points that no other one beats in both numbers
array errors[points]; array costs[points]
points = 0
kept(error, cost) = (points = points + 1, errors[points] = error, costs[points] = cost, 0)
stats table using (@here ? kept(column('error'), column('cost_s_per_s')) : 0) nooutput
beaten(error, cost) = sum [k = 1:points] (errors[k] <= error && costs[k] <= cost && (errors[k] < error || costs[k] < cost))
# The order of a method: the slope through its finest three points, if the two slopes between them differ by no more than
# half an order, or half of the larger one; then through coarser ones, too, as long as the slope to the next is within
# 0.15, or 15 %, of it. Rows come from long steps to short ones; those before one that was unstable do not count
array log_step[points]; array log_error[points]
ended(h, error) = !is('end', 'bounded') ? (n = 0, 0) : \
  error > 0 ? (n = n + 1, log_step[n] = log(h), log_error[n] = log(error), 0) : 0
slope(i) = log_step[i] == log_step[i + 1] ? NaN : (log_error[i] - log_error[i + 1]) / (log_step[i] - log_step[i + 1])
fitted(m) = (middle = (sum [i = n - m + 1:n] log_step[i]) / m, \
  (sum [i = n - m + 1:n] (log_step[i] - middle) * log_error[i]) / (sum [i = n - m + 1:n] (log_step[i] - middle)**2))
differ(a, b) = abs(a - b) / most(1, most(a, b))
do for [method in methods] {
  n = 0; m = 3
  stats table using (is('scene', scene) && is('method', method) ? ended(column('step_s'), column('error')) : 0) nooutput
  if (n >= m && differ(slope(n - 1), slope(n - 2)) <= 0.5) {
    while (m < n && differ(slope(n - m), fitted(m)) <= 0.15) { m = m + 1 }
    eval sprintf('order_%s = %.17g', method, fitted(m))
  }
}
# The cheapest within an error
cheapest = ''
within(allowed) = sprintf("best = 1e9; cheapest = 'none'; do for [method in methods] { stats table using (point(method) && \
  column('error') <= %g && column('cost_s_per_s') < best ? (best = column('cost_s_per_s'), cheapest = method, 0) : 0) nooutput }", \
  allowed)
eval within(1e-2); rough = in_words(name_of(cheapest))
eval within(1e-4); fine = in_words(name_of(cheapest))
eval headline(sprintf('Cheapest within 1 %% of the side: %s; within 0.01 %%: %s', rough, fine), \
  sprintf('%s, %d x %d particles, %g N/m. Grey: Pareto front of all methods; shaded: enough for a picture', \
  scene eq 'contact' ? 'A sheet falls on a ball' : 'A sheet hung by two corners', particles, particles, stiffness))
eval panels(3, 1, 65, 15, 55, 70, 0, 30)
set logscale xy
set format '10^{%L}'
set ylabel 'CPU s / simulated s'
# On the left there is room for the names of what is most exact; the others' are on the right
decades = log10(most_error / least_error)
low = least_error * 10**(-0.33 * decades); high = most_error * 10**(0.05 * decades)
set object 1 rectangle from 1e-3, graph 0 to least(1e-2, high), graph 1 behind fc rgb '#f0f0e0' fs noborder
array colours[5] = [black, orange, blue, red, green]
dash(method) = strstrt(method, 'exact') ? 2 : 1
order(method) = exists('order_'.method) ? sprintf(', order %.2g', value('order_'.method)) : ', no order'
set style textbox opaque noborder margins 0.3,0.1 fc rgb '#60ffffff'
near_x(i, j) = abs(log10(end_x[i] / end_x[j])) < 0.25 * decades
do for [family in families] {
  shown = ''
  do for [method in value(family)] { if (place(methods, method) > 0) { shown = shown.' '.method } }
  eval forget
  set autoscale
  do for [k = 1:words(shown)] {
    stats table using (first(k, point(word(shown, k)), column('error'), column('cost_s_per_s'))) nooutput
  }
  leftmost = 1e9
  do for [k = 1:words(shown)] { leftmost = least(leftmost, end_x[k]) }
  on_left(k) = log10(end_x[k] / leftmost) < 0.1 * decades
  do for [k = 1:words(shown)] { if (!on_left(k)) { end_y[k] = 2 * end_y[k] } }
  eval spread(gap_of(least_cost / 1.6, most_cost * 1.6, 235))
  do for [k = 1:words(shown)] {
    eval label_at(k, name_of(word(shown, k)).order(word(shown, k)), colours[k], on_left(k) ? 'right' : 'left').' boxed'
  }
  set label 11 family at graph 0, graph 0 left offset 1,1 font ',13'
  if (family eq 'positional') { set xlabel 'RMS position error / side of the cloth' }
  set xrange [low:high]
  set yrange [least_cost / 1.6:most_cost * 1.6]
  plot table using (only(@here && !beaten(column('error'), column('cost_s_per_s')), column('error'))):(column('cost_s_per_s')) \
         smooth unique with lines lw 6 lc rgb pale title 'Pareto front', \
       for [k = 1:words(shown)] table using (only(point(word(shown, k)), column('error'))):(column('cost_s_per_s')) \
         :(column('cost_lower_s_per_s')):(column('cost_upper_s_per_s')) \
         with yerrorlines pt 7 ps 0.6 lw 1.5 dt dash(word(shown, k)) lc rgb colours[k]
  eval no_headline
}
unset multiplot
