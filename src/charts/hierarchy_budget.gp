# How a search that ends early changes the motion.
# scenes
eval paper(1280, 520)
set multiplot layout 1,3 margins 0.07,0.985,0.235,0.88 spacing 0.07,0 \
  title 'A search that ends after a number of volume tests (spheres, leaves of 4 x 4 cells)' font ',13'
eval room_about_data
eval legend(0.065)
set key maxrows 3
set logscale x
set format y '%g'
set xlabel 'volume tests allowed, or made, in a frame'
colour(k) = word(blue.' '.red.' '.green, k)
marker(k) = k == 1 ? 7 : k == 2 ? 5 : 9
here(k) = is('part', 'budget') && is('scene', word(scenes, k)) && is('volume', 'sphere')
# The first axis has no zero: what is less than a hundredth of a millimetre is drawn there
missed_mm(penetration) = penetration > 1e-5 ? 1e3 * penetration : 0.01
y(panel) = panel == 1 ? missed_mm(column('missed_penetration_m')) : panel == 2 ? column('false_contacts') : 1e3 * column('distance_m')
array labels[3] = ['deepest missed penetration [mm]', 'false contacts per step', 'RMS distance at the end [mm]']
set logscale y
do for [panel = 1:3] {
  set ylabel labels[panel]
  plot for [k = 1:words(scenes)] table using (only(here(k), column('tests'))):(y(panel)) with linespoints lw 1.5 \
         pt marker(k) lc rgb colour(k) title readable(word(scenes, k)), \
       for [k = 1:words(scenes)] '' using (only(here(k) && column('level') >= 0, column('visited'))):(y(panel)) \
         with points ps 1.4 lw 1.5 pt marker(k) - 1 lc rgb colour(k) \
         title readable(word(scenes, k)).', ended at a level'
  unset key
  unset logscale y
}
unset multiplot
