# caption: Square cloths that a method moves in real time on one core, with at most 1 % more stretch than the converged
# caption: cloth: how far they are from that cloth, by their size.
# motion; drawn are the methods that have a colour
colours = 'symplectic_euler_by_1 '.black.' backward_euler_clamped_by_1 '.blue.' backward_euler_clamped_by_4 '.sky. \
          ' bdf2_clamped_by_2 '.green.' xpbd_1_by_10 '.orange.' xpbd_1_by_40 '.red
colour(method) = word(colours, 1 + place(colours, method))
methods = ''
moved = "(is('motion', motion) && is('end', 'realtime') && column('threads') == 1)"
stats table using (@moved && place(colours, strcol('method')) > 0 ? (methods = listed(methods, strcol('method')), 0) : 0) nooutput
if (methods eq '') { exit status 3 }
eval paper(430)
eval frame(65, 185, 55, 70)
set logscale xy
set format y '%g'
set ytics (0.1, 0.2, 0.3, 0.5, 0.7, 1, 1.5, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 14, 16, 20, 30, 50)
set xtics (8, 11, 16, 23, 32, 45, 64, 91, 128, 181, 256)
set xlabel 'particles along a side'
set ylabel 'error of positions [% of the side]'
eval room_about_data
before(text, mark) = text[1:strstrt(text, mark) - 1]
steps_of(method) = method[strstrt(method, '_by_') + 4:*] + 0
# Of a method with a step limit the number of steps is what it asks for
title_of(method) = name_of(before(method, '_by_')).(method[1:4] eq 'symp' ? '' : \
  sprintf(', %d step%s', steps_of(method), steps_of(method) == 1 ? '' : 's'))
here(method) = is('method', method) && @moved
low = 1e9; high = 1e-9
closest = ''; its_error = 1e9; its_side = 0
better(method, error, side) = error < its_error ? (its_error = error, its_side = side, closest = method, 0) : 0
eval forget
do for [k = 1:words(methods)] {
  method = word(methods, k)
  stats table using (last(k, here(method), column('side'), 100 * column('error'))) nooutput
  stats table using (here(method) ? better(method, 100 * column('error'), column('side')) : 0) nooutput
}
eval headline(sprintf('In real time on one core, %s with %d x %d particles comes closest: %.2g %%', name_of(before(closest, '_by_')), \
          its_side, its_side, its_error), \
  (motion eq 'free' ? 'A sheet hung by two corners' : motion eq 'ball' ? 'A sheet that falls on a ball' : \
   'A sheet that falls upright and folds').'. A line ends where the next larger cloth is too slow, or too soft')
near_x(i, j) = abs(log(end_x[i] / end_x[j])) < 0.5
stats table using (sum [k = 1:words(methods)] here(word(methods, k)) ? (low = least(low, 100 * column('error')), \
  high = most(high, 100 * column('error')), 0) : 0) nooutput
set yrange [low / 1.1:high * 1.1]
eval spread(gap_of(low / 1.1, high * 1.1, 305))
do for [k = 1:words(methods)] { eval label_at(k, title_of(word(methods, k)), colour(word(methods, k)), 'left') }
plot for [method in methods] table using (only(here(method), column('side'))):(100 * column('error')) \
       with linespoints lw 2 pt 7 lc rgb colour(method)
