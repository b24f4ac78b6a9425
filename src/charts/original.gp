# The dissertation's five tests, then build and search apart: a bar for each way in which the scene is run.
# data: test (1 to 5, 6 build and search), position, volume, drawn, median, lower, upper, and the figure as text
eval paper(1280, 760)
set multiplot layout 2,3 margins 0.05,0.99,0.13,0.89 spacing 0.05,0.12 \
  title "The dissertation's five tests: a cloth on a ball, spheres against boxes (logarithmic axes)" font ',13'
unset grid
set grid ytics lt 1 lc rgb '#e0e0e0'
set border 3
set tics nomirror
set boxwidth 0.8
set logscale y
set offsets 0, 0, graph 0.12, 0
unset key
here(test, volume, drawn) = column('test') == test && is('volume', volume) && column('drawn') == drawn ? column('position') : NaN
array titles[6] = ['execution time of a frame [ms]', 'frame rate [1/s]', 'OpenGL calls per frame', 'CPU use [%]', \
                   'vertices per frame', 'one build, one search [us]']
array least[6] = [0.1, 1, 1, 1, 1, 0.01]
array most[6] = [1e3, 1e2, 1e5, 1e3, 1e6, 1e3]
set format y '10^{%L}'
set xrange [-0.7:4.7]
set xtics scale 0 ('sphere' 0, 'AABB' 1, 'sphere' 2, 'AABB' 3, 'prototype' 4)
do for [test = 1:6] {
  set title titles[test]
  set yrange [least[test]:most[test]]
  if (test == 6) {
    set xrange [-0.9:10.9]
    set xtics scale 0 ('build' 0.5, 'search' 3.5, "build,\nsingle cells" 6.5, "search,\nsingle cells" 9.5)
  }
  plot data using (here(test, 'sphere', 0)):5:6:7:(0.8) with boxerrorbars fs solid 0.85 lc rgb blue lw 1.2, \
       '' using (here(test, 'aabb', 0)):5:6:7:(0.8) with boxerrorbars fs solid 0.85 lc rgb red lw 1.2, \
       for [one = 1:test < 6] '' using (here(test, 'sphere', 1)):5:6:7:(0.8) with boxerrorbars fs pattern 4 lc rgb blue \
         lw 1.2, \
       for [one = 1:test < 6] '' using (here(test, 'aabb', 1)):5:6:7:(0.8) with boxerrorbars fs pattern 4 lc rgb red \
         lw 1.2, \
       for [one = 1:test < 6] '' using (here(test, 'published', 0)):5:6:7:(0.8) with boxerrorbars fs solid 0.6 \
         lc rgb '#999999' lw 1.2, \
       '' using (only(column('test') == test, column('position'))):7:8 with labels font test == 6 ? ',8' : ',9' offset 0,0.7
}
# What the colours mean, in the margin below
unset border; unset logscale; unset tics; unset title; unset grid
set xrange [0:1]
set yrange [0:1]
set lmargin screen 0.05; set rmargin screen 0.95; set bmargin screen 0; set tmargin screen 0.06
set key at screen 0.5,0.03 center center horizontal maxrows 1 samplen 2 width 1
plot 2 notitle, \
     keyentry with boxes fs solid 0.85 lc rgb blue title 'spheres', \
     keyentry with boxes fs solid 0.85 lc rgb red title 'boxes (AABB)', \
     keyentry with boxes fs pattern 4 lc rgb blue title 'spheres, drawn', \
     keyentry with boxes fs pattern 4 lc rgb red title 'boxes (AABB), drawn', \
     keyentry with boxes fs solid 0.6 lc rgb '#999999' title "the dissertation's prototype"
unset multiplot
