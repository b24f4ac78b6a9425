# Cost against the number of particles. builds, searches: what has a fit, as VOLUME:UPDATE:EXPONENT
# Lines continue across rows of others
set datafile missing NaN
eval paper(1200, 620)
set multiplot layout 1,2 margins 0.075,0.985,0.11,0.9 spacing 0.08,0 \
  title 'Cost against the number of particles, leaves as measured to be fastest' font ',13'
set autoscale fix
set offsets graph 0.05, graph 0.05, graph 0.45, graph 0.05
set logscale xy
set format '10^{%L}'
set xlabel 'particles'
set key top left Left reverse samplen 2
colons_to_blanks(text) = strstrt(text, ':') ? \
  colons_to_blanks(text[1:strstrt(text, ':') - 1].' '.text[strstrt(text, ':') + 1:*]) : text
volume_in(fitted) = word(colons_to_blanks(fitted), 1)
update_in(fitted) = word(colons_to_blanks(fitted), 2)
about(fitted) = (volume_in(fitted) eq 'brute' ? 'brute force' : volume_in(fitted).' '.update_in(fitted)). \
  sprintf(': n^{%g}', word(colons_to_blanks(fitted), 3) + 0)
here(fitted) = is('part', 'size') && is('volume', volume_in(fitted)) && is('update', update_in(fitted)) ? \
  column('particles') : NaN
dash(fitted) = update_in(fitted) eq 'merge' ? 2 : 1
marker(fitted) = update_in(fitted) eq 'merge' ? 4 : 7
build(which) = 1e6 * column('build_'.which)
search(which) = 1e6 * (column('query_'.which) + column('exact_'.which))
set ylabel 'build [us]'
if (words(builds) == 0) { set multiplot next } else {
  plot for [f in builds] table using (here(f)):(build('s')):(build('lower_s')):(build('upper_s')) \
    with yerrorlines lw 1.3 ps 0.8 dt dash(f) pt marker(f) \
    lc rgb colour_of(volume_in(f)) title about(f)
}
set ylabel 'query + exact test [us]'
if (words(searches) > 0) {
  plot for [f in searches] table using (here(f)):(search('s')):(search('lower_s')):(search('upper_s')) \
    with yerrorlines lw 1.3 ps 0.8 dt dash(f) pt marker(f) \
    lc rgb colour_of(volume_in(f)) title about(f)
}
unset multiplot
