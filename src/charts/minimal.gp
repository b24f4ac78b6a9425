# caption: What was taken away from the full model of a scene, one notch after the other, until one notch less of
# caption: anything breaks its need.
# The ladder of a scene: from the full model down, each notch that was taken away with its cost and error; below, in
# red, one notch less of each knob, which the need does not allow.
# scene
word_of(integrator, step) = integrator eq 'dormand_prince' ? 'Dormand-Prince' : \
  sprintf('%s, %.2g ms', name_of(integrator), 1e3 * step)
model(x, y, bend, drag, integrator, step) = sprintf('%d x %d%s%s, %s', x, y, bend eq 'yes' ? ', bend' : '', \
  drag eq 'yes' ? ', drag' : '', word_of(integrator, step))
configuration(n) = model(column('particles_x'), column('particles_y'), strcol('bend'), strcol('drag'), \
  strcol('integrator'), column('step_s'))
cost = "column('cost_s_per_s')"
percent(x) = x == x ? sprintf('%.2g %%', 100 * x) : ''
rung(part, end) = is('part', part) && is('scene', scene) && is('outcome', end)
refused = "(rung('notches', 'rejected') && !is('changed', 'none'))"
dearest = 0; cheapest = 1e9; full = NaN; last_cost = NaN; kept = 0; less = 0
stats table using (rung('ladder', 'kept') ? (kept = kept + 1, dearest = most(dearest, @cost), cheapest = least(cheapest, @cost), \
  allowed = column('allowed_error'), full = kept == 1 ? @cost : full, last_cost = @cost, 0) : @refused ? (less = less + 1, 0) : 0) nooutput
eval paper(130 + 32 * (kept + less))
eval headline(sprintf('%s shows what its full model shows within %g %%, at a %.2g times lower cost', capital(readable(scene)), \
  100 * allowed, full / last_cost), 'From top to bottom, what was taken away; in red, one notch less of each: too far, or unstable')
eval frame(300, 130, 55, 65)
set logscale x
set xlabel 'CPU time per simulated second [s]'
set border 1; unset ytics; set grid noytics
left = cheapest / 2
none(name) = strcol(name) eq 'nan'
set xrange [left:2 * dearest]
set yrange [-kept - less - 0.7:-0.3]
set label 20 'error' at graph 1, first -0.3 left offset 2,0.3 tc rgb grey
k = 0
down(wanted) = wanted ? (k = k + 1, -k) : NaN
plot table using (only(rung('ladder', 'kept'), @cost)):(down(rung('ladder', 'kept'))) with linespoints \
       lw 1.5 pt 7 ps 1 lc rgb green, \
     (k = 0, NaN), \
     table using (left):(down(rung('ladder', 'kept'))):(configuration(0)) with labels right offset -1,0, \
     (k = 0, NaN), \
     table using (2 * dearest):(down(rung('ladder', 'kept'))):(percent(column('error'))) \
       with labels left offset 2,0 tc rgb green, \
     (k = kept, NaN), \
     table using (left):(down(@refused)):(configuration(0)) with labels right offset -1,0 tc rgb red, \
     (k = kept, NaN), \
     table using (none('cost_s_per_s') ? NaN : @cost):(down(@refused)) with points pt 2 lw 1.5 lc rgb red, \
     (k = kept, NaN), \
     table using (2 * dearest):(down(@refused)):(none('error') ? 'beyond its limit' : percent(column('error'))) \
       with labels left offset 2,0 tc rgb red
