# caption: CPU time of a step of backward Euler at 1/60 s against the particles, on one core: while the sheet falls
# caption: flat, and once it swings in folds.
eval paper(430)
eval frame(70, 190, 55, 70)
set logscale xy
set format y '%g'
set xlabel 'particles'
set ylabel 'CPU time of a step [ms]'
set xrange [850:7e4]
set xtics ('1000' 1e3, '2000' 2e3, '5000' 5e3, '10 000' 1e4, '20 000' 2e4, '50 000' 5e4)
here(time) = is('part', 'size') && column('time_s') == time
time_of(k) = k == 1 ? 0.2 : 1
# From the smallest cloth to the largest; the lines of theory start where the smallest falls
n_least = NaN; n_most = NaN; t_least = NaN
exponent(k) = end_x[k] > x_first ? log(end_y[k] / y_first) / log(end_x[k] / x_first) : NaN
array power[2]
eval forget
do for [k = 1:2] {
  stats table using (first(k, here(time_of(k)), column('side')**2, 1e3 * column('cost_s'))) nooutput
  x_first = end_x[k]; y_first = end_y[k]
  if (k == 1) { n_least = x_first; t_least = y_first }
  stats table using (last(k, here(time_of(k)), column('side')**2, 1e3 * column('cost_s'))) nooutput
  power[k] = exponent(k)
  if (k == 1) { n_most = end_x[1] }
}
theory(x, its_power) = x < n_least || x > n_most ? NaN : t_least * (x / n_least)**its_power
do for [k = 3:4] { end_x[k] = n_most; end_y[k] = theory(n_most, k == 3 ? 1 : 1.5) }
eval headline(sprintf('The time of an implicit step grows as n^{%.2f}  in a fall, as n^{%.2f}  in folds', power[1], power[2]), \
  'Backward Euler at 1/60 s, solved by multigrid. A sparse factorisation of a grid of n particles takes n^{1.5}')
eval spread(0.09)
eval label_at(1, sprintf('falling: n^{%.2f}', power[1]), blue, 'left')
eval label_at(2, sprintf('in folds: n^{%.2f}', power[2]), red, 'left')
eval label_at(3, 'in proportion: n', grey, 'left')
eval label_at(4, 'n^{1.5}', grey, 'left')
set label 11 '60 frames a second' at n_least, 1e3 / 60 offset 1,0.6 tc rgb grey
set samples 300
plot theory(x, 1) with lines dt 3 lc rgb grey, theory(x, 1.5) with lines dt 3 lc rgb grey, \
     1e3 / 60 with lines dt 2 lc rgb grey, \
     table using (only(here(0.2), column('side')**2)):(1e3 * column('cost_s')) with linespoints lw 2 pt 7 lc rgb blue, \
     '' using (only(here(1), column('side')**2)):(1e3 * column('cost_s')) with linespoints lw 2 pt 5 lc rgb red
