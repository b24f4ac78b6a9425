# caption: Wall time of the stages of a step by vector kernels and by the plain core, medians with quartiles over steps
# caption: that were made in turn, and how many times as long the plain core takes.
eval paper(450)
colour(stage) = stage eq 'step' ? blue : stage eq 'build' ? red : stage eq 'query' ? green : pink
marker(stage) = stage eq 'step' ? 7 : stage eq 'build' ? 5 : stage eq 'query' ? 9 : 13
dash(kernels) = kernels eq 'plain' ? 2 : 1
here(stage, kernels) = is('stage', stage) && is('kernels', kernels) ? column('particles') : NaN
# Plain time / vector time, where the row of a stage by the plain core follows that of the same by vector kernels
its_case = "strcol('stage').' '.strcol('particles')"
vector_time = NaN; vector_case = ''
ratio = "(is('kernels', 'vector') ? (vector_time = column('time_s'), vector_case = @its_case, NaN) : \
  vector_case eq @its_case && vector_time > 0 ? column('time_s') / vector_time : NaN)"
stages = ''; fastest = 0; slowest = 1e9
seen(ratio) = ratio == ratio ? (fastest = most(fastest, ratio), slowest = least(slowest, ratio), 0) : 0
stats table using (stages = listed(stages, strcol('stage')), seen(@ratio)) nooutput
eval headline(sprintf('The plain core takes %.1f to %.1f times as long as the vector kernels', slowest, fastest), \
  'Solid: vector kernels; dashed: the plain core. Medians with quartiles')
eval forget
do for [k = 1:words(stages)] { stats table using (last(k, is('stage', word(stages, k)), column('particles'), @ratio)) nooutput }
eval spread(0.1)
eval panels(1, 2, 75, 130, 60, 90, 75, 0)
eval room_about_data
set logscale xy
set format y '%g'
set xlabel 'particles'
set xtics ('64' 64, '1024' 1024, '16 384' 16384, '262 144' 262144)
set title 'time of the stage [us]' offset 0,-0.3
plot for [stage in stages] for [kernels in 'vector plain'] table using (here(stage, kernels)):(1e6 * column('time_s')) \
       :(1e6 * column('time_lower_s')):(1e6 * column('time_upper_s')) with yerrorlines lw 1.5 ps 0.8 pt marker(stage) \
       dt dash(kernels) lc rgb colour(stage)
eval no_headline
set title 'plain time / vector time' offset 0,-0.3
set yrange [0.5:*]
set ytics (0.5, 1, 2, 5, 10, 20, 50, 100)
do for [k = 1:words(stages)] { eval label_at(k, readable(word(stages, k)), colour(word(stages, k)), 'left') }
plot for [stage in stages] table using (only(is('stage', stage), column('particles'))):@ratio \
       with linespoints lw 1.5 ps 0.8 pt marker(stage) lc rgb colour(stage), \
     1 with lines lc rgb grey dt 2
unset multiplot
