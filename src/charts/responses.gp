# caption: A sheet that falls onto the ground, by its step: the errors of the time of the impact and of the height to
# caption: which it bounces; and how fast a sheet drifts that should stick to a slope.
# Errors of the responses against the step: impact, bounce, friction; and against what they cost.
responses = ''
stats table using (is('part', 'step') ? (responses = listed(responses, strcol('response')), 0) : 0) nooutput
eval paper(620)
colour(response) = response eq 'projection' ? blue : response eq 'penalty' ? red : response eq 'impulse' ? green : pink
marker(response) = response eq 'projection' ? 7 : response eq 'penalty' ? 5 : response eq 'impulse' ? 9 : 12
# What lies behind others is seen beside them
scale(response) = response eq 'hybrid' ? 1.6 : 0.9
dash(response) = response eq 'hybrid' ? 2 : 1
here(response) = is('part', 'step') && is('response', response)
array impact[4]
do for [k = 1:words(responses)] {
  impact[k] = 0
  stats table using (here(word(responses, k)) ? (impact[k] = most(impact[k], 1e3 * column('impact_error_s')), 0) : 0) nooutput
}
worst(response) = place(responses, response) > 0 ? impact[place(responses, response)] : 0
eval headline(sprintf('An impulse is at most %.2g ms off the time of an impact, projection %.2g ms, a penalty %.2g ms', \
  worst('impulse'), worst('projection'), worst('penalty')), \
  'A sheet that falls and bounces, and one that should stick to a slope, by steps of 1/60 to 1/15360 s')
eval panels(2, 2, 82, 95, 55, 90, 78, 90)
set logscale xy
set xtics (0.1, 0.2, 0.5, 1, 2, 5, 10, 20)
set xrange [0.05:25]
# The logarithmic axes have no zero: what is less than their least is drawn there
error = "(panel == 3 ? most(1e3 * column('drift_m_per_s'), 1e-6) : panel == 2 ? most(1e2 * column('height_error'), 1e-2) : \
  most(1e3 * column('impact_error_s'), 1e-2))"
# The step [ms], or what the response alone takes per simulated second [ms]
x = "(panel == 4 ? 1e3 * column('respond_s') / column('step_s') : 1e3 * column('step_s'))"
do for [panel = 1:4] {
  set title (panel == 1 ? 'time of the impact' : panel == 2 ? 'height of the bounce' : \
    panel == 3 ? 'slope, half a degree too flat to slide' : 'time of the impact, against cost') offset 0,-0.3
  set ylabel panel == 3 ? 'drift [mm/s]' : panel == 2 ? 'error [%]' : 'error [ms]'
  set yrange [(panel == 3 ? 3e-7 : 5e-3):(panel == 2 || panel == 3 ? 2e6 : 50)]
  if (panel == 1 || panel == 4) { set ytics (at_most('0.01') 0.01, '0.1' 0.1, '1' 1, '10' 10) }
  if (panel == 2) { set ytics (at_most('0.01') 0.01, '1' 1, '100' 100, '10^4' 1e4, '10^6' 1e6) }
  if (panel == 3) { set ytics (at_most('10^{-6}') 1e-6, '10^{-3}' 1e-3, '1' 1, '1000' 1e3, '10^6' 1e6) }
  set xlabel panel < 3 ? '' : panel == 3 ? 'step [ms]' : 'CPU ms of the response / simulated s'
  if (panel == 4) {
    set xrange [0.08:200]
    set xtics (0.1, 1, 10, 100)
  }
  eval forget
  do for [k = 1:(panel == 2 || panel == 4 ? words(responses) : 0)] {
    stats table using (last(k, here(word(responses, k)), @x, @error)) nooutput
  }
  eval spread(gap_of(5e-3, panel == 2 ? 2e6 : 50, 190))
  do for [k = 1:words(responses)] { eval label_at(k, word(responses, k), colour(word(responses, k)), 'left') }
  plot for [response in responses] table using (only(here(response), @x)):@error with linespoints lw 1.5 dt dash(response) \
    pt marker(response) ps scale(response) lc rgb colour(response)
  eval no_headline
}
unset multiplot
