# A work-precision diagram: a panel for each family of methods, a line for each method, a point for each step.
# scene, particles, stiffness [N/m], horizon [s]; methods: those with points; order_METHOD where one was found
# overall: 1 if sag, centre of mass and energy are compared in place of positions
# least_error, most_error, least_cost, most_cost: of all points; data: the Pareto front, points that no other one beats
eval paper(1060, 860)
set multiplot layout 2,2 title sprintf('%s: %d x %d particles, %g N/m, to %g s', scene eq 'contact' ? \
  'A sheet falls on a ball' : 'A sheet swings from two corners', particles, particles, stiffness, horizon) font ',13'
set logscale xy
set format '10^{%L}'
unset key
set xlabel overall ? 'error of sag, centre of mass and energy' : 'RMS position error / side of the cloth'
set ylabel 'CPU time per simulated second [s]'
set xrange [10**floor(log10(least_error)):10**ceil(log10(most_error))]
set yrange [10**floor(log10(least_cost)):10**ceil(log10(most_cost))]

# A marker for each method, a colour for each variant, dashes where the Hessian is clamped
families = 'explicit implicit positional'
explicit = 'explicit_euler symplectic_euler velocity_verlet rk4 dormand_prince'
implicit = 'backward_euler implicit_midpoint_clamped implicit_midpoint_exact bdf2_clamped bdf2_exact'
positional = 'xpbd_1 xpbd_5 xpbd_20 projective_dynamics_5 projective_dynamics_20'
array titles[15] = ['explicit Euler', 'symplectic Euler', 'velocity Verlet', 'RK4', 'Dormand-Prince', \
  'backward Euler', 'midpoint, clamped', 'midpoint, exact', 'BDF2, clamped', 'BDF2, exact', \
  'XPBD, 1 iteration', 'XPBD, 5 iterations', 'XPBD, 20 iterations', \
  'projective, 5 iterations', 'projective, 20 iterations']
array markers[15] = [2, 7, 5, 9, 13, 11, 14, 15, 3, 3, 1, 1, 1, 6, 6]
array colours[15] = [red, orange, blue, green, black, red, sky, blue, pink, black, orange, red, black, sky, blue]
there(method) = strstrt(' '.methods.' ', ' '.method.' ') > 0
place = 0
do for [family in families] {
  do for [method in value(family)] {
    place = place + 1
    eval sprintf('number_%s = %d', method, place)
  }
}
# An empty list is looked up once, too
number(method) = exists('number_'.method) ? value('number_'.method) : 1
dash(method) = strstrt(method, 'clamped') ? 2 : 1
here(method) = only(is('scene', scene) && is('method', method) && is('end', 'bounded'), column('error'))
do for [family in families] {
  shown = ''
  do for [method in value(family)] { if (there(method)) { shown = shown.' '.method } }
  set title family offset 0,-0.5
  plot data using 1:2 with lines lw 6 lc rgb pale, \
       for [method in shown] table \
         using (here(method)):(column('cost_s_per_s')):(column('cost_lower_s_per_s')):(column('cost_upper_s_per_s')) \
         with yerrorlines ps 0.9 lw 1.5 pt markers[number(method)] dt dash(method) lc rgb colours[number(method)]
}

# The key, where a fourth panel would be, with the order of each method
order(method) = exists('order_'.method) ? sprintf(': order %.2g', value('order_'.method)) : ': no order'
unset title; unset border; unset tics; unset xlabel; unset ylabel; unset logscale; unset grid
set key at screen 0.53,0.475 left top Left reverse maxrows 20 samplen 3 spacing 1.1
plot [0:1][0:1] 2 notitle, \
     keyentry with lines lw 6 lc rgb pale title 'Pareto front: no point is better in both', \
     for [method in methods] keyentry with linespoints ps 0.9 lw 1.5 pt markers[number(method)] dt dash(method) \
       lc rgb colours[number(method)] title titles[number(method)].order(method)
unset multiplot
