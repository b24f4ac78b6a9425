# caption: Steps that stayed bounded and steps that failed, over stiffness and damping. The line is the longest step
# caption: that is predicted: every dot should lie below it, every cross above it. Where the method has no linear limit
# caption: there is no line, and a cross is a failure that no linear theory predicts.
# method, side: whose trials; trials, against: how many there are, those close to a limit left out, and contradict it
# limited: 1 if the method has a linear step limit; stiffness, damping: 1 if they were swept
eval paper(limited ? 620 : 420)
endless = method eq 'explicit_euler'
eval headline(!limited ? sprintf('%s has no linear limit: %d of %d trials are not bounded', capital(name_of(method)), against, trials) : \
  endless ? sprintf('Explicit Euler fails once noise has grown: %d of %d trials contradict that', against, trials) : \
  sprintf('%s fails at its predicted limit: %d of %d trials contradict that', capital(name_of(method)), against, trials), \
  sprintf('%d x %d particles%s', side, side, limited ? '. Trials as close to the line as the grey band cannot contradict' : ''))
eval panels(limited ? 2 : 1, 2, 75, 20, 55, 105, 75, 60)
set logscale xy
set format '10^{%L}'
eval room_about_data
# What the marks mean, in a line
set label 1 'stayed bounded' at screen px(20), screen 1 - py(66) left point pt 7 ps 0.7 lc rgb blue offset 0.8,-0.3 tc rgb blue
set label 2 'failed' at screen px(150), screen 1 - py(66) left point pt 2 ps 0.9 lw 1.5 lc rgb red offset 0.8,-0.3 tc rgb red
if (limited) { set label 3 (endless ? 'line: where growth from noise shows in a run of this length' : 'line: predicted limit') \
  at screen px(225), screen 1 - py(66) left }
if (limited && against > 0) { set label 4 'contradicts' at screen px(400), screen 1 - py(66) left point pt 4 ps 1.5 lc rgb pink offset 0.8,-0.3 tc rgb pink }
here = "is('method', method) && is('sweep', sweep) && column('side') == side"
step_where(condition) = only(@here && condition, column('step_s'))
limit(column_name) = only(@here, column(column_name))
share_where(condition) = only(@here && condition && inside(column('step_s') / column('expected_step_s')), \
                              column('step_s') / column('expected_step_s'))
inside(ratio) = ratio >= 0.6 && ratio <= 1.65
positive(value) = value > 0 ? value : NaN
array labels[2] = ['stiffness of every spring [N/m], undamped', 'damping of every spring [N s/m], at 10^4  N/m']
array swept[2] = ['stiffness_N_per_m', 'damping_N_s_per_m']
array there[2] = [stiffness, damping]
do for [k = 1:2] {
  sweep = k == 1 ? 'stiffness' : 'damping'
  swept_name = swept[k]
  set ylabel k == 1 ? 'step [s]' : ''
  set xlabel limited ? '' : labels[k]
  if (!there[k]) {
    set multiplot next
  } else {
    lasting = 0
    if (endless) {
      set autoscale fix
      stats table using (limit('predicted_step_s') > 0 ? 1 : 0) nooutput
      lasting = STATS_max > 0
    }
    plot table using (column(swept_name)):(step_where(is('end', 'bounded'))) with points pt 7 ps 0.7 lc rgb blue, \
         '' using (column(swept_name)):(step_where(!is('end', 'bounded'))) with points pt 2 ps 0.9 lw 1.5 lc rgb red, \
         for [one = 1:limited] '' using (column(swept_name)):(limit('expected_step_s')) with lines lw 2 lc rgb black, \
         for [one = 1:(limited && endless && lasting)] '' using (column(swept_name)):(positive(limit('predicted_step_s'))) \
           with lines lw 2 dt 2 lc rgb green, \
         for [one = 1:(limited && against > 0)] '' using (column(swept_name)):(step_where(is('agreement', 'disagrees'))) \
           with points pt 4 ps 1.8 lw 1.5 lc rgb pink
    unset label
  }
}
# The same once more over the limit, and only what is near it
band = endless ? 0.15 : 0.03
set offsets graph 0.05, graph 0.05, 0, 0
set yrange [0.58:1.72]
unset logscale y
set logscale y 2
set format y '%g'
set ytics (0.6, 0.8, 1, 1.25, 1.6)
set object 1 rectangle from graph 0, first 1 - band to graph 1, first 1 + band fs solid noborder fc rgb '#e4e4e4' behind
do for [k = 1:(limited ? 2 : 0)] {
  sweep = k == 1 ? 'stiffness' : 'damping'
  swept_name = swept[k]
  set ylabel k == 1 ? (endless ? 'step / line, near it' : 'step / limit, near it') : ''
  set xlabel labels[k]
  if (!there[k]) {
    set multiplot next
  } else {
    plot table using (column(swept_name)):(share_where(is('end', 'bounded'))) with points pt 7 ps 0.7 lc rgb blue, \
         '' using (column(swept_name)):(share_where(!is('end', 'bounded'))) with points pt 2 ps 0.9 lw 1.5 lc rgb red, \
         '' using (column(swept_name)):(limit('expected_step_s') / limit('expected_step_s')) with lines lw 2 lc rgb black
  }
}
unset multiplot
