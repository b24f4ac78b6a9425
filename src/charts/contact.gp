# caption: Contacts that the reference has within a step and a run has not found, against the travel of the ball in a
# caption: step, and the deepest that the response leaves the ball in the cloth, against CPU time: the longest steps are
# caption: on the left there. A ball that has gone through counts with its radius. The reference tests every triangle
# caption: with a continuous search, at a step a hundred times smaller.
# Contacts that are missed, by the travel of the ball in a step, and what is left to the response against time: a column of
# panels for each search, a line for each speed of the ball.
# Of searches SEARCH.TESTS, the number of tests after which a limited one ends; speeds of the ball [m/s]
searches = ''; speeds = ''
stats table using (searches = listed(searches, strcol('search').'.'.strcol('tests')), \
  speeds = listed(speeds, strcol('speed_m_per_s')), 0) nooutput
eval paper(560)
# Of the ball, as contact_experiment.cpp has it [mm]
diameter = 300
colour(speed) = speed < 1 ? pink : speed < 4 ? blue : speed < 16 ? green : red
marker(speed) = speed < 1 ? 13 : speed < 4 ? 7 : speed < 16 ? 5 : 9
here(search, speed) = strcol('search').'.'.strcol('tests') eq search && column('speed_m_per_s') == speed
heading(search) = search[1:7] eq 'limited' ? 'ends after '.search[9:*].' tests' : search[1:strlen(search) - 2]
travel = "(1e3 * column('speed_m_per_s') * column('step_s'))"
missed = 0; through = 1e9
stats table using (is('search', 'continuous') ? (missed = most(missed, column('missed_contacts')), 0) : \
  is('search', 'discrete') && column('passed') == 1 ? (through = least(through, @travel), 0) : 0) nooutput
eval headline(sprintf('Continuous search misses at most %.1f %%; %s', 100 * missed, through < 1e9 ? \
  sprintf('a ball first gets past discrete search at %.0f mm a step', through) : 'nor does a ball pass the discrete one'), \
  'A ball that moves through a hung cloth; rings: it has gone through. Vertical line: its diameter')
eval panels(2, words(searches), 72, 15, 60, 95, 18, 75)
set logscale x
# The logarithmic axis has no zero: what is less than its least is drawn there
x = "(row == 1 ? 1e3 * column('speed_m_per_s') * column('step_s') : column('cpu_s_per_s'))"
error = "(row == 1 ? 100 * column('missed_contacts') : most(1e3 * column('left_m'), 0.1))"
set arrow 1 from diameter, graph 0 to diameter, graph 1 nohead lc rgb grey
do for [row = 1:2] {
  if (row == 2) { unset arrow }
  do for [n = 1:words(searches)] {
    search = word(searches, n)
    unset title
    set ylabel n > 1 ? '' : row == 1 ? 'missed contacts [%]' : 'penetration left [mm]'
    set format y n > 1 ? '' : '%g'
    if (row == 1) {
      set title heading(search) offset 0,-0.3
      set xlabel 'travel in a step [mm]'
      set xrange [0.15:1800]
      set xtics (1, 10, 100, 1000)
      set yrange [-4:104]
      do for [k = 1:(n == 1 ? words(speeds) : 0)] {
        set label k word(speeds, k).' m/s' at graph 0.06, graph 1 - 0.12 * k left point pt marker(word(speeds, k) + 0) ps 0.8 \
          lc rgb colour(word(speeds, k) + 0) offset 0.8,-0.3 tc rgb ink(colour(word(speeds, k) + 0))
      }
    } else {
      set xlabel 'CPU s / simulated s'
      set xrange [0.012:0.7]
      set xtics (0.02, 0.1, 0.5)
      set logscale y
      set yrange [0.07:300]
      if (n == 1) { set ytics (at_most("0.1") 0.1, 1, 10, 100) } else { set ytics ('' 0.1, '' 1, '' 10, '' 100) }
    }
    plot for [speed in speeds] table using (only(here(search, speed + 0), @x)):@error \
           with linespoints lw 1.5 pt marker(speed + 0) ps 0.8 lc rgb colour(speed + 0), \
         for [speed in speeds] '' using (only(here(search, speed + 0) && column('passed') == 1, @x)):@error \
           with points pt 6 ps 1.8 lw 1.5 lc rgb black
    unset label
  }
}
unset multiplot
