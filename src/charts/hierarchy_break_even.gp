# The total cost of the update policies, frame by frame and by the time between frames.
# scene; volumes, updates: which were measured; interval: between frames on the left [s]; frames: how many
# Lines continue across rows of others
set datafile missing NaN
eval paper(1280, 800)
set multiplot layout 2,3 margins 0.07,0.985,0.155,0.91 spacing 0.075,0.15 \
  title 'Total cost of the update policies: '.readable(scene).', 64 x 64 particles' font ',13'
eval room_about_data
eval legend(0.04)
here(volume, update) = is('part', 'break_even') && is('scene', scene) && is('volume', volume) && is('update', update)
at_interval(volume, update) = here(volume, update) && column('interval_s') == interval ? column('frame') : NaN
at_end(volume, update) = here(volume, update) && column('frame') == frames ? 1e3 * column('interval_s') : NaN
apart = sprintf(', frames %.3g ms apart', 1e3 * interval)
ratio = 'cumulative_s_over_rebuild_s'
do for [volume in volumes] {
  unset logscale
  set title volume.apart
  set xlabel 'frame'
  set ylabel 'cost so far / cost of rebuild'
  set yrange [0:*]
  plot for [update in updates] table using (at_interval(volume, update)):(column(ratio)) with linespoints lw 1.5 \
    ps 0.6 pi 5 pt marker_of(update) lc rgb colour_of_update(update) title update
  unset key
  set ylabel 'size / smallest of its kind'
  set logscale y
  set yrange [*:*]
  plot for [update in updates] table using (at_interval(volume, update)):(column('tightness')) with linespoints \
    lw 1.5 ps 0.6 pt marker_of(update) lc rgb colour_of_update(update) title update
  set title sprintf('%s, after %d frames', volume, frames)
  set logscale x
  unset logscale y
  set yrange [0:*]
  set xlabel 'time between frames [ms]'
  set ylabel 'cost / cost of rebuild'
  plot for [update in updates] table using (at_end(volume, update)):(column(ratio)) with linespoints lw 1.5 ps 0.9 \
    pt marker_of(update) lc rgb colour_of_update(update) title update
}
unset multiplot
