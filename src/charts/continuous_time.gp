# caption: CPU time of the build and of the search, query and exact test, at the positions after a step and over all of
# caption: it: medians with quartiles.
detections = ''
stats table using (is('part', 'time') ? (detections = listed(detections, strcol('detection')), 0) : 0) nooutput
eval paper(430)
eval panels(1, 2, 70, 105, 55, 90, 70, 0)
set logscale xy
set format y '%g'
set xlabel 'particles'
set xtics ('256' 256, '' 1024 1, '4096' 4096, '' 16384 1, '65 536' 65536, '' 262144 1)
colour(detection) = detection eq 'discrete' ? blue : red
marker(detection) = detection eq 'discrete' ? 7 : 5
here(detection) = is('part', 'time') && is('detection', detection)
# The ratio of the medians, size by size: the rows of a size follow each other
array ratio_least[2]; array ratio_most[2]
ratio_least[1] = 1e9; ratio_least[2] = 1e9; ratio_most[1] = 0; ratio_most[2] = 0
noted(k, ratio) = (ratio_least[k] = least(ratio_least[k], ratio), ratio_most[k] = most(ratio_most[k], ratio), 0)
array base[2]
do for [k = 1:2] {
  time = k == 1 ? 'build_s' : 'search_s'
  do for [level = 4:12] {
    particles = 4**level
    base[1] = NaN; base[2] = NaN
    stats table using (column('particles') != particles ? 0 : here('discrete') ? (base[1] = column(time), 0) : \
                       here('continuous') ? (base[2] = column(time), 0) : 0) nooutput
    if (base[1] > 0 && base[2] > 0) { done = noted(k, base[2] / base[1]) }
  }
}
# To two digits
rounded(x) = x > 10 ? sprintf('%.0f', 10**(floor(log10(x)) - 1) * floor(x / 10**(floor(log10(x)) - 1) + 0.5)) : sprintf('%.2g', x)
eval headline(sprintf('A continuous search takes %s to %s times as long; its build %.1f to %.1f times', rounded(ratio_least[2]), \
  rounded(ratio_most[2]), ratio_least[1], ratio_most[1]), \
  'A ball that meets the cloth within the step: to find a patch, or all that it sweeps. Medians with quartiles')
do for [k = 1:2] {
  stage = k == 1 ? 'build' : 'search'
  set title stage.' [us]' offset 0,-0.3
  eval forget
  if (k == 2) {
    do for [i = 1:words(detections)] {
      stats table using (last(i, here(word(detections, i)), column('particles'), 1e6 * column(stage.'_s'))) nooutput
    }
    eval spread(0.2)
    do for [i = 1:words(detections)] { eval label_at(i, word(detections, i), colour(word(detections, i)), 'left') }
  }
  plot for [detection in detections] table using (only(here(detection), column('particles'))):(1e6 * column(stage.'_s')) \
         :(1e6 * column(stage.'_lower_s')):(1e6 * column(stage.'_upper_s')) with yerrorlines lw 1.5 ps 0.8 \
         pt marker(detection) lc rgb colour(detection)
  eval no_headline
}
unset multiplot
