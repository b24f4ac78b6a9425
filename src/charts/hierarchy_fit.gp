# caption: CPU time of build, query and exact test of a frame against the cells that are tested in vain, for each cell
# caption: that touches the ball. A line joins the leaf sizes of one volume, rebuilt, or merged where that is the fastest;
# caption: the nearer to the lower left, the better.
# Of cloths as their scenes have them, or with more particles: of spheres, those about the centroid; all volumes rebuilt,
# and what is fastest: merged boxes
resampled = name eq 'hierarchy_fit_128'
drawn = "(is('part', 'fit') && (column('particles') == 128 * 128) == resampled && \
  (is('sphere_fit', 'centroid') || place('aabb kdop18 obb brute', strcol('volume')) > 0) && \
  (is('update', 'rebuild') || (is('volume', 'aabb') && is('update', 'merge'))))"
here(scene, volume, update) = @drawn && is('scene', scene) && is('volume', volume) && is('update', update)
scenes = ''; volumes = ''; updates = ''; brute = 0
stats table using (!@drawn ? 0 : (scenes = listed(scenes, strcol('scene')), updates = listed(updates, strcol('update')), \
  is('volume', 'brute') ? (brute = 1) : (volumes = listed(volumes, strcol('volume'))), 0)) nooutput
if (scenes eq '') { exit status 3 }
eval paper(470)
lines = ''
do for [volume in volumes] { lines = lines.' '.volume.':rebuild' }
if (place(updates, 'merge') > 0) { lines = lines.' aabb:merge' }
volume_in(line) = line[1:strstrt(line, ':') - 1]
update_in(line) = line[strstrt(line, ':') + 1:*]
dash(line) = update_in(line) eq 'merge' ? 2 : 1
x = "column('false_per_true')"
time = "(1e6 * column('whole_s'))"
# From the smallest leaves to the largest, over all volumes that are rebuilt
slower_least = 1e9; slower_most = 0; kept_least = 1e9; kept_most = 0; array ends[2]; array cells[2]
x_low = 1e9; x_high = 0; y_low = 1e9; y_high = 0
seen(x, y) = (x_low = least(x_low, x), x_high = most(x_high, x), y_low = least(y_low, y), y_high = most(y_high, y), 0)
# Of each scene, the fastest tree of those drawn, and brute force
array fastest[6]; array forced[6]
do for [s = 1:words(scenes)] {
  scene = word(scenes, s)
  fastest[s] = 1e9; forced[s] = NaN
  do for [line in lines] {
    small = 1e9; large = 0; ends[1] = NaN; ends[2] = NaN
    stats table using (!here(scene, volume_in(line), update_in(line)) ? 0 : (fastest[s] = least(fastest[s], @time), seen(@x, @time), \
      column('leaf_cells') < small ? (small = column('leaf_cells'), ends[1] = @time, cells[1] = @x) : 0, \
      column('leaf_cells') > large ? (large = column('leaf_cells'), ends[2] = @time, cells[2] = @x) : 0, 0)) nooutput
    if (update_in(line) eq 'rebuild' && ends[1] == ends[1]) {
      slower_least = least(slower_least, ends[1] / ends[2]); slower_most = most(slower_most, ends[1] / ends[2])
      kept_least = least(kept_least, cells[1] / cells[2]); kept_most = most(kept_most, cells[1] / cells[2])
    }
  }
  stats table using (here(scene, 'brute', 'rebuild') ? (forced[s] = @time, seen(@x, @time), 0) : 0) nooutput
}
eval headline(sprintf('Small leaves leave %.1f to %.0f %% of the false candidates of large ones, for %.0f to %.0f times the time', 100 * kept_least, \
  100 * kept_most, slower_least, slower_most), \
  (resampled ? '128 x 128 particles' : 'Scenes as they are').'. Each line from small leaves, on the left, to large ones; rebuilt in every frame but where merged')
eval panels(1, words(scenes), 74, 15, 55, 110, 20, 0)
set logscale xy
set format xy '%g'
set xrange [x_low / 1.5:x_high * 1.6]
set yrange [y_low / 1.4:y_high * 1.6]
set ytics (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000)
set xlabel 'false candidates / true one'
set ylabel 'build + query + exact test [us]'
verdict(s) = forced[s] != forced[s] ? '' : forced[s] < fastest[s] ? \
  sprintf(": brute force is\n%.1f times faster than these trees", fastest[s] / forced[s]) : \
  sprintf(": the best of these trees is\n%.1f times faster than brute force", forced[s] / fastest[s])
do for [s = 1:words(scenes)] {
  scene = word(scenes, s)
  set title readable(scene).verdict(s) offset 0,-0.3
  do for [k = 1:(s == 1 ? words(lines) : 0)] {
    line = word(lines, k)
    set label k title_of_volume(volume_in(line)).(update_in(line) eq 'merge' ? ', merged (dashed)' : '') at graph 0.05, graph 0.36 - 0.06 * k \
      left tc rgb ink(colour_of(volume_in(line)))
  }
  if (s == 1 && brute) { set label 12 'brute force (star)' at graph 0.05, graph 0.36 left }
  plot for [line in lines] table using (only(here(scene, volume_in(line), update_in(line)), @x)):@time \
         with linespoints lw 1.5 dt dash(line) pt marker_of(update_in(line)) ps 0.8 lc rgb colour_of(volume_in(line)), \
       for [one = 1:brute] '' using (only(here(scene, 'brute', 'rebuild'), @x)):@time with points pt 3 ps 1.5 lw 2 lc rgb black
  eval no_headline
  unset label
  set ylabel ''
  set format y ''
}
unset multiplot
