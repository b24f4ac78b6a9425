# What fits of spheres cost and how tight they are: a panel for each scene.
# scenes, particles_SCENE; fits, updates: what was measured
eval paper(1280, 520)
set multiplot layout 1,words(scenes) margins 0.07,0.985,0.235,0.86 spacing 0.05,0 \
  title 'Sphere fits, leaves of at most 4 x 4 cells' font ',13'
eval room_about_data
eval legend(0.065)
set logscale y
set ytics (1, 2, 5, 10, 20, 50, 100, 200, 500)
set xtics 0.01
set xlabel 'mean radius / radius of the smallest sphere'
set ylabel 'build [us]'
colour(fit) = fit eq 'centroid' ? blue : fit eq 'box' ? sky : fit eq 'ritter' ? red : fit eq 'epos6' ? orange : \
              fit eq 'epos14' ? green : fit eq 'epos26' ? pink : black
here(fit, update) = is('part', 'fit') && is('scene', scene) && column('particles') == value('particles_'.scene) && \
  column('leaf_cells') == 4 && is('sphere_fit', fit) && is('update', update)
do for [scene in scenes] {
  set title readable(scene)
  plot for [fit in fits] for [update in updates] table \
         using (only(here(fit, update), column('tightness'))):(1e6 * column('build_s')) \
         with points pt marker_of(update) ps 1.3 lc rgb colour(fit) notitle, \
       for [fit in fits] keyentry with lines lw 4 lc rgb colour(fit) title fit, \
       for [update in updates] keyentry with points pt marker_of(update) lc rgb grey title update
  unset key
  set ylabel ''
}
unset multiplot
