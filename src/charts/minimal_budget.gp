# caption: How far the motion of a scene moves where one knob is as in its full model (the step: half as long), and how
# caption: many times the scene's cost that is.
# How far the motion moves where one knob at a time is as in the full model, and what that costs: a group a scene.
knobs = 'particles bend drag integrator dt'
titles = '"particles of the full model" "bend springs" "drag" "Dormand-Prince" "half the step"'
array colours[5] = [blue, sky, pink, orange, green]
mine = "(is('part', 'budget') && place(scenes, strcol('scene')) > 0 && place(knobs, strcol('changed')) > 0)"
# Scenes, and cost_SCENE of each as it is [s/s]
scenes = ''
as_it_is(scene) = is('part', 'budget') && is('scene', scene) && is('changed', 'none')
stats table using (is('part', 'budget') ? (scenes = listed(scenes, strcol('scene')), 0) : 0) nooutput
do for [scene in scenes] {
  stats table using (as_it_is(scene) ? (cost = column('cost_s_per_s'), 0) : 0) nooutput
  eval sprintf('cost_%s = %.17g', scene, cost)
}
# From top to bottom: the rows of a scene, and what its need allows
rows = 0; high = 1e-9; part_of_allowed = 0
array allowed[20]; array first_row[20]; array last_row[20]
noted(s) = (rows = rows + 1, high = most(high, most(column('moved'), column('allowed_error'))), \
  part_of_allowed = most(part_of_allowed, column('moved') / column('allowed_error')), allowed[s] = column('allowed_error'), 0)
do for [s = 1:words(scenes)] {
  allowed[s] = NaN
  first_row[s] = rows + 1
  stats table using (@mine && is('scene', word(scenes, s)) ? noted(s) : 0) nooutput
  last_row[s] = rows
  rows = rows + 0.7
}
eval paper(145 + 20 * rows)
eval headline(sprintf('No part of the full model would move the motion by more than %.0f %% of what the need allows', \
  100 * part_of_allowed), 'One part of a scene as in its full model, the rest as it is; vertical lines: what the need of the scene allows')
eval frame(290, 130, 55, 85)
set logscale x
set format x '%g'
set xlabel 'the motion moves by [% of the side]'
set xrange [0.01:130 * high]
set yrange [-rows - 0.4:-0.3]
set border 1
unset ytics
set grid noytics
set label 20 'cost' at graph 1, graph 1 left offset 2,0.8 tc rgb grey
do for [s = 1:words(scenes)] {
  if (last_row[s] >= first_row[s]) {
    set label s readable(word(scenes, s)) at screen px(12), first -first_row[s] left
    set arrow s from 100 * allowed[s], first 0.4 - first_row[s] to 100 * allowed[s], first -last_row[s] - 0.4 nohead lc rgb grey lw 2
  }
}
# Rows in the order of the table, as they were counted
row = 0; scene_before = ''
down(scene) = (row = row + 1 + (scene_before eq '' || scene_before eq scene ? 0 : 0.7), scene_before = scene, -row)
again = "(row = 0, scene_before = '', NaN)"
y = "(@mine ? down(strcol('scene')) : NaN)"
colour_of_knob(knob) = int('0x'.colours[place(knobs, knob)][2:7])
least_shown = 0.012
moved = "(100 * column('moved'))"
plot table using (only(@mine, most(@moved, least_shown))):@y:(@mine ? colour_of_knob(strcol('changed')) : 0) \
       with points pt 7 ps 1.2 lc rgb variable, \
     @again, \
     table using (0.01):@y:(@mine ? word(titles, place(knobs, strcol('changed'))) : '') with labels right offset -1.5,0, \
     @again, \
     table using (130 * high):@y:(@mine ? sprintf('%.1f times%s', column('cost_s_per_s') / value('cost_'.strcol('scene')), \
       @moved < least_shown ? ' (moves less)' : '') : '') with labels left offset 2,0
