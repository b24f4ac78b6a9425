# Errors of the responses against the step: impact, bounce, friction; and against what they cost.
# responses: their names
set datafile missing NaN
eval paper(1280, 820)
set multiplot layout 2,2 margins 0.06,0.985,0.15,0.92 spacing 0.07,0.12 \
  title 'Four responses: a sheet that falls, and one that should stick' font ',13'
eval room_about_data
eval legend(0.035)
set logscale xy
set format y '10^{%T}'
set xlabel 'step [ms]'
set xtics (0.1, 0.2, 0.5, 1, 2, 5, 10, 20)
set xrange [0.05:25]
colour(response) = response eq 'projection' ? blue : response eq 'penalty' ? red : response eq 'impulse' ? green : pink
marker(response) = response eq 'projection' ? 7 : response eq 'penalty' ? 5 : response eq 'impulse' ? 9 : 12
# What lies behind others is seen beside them
scale(response) = response eq 'hybrid' ? 1.6 : 0.9
dash(response) = response eq 'hybrid' ? 2 : 1
most(a, b) = a > b ? a : b
# The logarithmic axes have no zero: what is less than their least is drawn there
error(panel) = panel == 3 ? most(1e3 * column('drift_m_per_s'), 1e-6) : \
               panel == 2 ? most(1e2 * column('height_error'), 1e-2) : most(1e3 * column('impact_error_s'), 1e-2)
# Of the response alone, per simulated second [ms]
cost = "(1e3 * column('respond_s') / column('step_s'))"
do for [panel = 1:4] {
  set title panel == 1 ? 'time of the impact' : panel == 2 ? 'height of the bounce' : \
            panel == 3 ? 'slope, half a degree too flat to slide' : 'time of the impact, against what the response costs'
  set ylabel panel == 3 ? 'drift [mm/s], at least 10^{-6}' : panel == 2 ? 'error [%]' : 'error [ms]'
  set yrange [(panel == 3 ? 3e-7 : 5e-3):(panel == 2 || panel == 3 ? 2e6 : 50)]
  if (panel == 4) {
    set xlabel 'CPU time of the response at rest per simulated second [ms]'
    set xrange [0.015:200]
    set xtics (0.1, 1, 10, 100)
  }
  plot for [response in responses] table \
    using (only(is('part', 'step') && is('response', response), \
                panel == 4 ? @cost : 1e3 * column('step_s'))):(error(panel)) \
    with linespoints lw 1.5 dt dash(response) pt marker(response) ps scale(response) \
    lc rgb colour(response) title response
  unset key
}
unset multiplot
