# caption: The part of the shots that pass a target unseen, against the diameters that the ball moves in a step: by
# caption: discrete detection, beside what is predicted for it, and by continuous detection.
targets = ''
stats table using (is('part', 'misses') ? (targets = listed(targets, strcol('target')), 0) : 0) nooutput
eval paper(430)
eval frame(65, 30, 55, 70)
set logscale x
set xlabel 'diameters of the ball in a step, q = v dt / (2 R)'
set xtics (0.125, 0.25, 0.5, 1, 2, 4, 8, 16, 32, 64)
set ylabel 'missed [%]'
set xrange [0.1:100]
set yrange [-4:104]
colour(target) = target eq 'point' ? blue : red
marker(target) = target eq 'point' ? 7 : 5
here(target) = is('part', 'misses') && is('target', target)
point(q) = q <= 1 ? q * q / 3 : 1 - 2 / (3 * q)
sheet(q) = q <= 1 ? 0 : 1 - 1 / q
unseen = 0; apart = 0
stats table using (is('part', 'misses') ? (unseen = most(unseen, column('continuous_missed')), \
  apart = most(apart, abs(column('discrete_missed') - column('predicted'))), 0) : 0) nooutput
predicted = apart < 0.02
eval headline(unseen > 0 || !predicted ? sprintf('The continuous test misses up to %.2g %% of the shots; the discrete one is up to %.2g %% off theory', 100 * unseen, 100 * apart) : \
  'The continuous test misses no shot; the discrete one misses what geometry predicts', \
  sprintf('Lines: predicted; marks: measured, at most %.2f percentage points from them', 100 * apart))
set samples 500
set label 1 'discrete, a point: q^2/3, then 1 - 2/(3q)' at 1.25,46 right offset -1.5,0.4 tc rgb blue
set label 2 'discrete, a sheet: 0, then 1 - 1/q' at 2,50 left offset 1.2,-0.5 tc rgb red
set label 3 (unseen > 0 ? 'continuous' : 'continuous: none of either') at 4,0 left offset 0,0.9
plot point(x) * 100 with lines lw 1.5 lc rgb blue, sheet(x) * 100 with lines lw 1.5 dt 2 lc rgb red, \
     for [target in targets] table using (only(here(target), column('q'))):(100 * column('discrete_missed')) \
       with points ps 0.9 pt marker(target) lc rgb colour(target), \
     for [target in targets] '' using (only(here(target), column('q'))):(100 * column('continuous_missed')) \
       with points ps 1.4 pt marker(target) - 1 lc rgb black
