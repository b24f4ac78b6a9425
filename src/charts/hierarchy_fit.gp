# Time of a frame against accuracy: a panel for each scene, a line for each volume and update policy, a point for each
# leaf size. scenes, particles_SCENE; volumes, updates: what was measured; brute: 1 if brute force was
# resampled: 1 for cloths with more particles than their scenes have
eval paper(1280, 560)
set multiplot layout 1,words(scenes) margins 0.07,0.985,0.22,0.87 spacing 0.05,0 \
  title 'Time of a frame against accuracy, '.(resampled ? 'scenes resampled to 128 x 128 particles' : 'scenes as they are') font ',13'
eval room_about_data
eval legend(0.065)
set logscale xy
set xtics (0.01, 0.1, 1, 10, 100, 1000)
set ytics (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000)
set xlabel 'false candidates per true candidate'
set ylabel 'build + query + exact test [us]'
fit_of(volume) = volume eq 'sphere' ? 'centroid' : 'none'
here(volume, update) = is('part', 'fit') && is('scene', scene) && column('particles') == particles && \
  is('volume', volume) && is('sphere_fit', fit_of(volume)) && is('update', update)
do for [scene in scenes] {
  particles = value('particles_'.scene)
  set title readable(scene)
  plot for [volume in volumes] for [update in updates] table \
         using (only(here(volume, update), column('false_per_true'))):(1e6 * column('whole_s')) \
         with linespoints lw 1 pt marker_of(update) ps 0.8 lc rgb colour_of(volume) notitle, \
       for [one = 1:brute] '' using (only(here('brute', 'rebuild'), column('false_per_true'))):(1e6 * column('whole_s')) \
         with points pt 3 ps 1.5 lw 2 lc rgb black title 'brute force', \
       for [volume in volumes] keyentry with lines lw 4 lc rgb colour_of(volume) title volume, \
       for [update in updates] keyentry with points pt marker_of(update) lc rgb grey title update
  unset key
  set ylabel ''
}
unset multiplot
