# caption: CPU time of a build against the mean tightness of its spheres. Rebuilding fits every node to its particles;
# caption: merging fits the leaves only and puts a sphere about the spheres below every other node.
drawn = "(is('part', 'fit') && column('particles') != 128 * 128 && is('volume', 'sphere') && column('leaf_cells') == 4 && \
  (is('update', 'rebuild') || is('update', 'merge')))"
scenes = ''; fits = ''; updates = ''
stats table using (@drawn ? (scenes = listed(scenes, strcol('scene')), fits = listed(fits, strcol('sphere_fit')), \
  updates = listed(updates, strcol('update')), 0) : 0) nooutput
if (scenes eq '') { exit status 3 }
eval paper(450)
colour(fit) = fit eq 'centroid' ? blue : fit eq 'box' ? sky : fit eq 'ritter' ? red : fit eq 'epos6' ? orange : \
              fit eq 'epos14' ? green : fit eq 'epos26' ? pink : black
here(fit, update) = @drawn && is('scene', scene) && is('sphere_fit', fit) && is('update', update)
# Of all scenes, how much larger than the smallest the spheres by the centroid are, rebuilt
loose = NaN
do for [scene in scenes] {
  stats table using (here('centroid', 'rebuild') ? (loose = loose > column('tightness') ? loose : column('tightness'), 0) : 0) nooutput
}
eval headline(loose == loose ? sprintf('Spheres about the centroid are at most %.1f %% larger than the smallest', 100 * (loose - 1)) : \
  'What fits of spheres cost', sprintf('Leaves of at most 4 x 4 cells. Circles: rebuilt%s', \
  words(updates) > 1 ? '; other marks: '.word(updates, 2) : ''))
eval panels(1, words(scenes), 65, 110, 55, 90, 20, 0)
eval room_about_data
set logscale y
set ytics (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000)
set xtics 0.01
set format y '%g'
set xlabel 'mean radius / smallest one'
set ylabel 'build [us]'
n = 0
do for [scene in scenes] {
  n = n + 1
  set title readable(scene) offset 0,-0.3
  do for [k = 1:(n == words(scenes) ? words(fits) : 0)] {
    set label k word(fits, k) at graph 1, graph 1.05 - 0.09 * k left offset 1.5,0 tc rgb ink(colour(word(fits, k)))
  }
  plot for [fit in fits] for [update in updates] table \
         using (only(here(fit, update), column('tightness'))):(1e6 * column('build_s')) \
         with points pt marker_of(update) ps 1.3 lc rgb colour(fit)
  eval no_headline
  set ylabel ''
  set format y ''
}
unset multiplot
