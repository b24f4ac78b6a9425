# What response and fail-safe leave, against the step: a column of panels for each fail-safe, and for none.
# thicknesses: of the sheets [mm]
set datafile missing NaN
eval paper(1100, 1080)
set multiplot layout 4,3 margins 0.085,0.985,0.115,0.93 spacing 0.03,0.04 \
  title 'Cloth against cloth: a sheet thrown at another at 8 m/s' font ',13'
eval room_about_data
set offsets graph 0.05, graph 0.05, 0, 0
eval legend(0.025)
set logscale x
set xrange [0.2:22]
set xtics (0.25, 0.5, 1, 2, 4, 8, 16)
number(word) = word + 0
colour(mm) = mm < 0.2 ? pink : mm < 1 ? red : mm < 4 ? blue : green
marker(mm) = mm < 0.2 ? 13 : mm < 1 ? 9 : mm < 4 ? 7 : 5
here(mm, safe) = is('fail_safe', safe) && abs(1e3 * column('thickness_m') - mm) < 1e-6
most(a, b) = a > b ? a : b
# The logarithmic axis has no zero: what is less than its least is drawn there
figure(panel) = panel == 1 ? 100 * column('crossed_steps') : \
               panel == 2 ? 100 * column('penetration_m') / column('thickness_m') : \
               panel == 3 ? 100 * column('momentum_error') : most(column('pair_tests'), 1e3)
do for [panel = 1:4] {
  unset logscale y
  if (panel == 4) { set logscale y; set yrange [700:4e7] } else { set yrange [-4:104] }
  do for [safe in 'zones rejection none'] {
    unset title
    if (panel == 1) { set title safe eq 'none' ? 'no fail-safe' : safe eq 'zones' ? 'impact zones' : 'rejected steps' }
    if (panel == 4) { set xlabel 'step [ms]' }
    set format y safe ne 'zones' ? '' : panel == 4 ? '10^{%T}' : '%g'
    set ylabel safe ne 'zones' ? '' : panel == 1 ? 'steps with crossings [%]' : panel == 2 ? 'penetration / thickness [%]' : \
               panel == 3 ? 'error of momentum [%]' : 'tests of pairs a step'
    plot for [mm in thicknesses] table using (only(here(number(mm), safe), 1e3 * column('step_s'))):(figure(panel)) \
           with linespoints lw 1.5 pt marker(number(mm)) ps 0.8 lc rgb colour(number(mm)) title mm.' mm thick', \
         for [mm in thicknesses] '' using \
           (only(here(number(mm), safe) && column('unsearched_steps') > 0, 1e3 * column('step_s'))):(figure(panel)) \
           with points pt 6 ps 2 lw 1.5 lc rgb black notitle, \
         keyentry with points pt 6 ps 1.6 lw 1.5 lc rgb black title 'the search gave up'
    unset key
  }
}
unset multiplot
