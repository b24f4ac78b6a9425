# A strip a method, a cell a step: held, off, soft, ruined or blown up, with the error or the additional stretch in per cent.
# methods: from top to bottom
eval paper(830, 485)
set label "Beyond a limit explicit methods blow up; the others go off, soft and to ruin" at screen 0.5,0.95 center \
  font ',13'
set tmargin 3
names = "explicit_euler 'explicit Euler' symplectic_euler 'symplectic Euler' velocity_verlet 'velocity Verlet' rk4 RK4 ".\
  "dormand_prince Dormand-Prince backward_euler 'backward Euler' implicit_midpoint 'implicit midpoint' bdf2 BDF2 ".\
  "xpbd_1 'XPBD, 1 iteration' xpbd_20 'XPBD, 20 iterations' projective_dynamics_10 'projective, 10 iterations'"
title_of(method) = word(names, 1 + sum [k=1:words(names)] (word(names, k) eq method ? k : 0))
n = words(methods)
row(method) = n - sum [k=1:n] (word(methods, k) eq method ? k : 0)
set xrange [-0.5:9.5]; set yrange [-0.5:n - 0.5]
column_of(step) = log(1 / (15 * step)) / log(2)
unset grid; set border 0; set tics scale 0
set ytics ()
do for [k = 1:n] { set ytics add (title_of(word(methods, k)) n - k) }
set xtics ('67' 0, '33' 1, '17' 2, '8.3' 3, '4.2' 4, '2.1' 5, '1.0' 6, '0.52' 7, '0.26' 8, '0.13' 9)
set xlabel 'time step [ms]'
set key at screen 0.5,0.07 center center vertical maxrows 3 Left reverse samplen 1 spacing 1.2 width 2
set bmargin 8
colour_of_end(end) = end eq 'held' ? 0x009E73 : end eq 'off' ? 0x56B4E9 : end eq 'soft' ? 0xE69F00 : end eq 'ruined' ? 0xCC79A7 : 0xD55E00
percent(x) = x < 10 ? sprintf('%.0f %%', 100 * x) : sprintf('%.0fx', x)
mark(end, error, excess) = end eq 'held' ? ' ' : end eq 'off' ? percent(error) : end eq 'blew_up' ? '' : '+'.percent(excess)
set style fill solid 1 border rgb 'white'
plot table using (column_of(column('step_s'))):(row(strcol('method'))):(0.48):(0.44):(colour_of_end(strcol('end'))) \
       with boxxyerror lc rgb variable notitle, \
     '' using (column_of(column('step_s'))):(row(strcol('method'))):(mark(strcol('end'), column('error'), column('stretch_excess'))) \
       with labels tc rgb 'black' font ',10' notitle, \
     keyentry with boxes lc rgb green title 'held: within 1 % of the converged motion', \
     keyentry with boxes lc rgb sky title 'off: farther from it, by this part of the side', \
     keyentry with boxes lc rgb orange title 'soft: stretches more, by this', \
     keyentry with boxes lc rgb pink title 'ruined: stretches by its length and more', \
     keyentry with boxes lc rgb red title 'blew up'
