# The race with another engine: error against cost, for the three pairs of methods that are alike. Drawn by charts.sh.
eval paper(470)
drape = "'Drape symplectic Euler' 'Drape XPBD 1' 'Drape backward Euler Newton 2'"
bullet = "'Bullet deformable explicit' 'Bullet btSoftBody 1' 'Bullet deformable implicit'"
drape_names = "'Drape, symplectic Euler' 'Drape, XPBD' 'Drape, backward Euler'"
bullet_names = "'Bullet, explicit' 'Bullet, soft body' 'Bullet, implicit'"
array colours[3] = [blue, green, red]
# The rows of a length of step follow each other: what Bullet takes over what Drape takes, and the errors of the longest
array ratio_least[3]; array ratio_most[3]; array ours[3]; array its[3]
other_step = 0; wins = 0; races = 0
do for [k = 1:3] { ratio_least[k] = 1e9; ratio_most[k] = 0; ours[k] = NaN; its[k] = NaN }
noted(k, ratio) = ratio != ratio ? 0 : (ratio_least[k] = least(ratio_least[k], ratio), ratio_most[k] = most(ratio_most[k], ratio), 0)
longest = 0; shortest = 1e9; single = NaN; implicit = NaN
stats table using (longest = most(longest, column('step_ms')), shortest = least(shortest, column('step_ms')), 0) nooutput
stats table using (column('step_ms') < longest ? 0 : is('method', 'Drape backward Euler') ? (single = column('error_percent'), 0) : \
  is('method', word(bullet, 3)) ? (implicit = column('error_percent'), 0) : 0) nooutput
do for [k = 1:3] {
  do for [doubling = 0:13] {
    steps = 24 * 2**doubling
    stats table using (column('steps') != steps ? 0 : is('method', word(drape, k)) ? (ours[k] = column('cost_s_per_s'), 0) : \
      is('method', word(bullet, k)) ? (its[k] = column('cost_s_per_s'), 0) : 0) nooutput
    done = noted(k, its[k] / ours[k])
    ours[k] = NaN; its[k] = NaN
  }
}
eval headline(sprintf('Step for step Bullet takes %.0f to %.0f times as long explicitly, %.1f to %.1f by position, %.1f to %.0f implicitly', \
  ratio_least[1], ratio_most[1], ratio_least[2], ratio_most[2], ratio_least[3], ratio_most[3]), \
  sprintf('%s implicit step of %.3g ms is the more accurate: %.1f %% in Bullet, %.1f %% in Drape with one Newton step (drawn: two)', \
  implicit < single ? "Bullet's" : "Drape's", longest, implicit, single))
eval forget
do for [k = 1:3] {
  # Explicit ones, which lie below the others, have their names on the left
  stats table using (k == 1 ? first(k, is('method', word(drape, k)), column('error_percent'), column('cost_s_per_s')) : \
    last(k, is('method', word(drape, k)), column('error_percent'), column('cost_s_per_s'))) nooutput
  stats table using (k == 1 ? first(k + 3, is('method', word(bullet, k)), column('error_percent'), column('cost_s_per_s')) : \
    last(k + 3, is('method', word(bullet, k)), column('error_percent'), column('cost_s_per_s'))) nooutput
}
stats table using (column('step_ms') < 0.01 ? further(7, column('error_percent'), column('cost_s_per_s')) : 0) nooutput
eval frame(75, 20, 55, 70)
set logscale xy
set format xy '%g'
set xlabel 'error [% of the side]'
set ylabel 'CPU time per simulated second [s]'
set xrange [0.00015:500]
set yrange [0.0003:30]
if (end_x[7] == end_x[7]) { set label 7 sprintf('steps of %.0f us', 1e3 * shortest) at end_x[7], end_y[7] left offset 1.1,0 tc rgb green }
eval spread(0.2)
do for [k = 1:3] {
  eval label_at(k, word(drape_names, k), colours[k], k == 1 ? 'right' : 'left')
  eval label_at(k + 3, word(bullet_names, k), colours[k], k == 1 ? 'right' : 'left')
}
plot for [k = 1:3] table using (only(is('method', word(drape, k)), column('error_percent'))):(column('cost_s_per_s')) \
       with linespoints lw 2 pt 7 lc rgb colours[k], \
     for [k = 1:3] '' using (only(is('method', word(bullet, k)), column('error_percent'))):(column('cost_s_per_s')) \
       with linespoints lw 1.5 dt 2 pt 6 lc rgb colours[k]
