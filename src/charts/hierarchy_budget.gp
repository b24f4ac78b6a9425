# caption: How a search that ends early changes the simulated motion: the deepest penetration that is left,
# caption: nodes that were taken for contacts although nothing in them touches, and how far the cloth is at the end from
# caption: where the full search has it. At the right end of each line the search is full. Penetrations of less than
# caption: 0.01 mm are drawn as 0.01 mm.
scenes = ''
stats table using (is('part', 'budget') && is('volume', 'sphere') ? (scenes = listed(scenes, strcol('scene')), 0) : 0) nooutput
if (scenes eq '') { exit status 3 }
eval paper(450)
colour(k) = word(blue.' '.red.' '.green, k)
marker(k) = k == 1 ? 7 : k == 2 ? 5 : 9
here(k) = is('part', 'budget') && is('scene', word(scenes, k)) && is('volume', 'sphere') && column('tests') > 0
# From how many tests on nothing deeper than a millimetre is missed, and the motion is the same to a millimetre
deep = 0; array far[6]; far_least = 1e9; far_most = 0
do for [k = 1:words(scenes)] {
  far[k] = 0; enough = 1e9
  stats table using (here(k) ? (deep = column('missed_penetration_m') > 1e-3 ? most(deep, column('tests')) : deep, \
    far[k] = column('distance_m') > 1e-3 ? most(far[k], column('tests')) : far[k], 0) : 0) nooutput
  stats table using (here(k) && column('tests') > far[k] ? (enough = least(enough, column('tests')), 0) : 0) nooutput
  far_least = least(far_least, enough); far_most = most(far_most, enough)
}
eval headline(sprintf('After more than %.0f volume test%s no contact deeper than 1 mm is missed; the same motion takes %.0f to %.0f', deep, \
  deep == 1 ? '' : 's', far_least, far_most), \
  'A search of spheres about 4 x 4 cells ends after a number of tests, and what it has not opened pushes as spheres')
eval panels(1, 3, 75, 20, 55, 95, 60, 0)
set logscale x
set format y '%g'
set xlabel 'volume tests allowed in a frame'
# The first axis has no zero: what is less than a hundredth of a millimetre is drawn there
y(panel) = panel == 1 ? most(1e3 * column('missed_penetration_m'), 0.01) : panel == 2 ? column('false_contacts') : \
           1e3 * column('distance_m')
array labels[3] = ['deepest missed contact [mm]', 'false contacts a step', 'distance at the end [mm, RMS]']
set xrange [0.8:170]
set yrange [0.006:*]
set logscale y
set ytics (at_most('0.01') 0.01, 0.1, 1, 10, 100, 1000)
do for [panel = 1:3] {
  set title labels[panel] offset 0,-0.3
  if (panel == 3) {
    do for [k = 1:words(scenes)] { set label k readable(word(scenes, k)) at graph 0.55, graph 1 - 0.07 * k left tc rgb colour(k) }
  }
  plot for [k = 1:words(scenes)] table using (only(here(k), column('tests'))):(y(panel)) with linespoints lw 1.5 \
         pt marker(k) lc rgb colour(k)
  eval no_headline
  unset logscale y
  set yrange [0:*]
  set ytics autofreq
}
unset multiplot
