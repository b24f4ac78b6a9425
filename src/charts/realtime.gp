# Error against size, of cloths that are moved in real time.
set datafile missing NaN
eval paper(830, 500)
set title 'Cloths at 60 frames a second, on one core: '.motion font ',13'
set logscale xy
set format y '%g'
set xtics (16, 32, 64, 128, 256)
set xlabel 'particles along a side'
set ylabel 'error of positions, % of the side'
eval room_about_data
set bmargin at screen 0.22
eval legend(0.06)
colours = 'symplectic_euler_by_1 '.black.' backward_euler_clamped_by_1 '.blue.' backward_euler_clamped_by_4 '.sky. \
          ' bdf2_clamped_by_2 '.green.' xpbd_1_by_10 '.orange.' xpbd_1_by_40 '.red
colour(method) = colours[strstrt(colours, method) + strlen(method) + 1:strstrt(colours, method) + strlen(method) + 7]
here(method) = is('motion', motion) && is('method', method) && is('end', 'realtime') && column('threads') == 1
plot for [method in methods] table using (only(here(method), column('side'))):(100 * column('error')) \
       with linespoints lw 2 pt 7 lc rgb colour(method) title readable(method)
