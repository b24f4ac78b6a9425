# The step limit of penalties against their stiffness, predicted and measured.
set datafile missing NaN
eval paper(900, 520)
set title 'Longest step of a penalty' font ',13'
set lmargin at screen 0.11
set bmargin at screen 0.235
eval legend(0.065)
set logscale xy
set format xy '10^{%T}'
set xlabel 'stiffness of the penalty [N/m]'
set ylabel 'step [ms]'
set xrange [5:2e5]
restitutions = '0 0.5 1'
colour(e) = e == 0 ? blue : e < 1 ? green : red
marker(e) = e == 0 ? 6 : e < 1 ? 8 : 4
here(e) = is('part', 'limit') && column('restitution') == e
plot for [e in restitutions] table using (only(here(e + 0), column('stiffness_N_per_m'))):(1e3 * column('predicted_step_s')) \
       with lines lw 1.5 lc rgb colour(e + 0) title 'predicted, restitution '.e, \
     for [e in restitutions] '' using (only(here(e + 0), column('stiffness_N_per_m'))):(1e3 * column('measured_step_s')) \
       with points ps 1.6 lw 1.5 pt marker(e + 0) lc rgb colour(e + 0) title 'measured, restitution '.e
