# Errors of contact against time: a column of panels for each search, a line for each speed of the ball.
# searches: SEARCH.TESTS, the number of tests after which a limited one ends; speeds: of the ball [m/s]
# Lines continue across rows of others
set datafile missing NaN
eval paper(830, 720)
set multiplot layout 3,words(searches) margins 0.085,0.985,0.15,0.91 spacing 0.035,0.05 \
  title 'Contact found and answered: a ball that moves through a hung cloth' font ',13'
eval room_about_data
set offsets graph 0.05, graph 0.05, 0, 0
eval legend(0.03)
set logscale x
set xrange [0.015:0.7]
set xtics (0.02, 0.1, 0.5)
colour(speed) = speed < 1 ? pink : speed < 4 ? blue : speed < 16 ? green : red
marker(speed) = speed < 1 ? 13 : speed < 4 ? 7 : speed < 16 ? 5 : 9
here(speed) = strcol('search').'.'.strcol('tests') eq search && column('speed_m_per_s') == speed
heading(search) = search[1:7] eq 'limited' ? search[9:*].' volume tests' : search[1:strlen(search) - 2]
most(a, b) = a > b ? a : b
# The logarithmic axes have no zero: what is less than their least is drawn there
error(panel) = panel == 1 ? 100 * column('missed_contacts') : \
               panel == 2 ? most(1e3 * column('left_m'), 0.1) : most(100 * column('momentum_error'), 1)
do for [panel = 1:3] {
  set ylabel panel == 1 ? 'missed contacts [%]' : panel == 2 ? 'left [mm], at least 0.1' : 'error of momentum [%], at least 1'
  if (panel == 1) { set yrange [-4:104] } else {
    set logscale y
    set yrange [(panel == 2 ? 0.08 : 0.8):300]
    unset title
  }
  if (panel == 3) { set xlabel 'CPU time per second [s]' }
  do for [search in searches] {
    if (panel == 1) { set title heading(search) }
    plot for [speed in speeds] table using (only(here(speed + 0), column('cpu_s_per_s'))):(error(panel)) \
           with linespoints lw 1.5 pt marker(speed + 0) ps 0.8 lc rgb colour(speed + 0) \
           title 'ball at '.speed.' m/s', \
         for [speed in speeds] '' using (only(here(speed + 0) && column('passed') == 1, column('cpu_s_per_s'))) \
           :(error(panel)) with points pt 6 ps 2 lw 1.5 lc rgb black notitle, \
         keyentry with points pt 6 ps 1.6 lw 1.5 lc rgb black title 'the ball has gone through'
    unset key
    set ylabel ''
  }
}
unset multiplot
