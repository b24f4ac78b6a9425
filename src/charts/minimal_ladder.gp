# The ladder of a scene: from the full model down, each notch that was taken away with its cost and error; below, in
# red, one notch less of each knob, which the need does not allow.
# scene; allowed: the error that the scene may have
set datafile missing NaN
eval paper(830, 430)
set label sprintf("%s: what can be taken away until the error would be above %g %%", readable(scene), 100 * allowed) \
  at screen 0.5,0.95 center font ',13'
set logscale x
set xlabel 'CPU time per simulated second [s]'
set lmargin 38
set border 1; set tics nomirror; unset ytics; unset key
set tmargin 3
word_of(integrator, step) = integrator eq 'dormand_prince' ? 'computed closely' : \
  sprintf('%s, %.2g ms', readable(integrator), 1e3 * step)
model(x, y, bend, drag, integrator, step) = sprintf('%dx%d%s%s, %s', x, y, bend eq 'yes' ? ' bend' : '', \
  drag eq 'yes' ? ' drag' : '', word_of(integrator, step))
configuration(n) = model(column('particles_x'), column('particles_y'), strcol('bend'), strcol('drag'), \
  strcol('integrator'), column('step_s'))
cost = "column('cost_s_per_s')"
percent(x) = x == x ? sprintf('%.2g %%', 100 * x) : ''
rung(part, end) = is('part', part) && is('scene', scene) && is('outcome', end)
dearest = 0; cheapest = 1e9; n = 0; m = 0
stats table using (rung('ladder', 'kept') ? (n = n + 1, dearest = @cost > dearest ? @cost : dearest, \
  cheapest = @cost < cheapest ? @cost : cheapest, @cost) : NaN) nooutput
stats table using (rung('notches', 'rejected') && is('changed', 'none') == 0 ? (m = m + 1, 1) : NaN) nooutput
none(name) = strcol(name) eq 'nan'
kept = n; left = cheapest / 2
set xrange [left:4 * dearest]
set yrange [-kept - m - 0.7:-0.3]
k = 0
down(wanted) = wanted ? (k = k + 1, -k) : NaN
plot table using (only(rung('ladder', 'kept'), @cost)):(down(rung('ladder', 'kept'))) with linespoints \
       lw 1.5 pt 7 ps 1 lc rgb green, \
     (k = 0, NaN), \
     table using (left):(down(rung('ladder', 'kept'))):(configuration(0)) with labels right offset -1,0, \
     (k = 0, NaN), \
     table using (only(rung('ladder', 'kept'), @cost)):(down(rung('ladder', 'kept'))):(percent(column('error'))) \
       with labels left offset 1.2,0 tc rgb green, \
     (k = kept, NaN), \
     table using (left):(down(rung('notches', 'rejected') && !is('changed', 'none'))):(configuration(0)) \
       with labels right offset -1,0 tc rgb red, \
     (k = kept, NaN), \
     table using (none('cost_s_per_s') ? 1.2 * left : @cost):\
       (down(rung('notches', 'rejected') && !is('changed', 'none'))):\
       (none('error') ? 'beyond the limit of the step' : percent(column('error'))) \
       with labels left offset 1.2,0 tc rgb red point pt 2 lc rgb red
