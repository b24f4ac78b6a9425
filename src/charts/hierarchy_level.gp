# caption: What a search knows that ends at a level: how loose the nodes there are, how many of them it visits, how many
# caption: cells it would test in vain for each that touches, and the CPU time it has taken to get there.
# scene
eval paper(640)
lines = 'sphere:centroid:rebuild sphere:centroid:merge sphere:welzl:rebuild aabb:none:rebuild kdop18:none:rebuild obb:none:rebuild'
array names[6] = ['spheres', 'spheres, merged', 'smallest spheres', 'boxes', '18-DOPs', 'oriented boxes']
array colours[6] = [blue, sky, black, red, green, pink]
array markers[6] = [7, 6, 4, 5, 9, 13]
array dashes[6] = [1, 2, 3, 1, 1, 1]
here(k) = is('part', 'level') && is('scene', scene) && strcol('volume').':'.strcol('sphere_fit').':'.strcol('update') eq word(lines, k)
# At the leaves, of oriented boxes and of the best of the others
deepest = 0; oriented = NaN; others = 1e9
stats table using (is('part', 'level') && is('scene', scene) ? (deepest = most(deepest, column('level')), 0) : 0) nooutput
do for [k = 1:6] {
  stats table using (here(k) && column('level') == deepest ? (k == 6 ? (oriented = column('false_per_true'), 0) : \
    (others = least(others, column('false_per_true')), 0)) : 0) nooutput
}
eval headline(oriented == oriented && others < 1e9 ? \
  sprintf('At the leaves, oriented boxes leave %.1f false candidates a true one, all others at least %.1f', oriented, others) : \
  'What a search knows that ends at a level', capital(readable(scene)).', leaves of one cell')
eval panels(2, 2, 65, 120, 55, 95, 170, 75)
set xtics 1
array labels[4] = ['size / smallest of its kind (others: 1)', 'nodes visited at the level', 'false candidates / true one', \
                   'query down to the level [us]']
y = "(panel == 1 ? column('tightness') : panel == 2 ? column('visited') : panel == 3 ? column('false_per_true') : \
     1e6 * column('query_s'))"
eval room_about_data
set format y '%g'
lowest = NaN; highest = NaN
seen(y) = y == y ? (lowest = lowest == lowest ? least(lowest, y) : y, highest = highest == highest ? most(highest, y) : y, 0) : 0
do for [panel = 1:4] {
  set title labels[panel] offset 0,-0.3
  if (panel > 1) { set logscale y }
  set xlabel panel > 2 ? 'level (0 is the root)' : ''
  eval forget
  lowest = NaN; highest = NaN
  do for [k = 1:6] {
    # In the first panel all others are 1
    shown = panel > 1 || k < 3
    stats table using (shown ? last(k, here(k), column('level'), @y) : 0) nooutput
    stats table using (here(k) ? seen(@y) : 0) nooutput
    if (panel == 1 && k < 3) { end_y[k] = NaN; stats table using (here(k) && column('level') == (k == 1 ? 1 : 4) ? further(k, column('level'), @y) : 0) nooutput }
  }
  if (panel > 1) { eval spread(lowest > 0 && highest > lowest ? gap_of(lowest, highest, 195) : 0.1) }
  do for [k = 1:6] {
    if (panel > 1) { eval label_at(k, names[k], colours[k], 'left') } else {
      if (k < 3 && end_y[k] == end_y[k]) { set label k names[k] at end_x[k], end_y[k] left offset 1.2,0.6 tc rgb ink(colours[k]) }
    }
  }
  plot for [k = 1:(panel == 1 ? 2 : 6)] table using (only(here(k), column('level'))):@y with linespoints lw 1.5 ps 0.9 pt markers[k] \
    dt dashes[k] lc rgb colours[k]
  eval no_headline
}
unset multiplot
