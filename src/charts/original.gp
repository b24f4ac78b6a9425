# caption: One build and one search, with the scene's leaves of 7 x 7 cells and with a tree down to single cells; the CPU
# caption: time of all steps of a frame, without drawing; and the frame rate. Medians over runs, with quartiles. Hatched:
# caption: the bounds of a level are in the picture, as the original drew its spheres.
# The axes are linear from zero. The published values are in the page's text.
# The bars, in a file beside the table: test (1 execution of a frame, 2 frame rate, 6 build and search), position, volume,
# drawn, median, lower, upper, and the figure as text. Between two values a quartile is interpolated. Searches are timed
# without drawing: their rows with bounds and without are of one kind, which -1 stands for
data = name.'_data.csv'
rows = 0
stats table using (rows = rows + 1, 0) nooutput
array values[rows]
taken(value) = value != value ? 0 : (count = count + 1, values[count] = value, 0)
rank(k) = sum [j = 1:count] (values[j] < values[k] || (values[j] == values[k] && j < k))
nth(n) = sum [k = 1:count] (rank(k) == n ? values[k] : 0)
between(n, part) = part > 0 ? nth(n) + part * (nth(n + 1) - nth(n)) : nth(n)
quartile(q) = between(floor(q * (count - 1) / 4.), q * (count - 1) / 4. - floor(q * (count - 1) / 4.))
bar(its_test, place, volume, drawn, column_name, factor, digits) = sprintf("count = 0; stats table using \
  (is('volume', '%s') && (%d < 0 || column('bounds_drawn') == %d) ? taken(%g * column('%s')) : 0) nooutput; \
  if (count > 0) { print sprintf('%d,%d,%s,%d,%%.8g,%%.8g,%%.8g,%%.%dg', quartile(2), quartile(1), quartile(3), quartile(2)) }", \
  volume, drawn, drawn, factor, column_name, its_test, place, volume, drawn > 0, digits)
set print data
print 'test,position,volume,drawn,median,lower,upper,text'
do for [k = 0:3] {
  volume = word('sphere aabb', 1 + k % 2)
  eval bar(1, k, volume, k > 1, 'execution_s', 1e3, 4)
  eval bar(2, k, volume, k > 1, 'rate_per_s', 1, 3)
}
do for [n = 1:4] {
  do for [k = 1:2] {
    eval bar(6, 3 * (n - 1) + k - 1, word('sphere aabb', k), -1, \
      word('build_s search_s single_build_s single_search_s', n), 1e6, 2)
  }
}
set print
eval paper(460)
# A figure of spheres over that of boxes
array figure[2]
over(its_test, at_sphere, at_box) = sprintf("figure[1] = NaN; figure[2] = NaN; stats data using (column('test') != %d ? 0 : \
  column('position') == %d ? (figure[1] = column('median'), 0) : \
  column('position') == %d ? (figure[2] = column('median'), 0) : 0) nooutput", its_test, at_sphere, at_box)
eval over(6, 0, 1); large = figure[1] / figure[2]
eval over(6, 6, 7); single = figure[1] / figure[2]
eval over(1, 0, 1); whole = figure[1] / figure[2]
eval over(2, 2, 3); pictures = figure[1] / figure[2]
drawn = pictures == pictures ? sprintf('. With volumes drawn, spheres give %.2f times the pictures of boxes', pictures) : ''
least = sprintf('%.1f', large < single ? large : single); most = sprintf('%.1f', large < single ? single : large)
builds = least eq most ? least : least.' to '.most
eval headline(sprintf('Spheres take %s times as long to build as boxes, all steps of a frame %.2f times', builds, \
  whole), 'Medians over runs, with quartiles'.drawn)
eval panels(2, 3, 25, 25, 45, 95, 45, 70)
unset grid
set border 1
unset ytics
set boxwidth 0.7
set offsets 0, 0, graph 0.2, 0
set yrange [0:*]
set style fill solid 0.85
wanted(test, first, last) = column('test') == test && column('position') >= first && column('position') <= last
here(test, first, last, volume, drawn) = wanted(test, first, last) && is('volume', volume) && column('drawn') == drawn ? \
                                         column('position') - first : NaN
# Sphere and box each without volumes in the picture, then, for the frame rate, with them; a point at zero is there where
# no figure is
bars = "plot '+' every ::0::0 using (0):(0) with dots lc rgb 'white', \
        data using (here(test, first, last, 'sphere', 0)):5:6:7:(0.7) with boxerrorbars lc rgb blue lw 1.2, \
        '' using (here(test, first, last, 'aabb', 0)):5:6:7:(0.7) with boxerrorbars lc rgb red lw 1.2, \
        '' using (here(test, first, last, 'sphere', 1)):5:6:7:(0.7) with boxerrorbars fs pattern 4 lc rgb blue lw 1.2, \
        '' using (here(test, first, last, 'aabb', 1)):5:6:7:(0.7) with boxerrorbars fs pattern 4 lc rgb red lw 1.2, \
        '' using (only(wanted(test, first, last), column('position') - first)):7:8 with labels offset 0,0.7"
panel(unit, its_test, its_first, its_last) = \
  sprintf("set title '%s' offset 0,-0.3; test = %d; first = %d; last = %d; set xrange [-0.8:%g]", unit, its_test, its_first, its_last, \
          its_last - its_first + 0.8)
set xtics scale 0 ('spheres' 0, 'boxes' 1)
eval panel('build, leaves of 7 x 7 cells [us]', 6, 0, 1); eval bars
eval no_headline
eval panel('search, leaves of 7 x 7 cells [us]', 6, 3, 4); eval bars
eval panel('all steps of a frame [ms]', 1, 0, 1); eval bars
eval panel('build, single cells [us]', 6, 6, 7); eval bars
eval panel('search, single cells [us]', 6, 9, 10); eval bars
set xtics ("spheres" 0, "boxes" 1, "spheres\ndrawn" 2, "boxes\ndrawn" 3)
eval panel('pictures per second', 2, 0, 3); eval bars
unset multiplot
