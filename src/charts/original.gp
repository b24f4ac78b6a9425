# Spheres against boxes: build, search and frame, on linear axes from zero. The published values are in the page's text.
# data: test (1 execution of a frame, 2 frame rate, 6 build and search), position, volume, drawn, median, lower, upper,
# and the figure as text
eval paper(830, 470)
set multiplot layout 2,3 margins 0.07,0.99,0.19,0.86 spacing 0.08,0.15 \
  title 'Spheres take longer to build and to draw; the steps of a frame take as long with either' font ',14'
unset grid
set grid ytics lt 1 lc rgb '#e0e0e0'
set border 3
set tics nomirror
set boxwidth 0.7
set offsets 0, 0, graph 0.2, 0
set yrange [0:*]
set style fill solid 0.85
unset key
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
  sprintf("set title '%s'; test = %d; first = %d; last = %d; set xrange [-0.8:%g]", unit, its_test, its_first, its_last, \
          its_last - its_first + 0.8)
set xtics scale 0 ('spheres' 0, 'boxes' 1)
set ytics autofreq
eval panel('build, leaves of 7 x 7 cells [us]', 6, 0, 1); eval bars
eval panel('search, leaves of 7 x 7 cells [us]', 6, 3, 4); eval bars
eval panel('all steps of a frame [ms]', 1, 0, 1); eval bars
eval panel('build, single cells [us]', 6, 6, 7); eval bars
eval panel('search, single cells [us]', 6, 9, 10); eval bars
set xtics scale 0 ('spheres' 0, 'boxes' 1, 'spheres' 2, 'boxes' 3)
eval panel('pictures per second', 2, 0, 3); eval bars
# What the colours mean, in the margin below
unset border; unset tics; unset title; unset grid; set offsets
set xrange [0:1]
set yrange [0:1]
set lmargin screen 0.05; set rmargin screen 0.95; set bmargin screen 0; set tmargin screen 0.06
set key at screen 0.5,0.055 center center horizontal maxrows 2 samplen 2 width 1
plot 2 notitle, \
     keyentry with boxes fs solid 0.85 lc rgb blue title 'spheres', \
     keyentry with boxes fs solid 0.85 lc rgb red title 'boxes (AABB)', \
     keyentry with boxes fs pattern 4 lc rgb blue title 'spheres in the picture', \
     keyentry with boxes fs pattern 4 lc rgb red title 'boxes in the picture'
unset multiplot
