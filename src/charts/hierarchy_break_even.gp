# caption: Left: CPU time of build, query and exact test of all frames so far, over that of rebuilding; where a line
# caption: crosses 1 is its break-even frame. Right: the same ratio after the last frame, over the time that the cloth
# caption: has had to move between frames, and how loose a tree is that is kept.
# scene
of_scene = "(is('part', 'break_even') && is('scene', scene))"
here(volume, update) = @of_scene && is('volume', volume) && is('update', update)
# Which were measured; the interval [s] next to the rate of a screen, or what is there in a share of the cases
volumes = ''; updates = ''; frames = 0; interval = 1e9
off(seconds) = abs(seconds - 1. / 60)
stats table using (!@of_scene ? 0 : (updates = listed(updates, strcol('update')), frames = most(frames, column('frame')), \
  interval = off(column('interval_s')) < off(interval) ? column('interval_s') : interval, \
  is('volume', 'sphere') || is('volume', 'aabb') ? (volumes = listed(volumes, strcol('volume'))) : 0, 0)) nooutput
if (volumes eq '') { exit status 3 }
eval paper(120 + 250 * words(volumes))
at_interval(volume, update) = here(volume, update) && abs(column('interval_s') - interval) < 1e-9
at_end(volume, update) = here(volume, update) && column('frame') == frames
ratio = "(column('cumulative_s_over_rebuild_s'))"
# The ratio of merging after the last frame, at this interval, by volume, and how loose a tree becomes that is kept
array merged[4]; array loose[4]
shortest = 1e9; longest = 0
least_merged = 1e9; most_merged = 0
do for [v = 1:words(volumes)] {
  merged[v] = NaN; loose[v] = NaN
  stats table using (@of_scene ? (shortest = least(shortest, 1e3 * column('interval_s')), \
    longest = most(longest, 1e3 * column('interval_s')), 0) : 0) nooutput
  stats table using (at_interval(word(volumes, v), 'merge') && column('frame') == frames ? (merged[v] = @ratio, \
    least_merged = least(least_merged, @ratio), most_merged = most(most_merged, @ratio), 0) : \
    at_interval(word(volumes, v), 'none') && column('tightness') == column('tightness') ? (loose[v] = column('tightness'), 0) : 0) nooutput
}
eval headline(most_merged > 0 ? sprintf('After %d frames merging has cost %.0f to %.0f %% of rebuilding', frames, 100 * least_merged, \
  100 * most_merged) : sprintf('Cost of the updates over that of rebuilding, after %d frames', frames), \
  sprintf('%s, 64 x 64 particles; cost of all frames so far, with search and exact test, over that of rebuilding in each', \
  capital(readable(scene))))
eval panels(words(volumes), 2, 75, 140, 55, 90, 70, 85)
set logscale y
set yrange [0.03:25]
set ytics (0.03, 0.1, 0.3, 1, 3, 10)
update_name(update, v) = update eq 'none' ? (loose[v] == loose[v] ? sprintf('kept, %.0fx too large', loose[v]) : 'kept') : update
do for [v = 1:words(volumes)] {
  volume = word(volumes, v)
  eval forget
  set title sprintf('%s, frames %.3g ms apart', title_of_volume(volume), 1e3 * interval) offset 0,-0.3
  set xlabel v == words(volumes) ? 'frame' : ''
  set xrange [0:1.02 * frames]
  set ylabel 'cost / cost of rebuild'
  plot for [update in updates] table using (only(at_interval(volume, update), column('frame'))):@ratio with linespoints lw 1.5 \
    ps 0.7 pi 10 pt marker_of(update) lc rgb colour_of_update(update)
  eval no_headline
  set title sprintf('%s, after %d frames', title_of_volume(volume), frames) offset 0,-0.3
  set logscale x
  set xrange [shortest / 1.3:longest * 1.3]
  set xlabel v == words(volumes) ? 'time between frames [ms]' : ''
  set ylabel ''
  do for [k = 1:words(updates)] {
    stats table using (last(k, at_end(volume, word(updates, k)), 1e3 * column('interval_s'), @ratio)) nooutput
  }
  eval spread(gap_of(0.03, 25, 165))
  do for [k = 1:words(updates)] {
    eval label_at(k, update_name(word(updates, k), v), colour_of_update(word(updates, k)), 'left')
  }
  plot for [update in updates] table using (only(at_end(volume, update), 1e3 * column('interval_s'))):@ratio with linespoints \
    lw 1.5 ps 0.9 pt marker_of(update) lc rgb colour_of_update(update)
  unset logscale x
}
unset multiplot
