# caption: A sheet that is thrown at another, with impact zones or rejected steps as the fail-safe, and with none: the
# caption: steps that end with cloth across cloth, the error of the momentum that is passed on, and the tests of pairs,
# caption: against the step. Rings mark runs in which the search gave up.
# What response and fail-safe leave, against the step: a column of panels for each fail-safe, and for none.
thicknesses = ''  # of the sheets [mm]
stats table using (thicknesses = listed(thicknesses, sprintf('%.4g', 1e3 * column('thickness_m'))), 0) nooutput
eval paper(680)
number(word) = word + 0
colour(mm) = mm < 0.2 ? pink : mm < 1 ? red : mm < 4 ? blue : green
marker(mm) = mm < 0.2 ? 13 : mm < 1 ? 9 : mm < 4 ? 7 : 5
here(mm, safe) = is('fail_safe', safe) && abs(1e3 * column('thickness_m') - mm) < 1e-6
# The longest step up to which no step ends with a crossing: less than the shortest with one
array crossing[3]; array longest[3]
do for [k = 1:3] {
  safe = word('zones rejection none', k)
  crossing[k] = 1e9; longest[k] = 0
  stats table using (is('fail_safe', safe) && column('crossed_steps') > 0 ? (crossing[k] = least(crossing[k], column('step_s')), 0) : 0) nooutput
  stats table using (is('fail_safe', safe) && column('step_s') < crossing[k] ? (longest[k] = most(longest[k], column('step_s')), 0) : 0) nooutput
}
eval headline(sprintf('No crossing up to %.2g ms with impact zones, up to %.2g ms with rejection, up to %.2g ms with neither', \
  1e3 * longest[1], 1e3 * longest[2], 1e3 * longest[3]), \
  'A sheet is thrown at another at 8 m/s. Rings: the search gave up, and the sheets pass through each other')
eval panels(3, 3, 76, 90, 55, 95, 20, 30)
set logscale x
set xrange [0.2:22]
set xtics (0.25, 0.5, 1, 2, 4, 8, 16)
# The logarithmic axis has no zero: what is less than its least is drawn there
error = "(row == 1 ? 100 * column('crossed_steps') : row == 2 ? 100 * column('momentum_error') : most(column('pair_tests'), 1e3))"
do for [row = 1:3] {
  if (row == 3) { set logscale y; set yrange [700:4e7] } else { set yrange [-4:104] }
  do for [n = 1:3] {
    safe = word('zones rejection none', n)
    unset title
    if (row == 1) { set title (n == 1 ? 'impact zones' : n == 2 ? 'rejected steps' : 'no fail-safe') offset 0,-0.3 }
    set xlabel row == 3 ? 'step [ms]' : ''
    set format y n > 1 ? '' : row == 3 ? '10^{%T}' : '%g'
    if (row == 3 && n == 1) { set ytics (at_most('10^3') 1e3, '10^4' 1e4, '10^5' 1e5, '10^6' 1e6, '10^7' 1e7) }
    if (row == 3 && n == 2) { set ytics ('' 1e3, '' 1e4, '' 1e5, '' 1e6, '' 1e7) }
    set ylabel n > 1 ? '' : row == 1 ? 'steps with crossings [%]' : row == 2 ? 'error of momentum [%]' : 'tests of pairs a step'
    do for [k = 1:(row == 1 && n == 3 ? words(thicknesses) : 0)] {
      mm = word(thicknesses, k) + 0
      set label k word(thicknesses, k).' mm' at graph 1, graph 1.05 - 0.13 * k left offset 1.5,-0.3 point pt marker(mm) ps 0.8 \
        lc rgb colour(mm) tc rgb ink(colour(mm))
    }
    plot for [mm in thicknesses] table using (only(here(number(mm), safe), 1e3 * column('step_s'))):@error \
           with linespoints lw 1.5 pt marker(number(mm)) ps 0.8 lc rgb colour(number(mm)), \
         for [mm in thicknesses] '' using \
           (only(here(number(mm), safe) && column('unsearched_steps') > 0, 1e3 * column('step_s'))):@error \
           with points pt 6 ps 1.8 lw 1.5 lc rgb black
    unset label
  }
}
unset multiplot
