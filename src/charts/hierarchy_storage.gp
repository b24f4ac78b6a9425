# caption: CPU time of build, query and exact test of a frame against the bytes of the tree's volumes. A line joins the
# caption: leaf sizes of one volume, each rebuilt every frame; beside it the bytes a node.
# bytes: 'VOLUME BYTES ...', what a node takes
drawn = "(is('part', 'fit') && column('particles') == 128 * 128 && is('update', 'rebuild') && !is('volume', 'brute') && \
  (!is('volume', 'sphere') || is('sphere_fit', 'centroid')))"
scenes = ''; volumes = ''
stats table using (@drawn ? (scenes = listed(scenes, strcol('scene')), volumes = listed(volumes, strcol('volume')), 0) : 0) nooutput
if (scenes eq '') { exit status 3 }
eval paper(430)
bytes_of(volume) = word(bytes, 1 + place(bytes, volume))
colour(volume) = volume eq 'kdop6' ? orange : volume eq 'kdop26' ? grey : colour_of(volume)
title_of(volume) = volume[1:4] eq 'kdop' ? volume[5:*].'-DOPs' : title_of_volume(volume)
# Six of them: the fourth k-DOP lies between the others
shown = ''
do for [volume in volumes] { if (volume ne 'kdop14') { shown = shown.' '.volume } }
here(scene, volume) = @drawn && is('scene', scene) && is('volume', volume)
kib = "(column('nodes') * (bytes_of(strcol('volume')) + 0) / 1024)"
time = "(1e6 * column('whole_s'))"
# The fastest trees of spheres and of boxes: time and storage of the former over that of the latter
array best_time[2]; array best_size[2]
better(k) = @time < best_time[k] ? (best_time[k] = @time, best_size[k] = @kib, 0) : 0
time_least = 1e9; time_most = 0; size_least = 1e9; size_most = 0
x_low = 1e9; x_high = 0; y_low = 1e9; y_high = 0
seen(x, y) = (x_low = least(x_low, x), x_high = most(x_high, x), y_low = least(y_low, y), y_high = most(y_high, y), 0)
do for [scene in scenes] {
  best_time[1] = 1e9; best_time[2] = 1e9
  stats table using (!@drawn ? 0 : (seen(@kib, @time), here(scene, 'sphere') ? better(1) : here(scene, 'aabb') ? better(2) : 0)) nooutput
  if (best_time[1] < 1e9 && best_time[2] < 1e9) {
    time_least = least(time_least, best_time[1] / best_time[2]); time_most = most(time_most, best_time[1] / best_time[2])
    size_least = least(size_least, best_size[2] / best_size[1]); size_most = most(size_most, best_size[2] / best_size[1])
  }
}
eval headline(time_most > 0 ? sprintf('Boxes take %.1f times the storage of spheres, whose best trees take %.1f to %.1f times as long', size_most, \
  time_least, time_most) : 'Time of a frame and storage of the tree', \
  '16384 particles, every tree rebuilt in every frame; each line from large leaves to small ones; beside it the bytes of a node')
# Names with the bytes of a node, in the order of the right ends
eval forget
do for [k = 1:words(shown)] {
  stats table using (@drawn ? last(k, here(word(scenes, words(scenes)), word(shown, k)), @kib, @time) : 0) nooutput
  if (end_x[k] == end_x[k]) { end_x[k] = x_high * 1.2 }
}
eval spread(gap_of(y_low / 1.3, y_high * 1.3, 285))
eval panels(1, words(scenes), 74, 185, 55, 90, 20, 0)
set logscale xy
set format xy '%g'
set xtics (10, 100, 1000)
set xlabel 'volumes of the tree [KiB]'
set ylabel 'time of a frame [us]'
set xrange [x_low / 1.5:x_high * 1.5]
set yrange [y_low / 1.3:y_high * 1.3]
do for [s = 1:words(scenes)] {
  scene = word(scenes, s)
  set title readable(scene) offset 0,-0.3
  do for [k = 1:(s == words(scenes) ? words(shown) : 0)] {
    eval label_at(k, sprintf('%s, %s bytes', title_of(word(shown, k)), bytes_of(word(shown, k))), \
      colour(word(shown, k)), 'left')
  }
  plot for [volume in shown] table using (only(here(scene, volume), @kib)):@time with linespoints lw 1.5 pt 7 ps 0.7 \
    lc rgb colour(volume)
  eval no_headline
  set ylabel ''
  set format y ''
}
unset multiplot
