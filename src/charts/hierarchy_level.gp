# Tightness, nodes visited, false candidates and time by level of the tree.
# scene
eval paper(1100, 760)
set multiplot layout 2,2 margins 0.08,0.98,0.165,0.93 spacing 0.09,0.1 \
  title 'Level by level: '.readable(scene).', leaves of one cell' font ',13'
eval room_about_data
eval legend(0.045)
set xtics 1
here(volume, fit, update) = is('part', 'level') && is('scene', scene) && is('volume', volume) && \
  is('sphere_fit', fit) && is('update', update) ? column('level') : NaN
array labels[4] = ['size / smallest of its kind', 'nodes visited at the level', 'false candidates per true candidate', \
                   'query down to the level [us]']
y(panel) = panel == 1 ? column('tightness') : panel == 2 ? column('visited') : panel == 3 ? column('false_per_true') : \
           1e6 * column('query_s')
do for [panel = 1:4] {
  set ylabel labels[panel]
  if (panel > 1) { set logscale y }
  if (panel > 2) { set xlabel 'level (0 is the root)' }
  plot table using (here('sphere', 'centroid', 'rebuild')):(y(panel)) with linespoints lw 1.5 ps 0.9 pt 7 lc rgb blue \
         title 'sphere, rebuild', \
       '' using (here('sphere', 'centroid', 'merge')):(y(panel)) with linespoints lw 1.5 ps 0.9 pt 6 dt 2 lc rgb sky \
         title 'sphere, merge', \
       '' using (here('sphere', 'welzl', 'rebuild')):(y(panel)) with linespoints lw 1.5 ps 0.9 pt 4 dt 3 lc rgb black \
         title 'smallest sphere', \
       for [volume in 'aabb kdop18 obb'] '' using (here(volume, 'none', 'rebuild')):(y(panel)) with linespoints lw 1.5 \
         ps 0.9 pt (volume eq 'aabb' ? 5 : volume eq 'obb' ? 13 : 9) lc rgb colour_of(volume) title volume
  unset key
}
unset multiplot
