# caption: A sheet that falls and swings, hung by two corners, by each method and step: held within 1 % of the converged
# caption: motion and its stretch, off by more, stretched by more or to ruin, or blown up.
# A strip a method, a cell a step: held, off, soft, ruined or blown up, with the error or the additional stretch in per cent.
# methods: from top to bottom
eval paper(500)
# Methods of a fixed step whose limit the table knows, and all others
limited(method) = place('explicit_euler symplectic_euler velocity_verlet rk4', method) > 0
cells = 0; blown = 0; others = 0; others_blown = 0; longest = 0; shortest = 1e9
count(is_limited, is_blown) = is_limited ? (cells = cells + 1, blown = blown + is_blown) : \
                                           (others = others + 1, others_blown = others_blown + is_blown)
stats table using (count(limited(strcol('method')), is('end', 'blew_up')), longest = most(longest, column('step_s')), \
                   shortest = least(shortest, column('step_s')), 0) nooutput
eval headline(sprintf('Explicit methods of fixed step blow up in %d of %d trials, the others in %d of %d', blown, cells, \
  others_blown, others), 'A sheet hung by two corners falls and swings; in a cell, by how much it is off or too soft')
n = words(methods)
row(method) = n - place(methods, method)
set xrange [-0.5:9.5]; set yrange [-0.5:n - 0.5]
column_of(step) = log(1 / (15 * step)) / log(2)
unset grid; set border 0; set tics scale 0
set ytics ()
do for [k = 1:n] { set ytics add (name_of(word(methods, k)) n - k) }
set xtics ('67' 0, '33' 1, '17' 2, '8.3' 3, '4.2' 4, '2.1' 5, '1.0' 6, '0.52' 7, '0.26' 8, '0.13' 9)
set xlabel 'time step [ms]'
eval frame(180, 15, 130, 60)
set key at screen px(12),screen py(40) left center vertical maxrows 3 Left reverse samplen 1 spacing 1.2 width 2
colour_of_end(end) = end eq 'held' ? 0x009E73 : end eq 'off' ? 0x56B4E9 : end eq 'soft' ? 0xE69F00 : end eq 'ruined' ? 0xCC79A7 : 0xD55E00
percent(x) = x < 10 ? sprintf('%.0f %%', 100 * x) : sprintf('%.0fx', x)
mark(end, error, excess) = end eq 'held' ? ' ' : end eq 'off' ? percent(error) : end eq 'blew_up' ? '' : '+'.percent(excess)
set style fill solid 1 border rgb 'white'
plot table using (column_of(column('step_s'))):(row(strcol('method'))):(0.48):(0.44):(colour_of_end(strcol('end'))) \
       with boxxyerror lc rgb variable notitle, \
     '' using (column_of(column('step_s'))):(row(strcol('method'))):(mark(strcol('end'), column('error'), column('stretch_excess'))) \
       with labels tc rgb 'black' font ',11' notitle, \
     keyentry with boxes lc rgb green title 'held: within 1 % of the converged motion', \
     keyentry with boxes lc rgb sky title 'off: farther from it, by this part of the side', \
     keyentry with boxes lc rgb orange title 'soft: stretches more, by this', \
     keyentry with boxes lc rgb pink title 'ruined: stretches by its length and more', \
     keyentry with boxes lc rgb red title 'blew up'
