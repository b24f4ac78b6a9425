# Errors of contact against time: a column of panels for each search, a line for each speed of the ball.
# searches: the numbers of tests after which a search ends, 0 for the full one; speeds: of the ball [m/s]
# Lines continue across rows of others
set datafile missing NaN
eval paper(1280, 760)
set multiplot layout 2,words(searches) margins 0.07,0.985,0.165,0.9 spacing 0.04,0.06 \
  title 'Accuracy of contact: a ball that moves through a hung cloth' font ',13'
eval room_about_data
set offsets graph 0.05, graph 0.05, 0, 0
eval legend(0.035)
set logscale x
set xtics (0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5)
colour(speed) = speed < 1 ? pink : speed < 4 ? blue : speed < 16 ? green : red
marker(speed) = speed < 1 ? 13 : speed < 4 ? 7 : speed < 16 ? 5 : 9
here(speed) = is('tests', tests) && column('speed_m_per_s') == speed
# The lower axis has no zero: what is less than a millimetre is drawn there
error(panel) = panel == 1 ? 100 * column('missed_contacts') : column('penetration_m') > 1e-3 ? \
               1e3 * column('penetration_m') : 1
do for [panel = 1:2] {
  set ylabel panel == 1 ? 'missed contacts [%]' : 'worst penetration [mm], at least 1'
  if (panel == 1) { set yrange [-4:104] } else {
    set logscale y
    set yrange [0.8:250]
    set xlabel 'CPU time per simulated second [s]'
    unset title
  }
  do for [tests in searches] {
    if (panel == 1) { set title tests eq '0' ? 'full search' : 'search ends after '.tests.' volume tests' }
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
