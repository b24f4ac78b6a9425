# Shots that are missed, against the ball's diameters a step.
# targets: what was shot at
set datafile missing NaN
eval paper(760, 520)
set title 'Shots that pass unseen' font ',13'
set lmargin at screen 0.1
set bmargin at screen 0.235
eval legend(0.065)
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
set samples 500
plot point(x) * 100 with lines lw 1.5 lc rgb blue title 'predicted, point', \
     sheet(x) * 100 with lines lw 1.5 dt 2 lc rgb red title 'predicted, sheet', \
     for [target in targets] table using (only(here(target), column('q'))):(100 * column('discrete_missed')) \
       with points ps 0.9 pt marker(target) lc rgb colour(target) title 'discrete, '.target, \
     for [target in targets] table using (only(here(target), column('q'))):(100 * column('continuous_missed')) \
       with points ps 1.4 pt marker(target) - 1 lc rgb black title 'continuous, '.target
