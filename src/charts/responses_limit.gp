# caption: The longest step at which a penalty does not throw off a sheet that rests on it, against its stiffness: lines
# caption: as predicted, points as measured.
eval paper(430)
eval frame(70, 160, 55, 70)
set logscale xy
set format x '10^{%T}'
set format y '%g'
set xlabel 'stiffness of the penalty [N/m]'
set ylabel 'longest stable step [ms]'
set xrange [5:2e5]
restitutions = '0 0.5 1'
colour(e) = e == 0 ? blue : e < 1 ? green : red
marker(e) = e == 0 ? 6 : e < 1 ? 8 : 4
here(e) = is('part', 'limit') && column('restitution') == e
measured = "(1e3 * column('measured_step_s'))"
predicted = "(1e3 * column('predicted_step_s'))"
ratio_least = 1e9; ratio_most = 0
stats table using (is('part', 'limit') ? (ratio_least = least(ratio_least, @measured / @predicted), \
  ratio_most = most(ratio_most, @measured / @predicted), 0) : 0) nooutput
eval forget
stats table using (first(1, here(0), column('stiffness_N_per_m'), @measured)) nooutput
stats table using (last(2, here(0), column('stiffness_N_per_m'), @measured)) nooutput
falls = 'The longest step of a penalty '
if (end_x[2] > end_x[1]) {
  falls = falls.sprintf('falls as k^{%.2g} , and ', log(end_y[2] / end_y[1]) / log(end_x[2] / end_x[1]))
}
eval headline(falls.sprintf('is %.2g to %.2g times the predicted one', ratio_least, ratio_most), \
  'Marks: measured; lines: predicted, of a spring that also pulls')
eval forget
do for [k = 1:3] { stats table using (last(k, here(word(restitutions, k) + 0), column('stiffness_N_per_m'), @predicted)) nooutput }
eval spread(0.16)
do for [k = 1:3] { eval label_at(k, 'restitution '.word(restitutions, k), colour(word(restitutions, k) + 0), 'left') }
plot for [e in restitutions] table using (only(here(e + 0), column('stiffness_N_per_m'))):@predicted \
       with lines lw 1.5 lc rgb colour(e + 0), \
     for [e in restitutions] '' using (only(here(e + 0), column('stiffness_N_per_m'))):@measured \
       with points ps 1.5 lw 1.5 pt marker(e + 0) lc rgb colour(e + 0)
