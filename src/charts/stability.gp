# Steps that stayed bounded and steps that failed, against stiffness and damping.
# method, side: whose trials; trials, against: how many there are, those close to a limit left out, and contradict it
# limited: 1 if the method has a linear step limit; stiffness, damping: 1 if they were swept
eval paper(1100, 560)
titled(method) = method eq 'rk4' ? 'RK4' : method eq 'explicit_euler' ? 'Explicit Euler' : \
                 method eq 'symplectic_euler' ? 'Symplectic Euler' : method eq 'velocity_verlet' ? 'Velocity Verlet' : \
                 readable(method)
set multiplot layout 1,2 margins 0.085,0.98,0.235,0.87 spacing 0.09,0 \
  title sprintf('%s, %d x %d particles: %d of %d trials %s', titled(method), side, side, against, trials, \
                limited ? 'that are not close to the limit contradict it' : 'not bounded (there is no linear limit)') font ',13'
set logscale xy
set format '10^{%L}'
set offsets graph 0.04, graph 0.04, 0, 0
set ylabel 'step [s]'
eval legend(0.075)
step_where(condition) = only(is('method', method) && is('sweep', sweep) && column('side') == side && condition, \
                             column('step_s'))
limit(column_name) = only(is('method', method) && is('sweep', sweep) && column('side') == side, column(column_name))
noisy = method eq 'explicit_euler'
endless(value) = value > 0 ? value : NaN

array labels[2] = ['stiffness of every spring [N/m], undamped', \
                   'damping of every spring [N s/m], stiffness 10^4 N/m']
array swept[2] = ['stiffness_N_per_m', 'damping_N_s_per_m']
array there[2] = [stiffness, damping]
do for [k = 1:2] {
  sweep = k == 1 ? 'stiffness' : 'damping'
  swept_name = swept[k]
  set xlabel labels[k]
  if (!there[k]) {
    set multiplot next
  } else {
    lasting = 0
    if (noisy) {
      set autoscale
      stats table using (limit('predicted_step_s') > 0 ? 1 : 0) nooutput
      lasting = STATS_max > 0
    }
    plot table using (column(swept_name)):(step_where(is('end', 'bounded'))) with points pt 7 ps 0.7 lc rgb blue \
           title 'stayed bounded', \
         '' using (column(swept_name)):(step_where(!is('end', 'bounded'))) with points pt 2 ps 0.9 lw 1.5 lc rgb red \
           title 'failed', \
         for [one = 1:limited] '' using (column(swept_name)):(limit('expected_step_s')) with lines lw 2 lc rgb black \
           title noisy ? 'where growth from noise shows' : 'predicted limit', \
         for [one = 1:(limited && noisy && lasting)] '' using (column(swept_name)):(endless(limit('predicted_step_s'))) with lines lw 2 dt 2 \
           lc rgb green title 'limit of a run without end', \
         for [one = 1:(limited && against > 0)] '' using (column(swept_name)):(step_where(is('agreement', 'disagrees'))) \
           with points pt 4 ps 1.8 lw 1.5 lc rgb pink title 'contradicts the prediction'
    unset key
  }
  set ylabel ''
}
unset multiplot
