# Six methods in one panel: cost against error, with what a picture needs.
# scene, particles, horizon [s]
eval paper(830, 430)
set label sprintf('%s, %d x %d particles: what accuracy costs', scene eq 'contact' ? 'A sheet falls on a ball' : \
  'A sheet swings from two corners', particles, particles) at screen 0.5,0.95 center font ',13'
set tmargin 3
set logscale xy
set format '10^{%L}'
set xlabel 'error: RMS distance from the converged cloth, of its side'
set ylabel 'CPU time per simulated second [s]'
unset key
methods = 'symplectic_euler velocity_verlet backward_euler implicit_midpoint_clamped xpbd_1 projective_dynamics_5'
names = '"symplectic Euler" "velocity Verlet" "backward Euler" "implicit midpoint" "XPBD, 1 iteration" "projective dynamics"'
array colours[6] = [orange, blue, red, sky, green, pink]
here(k) = is('scene', scene) && is('method', word(methods, k)) && is('end', 'bounded')
# Names stand at the most exact point of a method, or (first and fifth) at its cheapest
at_cheapest(k) = k == 1 || k == 5
array name_x[6]; array name_y[6]
least = 1e9; most = 0; low = 1e9
do for [k = 1:6] {
  name_x[k] = 1e9; name_y[k] = 1e9
  stats table using (here(k) ? ((at_cheapest(k) ? column('cost_s_per_s') < name_y[k] : column('error') < name_x[k]) ? \
    (name_x[k] = column('error'), name_y[k] = column('cost_s_per_s')) : 0, \
    low = column('cost_s_per_s') < low ? column('cost_s_per_s') : low, \
    least = column('error') < least ? column('error') : least, most = column('error') > most ? column('error') : most) \
    : NaN) nooutput
}
set xrange [least / 12:most * 4]
set yrange [low / 2:*]
set object 1 rectangle from 1e-3, graph 0 to 1e-2, graph 1 behind fc rgb '#f0f0e0' fs noborder
set label 'enough for a picture' at 3.2e-3, graph 0.95 center tc rgb grey
set arrow from graph 0, first 0.01 to graph 1, first 0.01 nohead dt 3 lc rgb grey
set label 'a hundredth of one core' at graph 0.01, first 0.01 offset 0,0.6 tc rgb grey
do for [k = 1:6] {
  if (at_cheapest(k)) { set label word(names, k) at name_x[k], name_y[k] right offset -0.8,-0.6 tc rgb colours[k] }
  else { set label word(names, k) at name_x[k], name_y[k] right offset -0.8,0 tc rgb colours[k] }
}
plot for [k = 1:6] table using (only(here(k), column('error'))):(column('cost_s_per_s')) with linespoints lw 1.5 pt 7 ps 0.7 \
       lc rgb colours[k]
