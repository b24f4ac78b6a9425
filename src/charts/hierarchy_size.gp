# caption: CPU time of a build and of a search, medians, on one motion under more and more particles; the exponents are
# caption: fitted to the larger half of the sizes.
colons_to_blanks(text) = strstrt(text, ':') ? \
  colons_to_blanks(text[1:strstrt(text, ':') - 1].' '.text[strstrt(text, ':') + 1:*]) : text
part(fitted, i) = word(colons_to_blanks(fitted), i)
power(fitted) = part(fitted, 3) + 0
here(fitted) = is('part', 'size') && is('volume', part(fitted, 1)) && is('update', part(fitted, 2))
# Exponents as VOLUME:UPDATE:EXPONENT, fitted over the larger cloths, from the geometric middle of the smallest and the
# largest on, where what a call costs at the least no longer counts; hierarchies with fewer than two such sizes have none
smallest = 1e99; largest = 0
stats table using (is('part', 'size') ? (smallest = least(smallest, column('particles')), \
  largest = most(largest, column('particles')), 0) : 0) nooutput
large(hierarchy) = here(hierarchy) && column('particles') > 0.999999 * sqrt(smallest * largest)
builds = ''; searches = ''
do for [hierarchy in 'aabb:merge aabb:rebuild brute:rebuild kdop18:merge kdop18:rebuild obb:merge obb:rebuild sphere:merge sphere:rebuild'] {
  sizes = 0
  stats table using (large(hierarchy) ? (sizes = sizes + 1, 0) : 0) nooutput
  if (sizes > 1) {
    stats table using (only(large(hierarchy), log(column('particles')))):(log(column('query_s') + column('exact_s'))) nooutput
    searches = searches.' '.hierarchy.sprintf(':%.2f', STATS_slope)
    # Brute force builds nothing
    if (part(hierarchy, 1) ne 'brute') {
      stats table using (only(large(hierarchy), log(column('particles')))):(log(column('build_s'))) nooutput
      builds = builds.' '.hierarchy.sprintf(':%.2f', STATS_slope)
    }
  }
}
if (searches eq '') { exit status 3 }
eval paper(470)
# Of those that are merged only boxes, whose builds are the fastest
build_lines = ''; search_lines = ''
build_least = 1e9; build_most = 0; search_least = 1e9; search_most = 0; brute = NaN
do for [f in builds] {
  if (part(f, 2) eq 'rebuild' || part(f, 1) eq 'aabb') {
    build_least = least(build_least, power(f)); build_most = most(build_most, power(f)); build_lines = build_lines.' '.f
  }
}
do for [f in searches] {
  if (part(f, 1) eq 'brute') { brute = power(f) } else {
    if (part(f, 2) eq 'rebuild') { search_least = least(search_least, power(f)); search_most = most(search_most, power(f)) }
  }
  if (part(f, 2) eq 'rebuild') { search_lines = search_lines.' '.f }
}
eval headline(words(searches) > 0 && words(builds) > 0 ? \
  sprintf('Builds grow as n^{%.3g}  to n^{%.3g} , searches as n^{%.2g}  to n^{%.2g}%s', build_least, build_most, search_least, \
  search_most, brute == brute ? sprintf(' , brute force as n^{%.3g}', brute) : '') : 'Cost against the number of particles', \
  'One motion with more and more particles n; leaf sizes as they were measured to be fastest. Dotted: in proportion to n')
name_of_line(f, searched) = title_of_volume(part(f, 1)).(part(f, 2) eq 'merge' ? ', merged' : '').sprintf(': n^{%g}', power(f))
dash(f) = part(f, 2) eq 'merge' ? 2 : 1
marker(f) = part(f, 2) eq 'merge' ? 4 : 7
eval panels(1, 2, 65, 165, 55, 90, 225, 0)
set logscale xy
set format y '%g'
set format x '10^{%L}'
set xlabel 'particles'
time = "(1e6 * (panel == 1 ? column('build_s') : column('query_s') + column('exact_s')))"
do for [panel = 1:2] {
  shown = panel == 1 ? build_lines : search_lines
  of = panel == 1 ? 'build' : 'search'
  set title (panel == 1 ? 'build [us]' : 'query and exact test [us]') offset 0,-0.3
  if (words(shown) == 0) { set multiplot next } else {
    eval forget
    set autoscale
    low_x = 1e9; low_y = 1e9; high_x = 0; high_y = 0
    do for [k = 1:words(shown)] {
      stats table using (first(k, here(word(shown, k)), column('particles'), @time)) nooutput
      low_x = least(low_x, end_x[k]); low_y = least(low_y, end_y[k])
      end_x[k] = NaN
      stats table using (last(k, here(word(shown, k)), column('particles'), @time)) nooutput
      high_x = most(high_x, end_x[k]); high_y = most(high_y, end_y[k])
    }
    set xrange [low_x / 1.3:high_x * 1.3]
    set yrange [low_y / 1.5:high_y * 1.7]
    eval spread(gap_of(low_y / 1.5, high_y * 1.7, 325))
    do for [k = 1:words(shown)] { eval label_at(k, name_of_line(word(shown, k), panel), colour_of(part(word(shown, k), 1)), 'left') }
    plot low_y * x / low_x with lines dt 3 lc rgb grey, for [f in shown] table using (only(here(f), column('particles'))):@time \
      with linespoints lw 1.5 ps 0.8 dt dash(f) pt marker(f) lc rgb colour_of(part(f, 1))
    eval no_headline
  }
}
unset multiplot
