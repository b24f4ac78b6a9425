# What all charts share: paper, colours, the headline, labels at lines, and how rows of a table are picked.
# A chart begins with values that are set above: `name` (of the picture), `table` (a file in this folder), and its own.
if (!exists('kind')) { kind = 'svg' }
reset
set datafile separator ','
set datafile columnheaders
# Lines continue across rows of others
set datafile missing NaN

# Okabe and Ito's colours, which people with any colour vision tell apart
black = '#000000'; grey = '#555555'; pale = '#d0d0d0'
blue = '#0072B2'; sky = '#56B4E9'; red = '#D55E00'; orange = '#E69F00'; green = '#009E73'; pink = '#CC79A7'
# Text is darker than lines where these would be too light to read
ink(colour) = colour eq orange ? '#9C6A00' : colour eq sky ? '#1F7FB5' : colour eq pink ? '#A8507E' : colour
set border 3 lc rgb grey
set tics nomirror textcolor rgb black
set grid xtics ytics lt 1 lc rgb '#e8e8e8'
unset key

# A page shows 830 pixels of width: eval paper(height) opens a picture of these, so that its type has the size it says;
# exponents have 0.8 of it, 10 pixels
terminal = kind eq 'png' ? 'pngcairo' : "svg background rgb 'white'"
paper(height) = (paper_height = height, sprintf("set terminal %s enhanced font 'DejaVu Sans,12.5' size 830,%d; \
  set output '%s.%s'", terminal, height, name, kind))
px(pixels) = pixels / 830.
py(pixels) = 1. * pixels / paper_height

# eval headline(result, about): the result in words, and below it in grey what was measured
headline(result, about) = (its_result = result, its_about = about, \
  "set label 901 its_result at screen px(12), screen 1 - py(20) font ',15'; \
   set label 902 its_about at screen px(12), screen 1 - py(41) tc rgb grey")
# Panels beside the first one have no headline
no_headline = 'unset label 901; unset label 902'
# eval frame(left, right, bottom, top): one panel; eval panels(rows, columns, ..., x, y): several, so far apart; in pixels
frame(left, right, bottom, top) = sprintf('set lmargin at screen %g; set rmargin at screen %g; set bmargin at screen %g; \
  set tmargin at screen %g', px(left), 1 - px(right), py(bottom), 1 - py(top))
panels(rows, columns, left, right, bottom, top, x, y) = sprintf('set multiplot layout %d,%d margins %g,%g,%g,%g \
  spacing %g,%g', rows, columns, px(left), 1 - px(right), py(bottom), 1 - py(top), px(x), py(y))

room_about_data = 'set autoscale fix; set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05'

# A row's value where the row is wanted, else no point
only(wanted, value) = wanted ? value : NaN
is(column_name, word) = strcol(column_name) eq word
least(a, b) = a < b ? a : b
most(a, b) = a > b ? a : b
# The words that rows have, each once, in their order, where `stats` evaluates it for each row from an empty list.
# A script that finds nothing to draw ends by `exit status 3`
listed(list, word) = list eq '' ? word : place(list, word) > 0 ? list : list.' '.word
# A tick at which what is less is drawn, too
at_most(text) = '<'.text

# "two_corners" as it is read: "two corners"
readable(text) = strstrt(text, '_') ? readable(text[1:strstrt(text, '_') - 1].' '.text[strstrt(text, '_') + 1:*]) : text
capital(text) = strstrt('abcdefghijklmnopqrstuvwxyz', text[1:1]) ? \
  'ABCDEFGHIJKLMNOPQRSTUVWXYZ'[strstrt('abcdefghijklmnopqrstuvwxyz', text[1:1]):\
  strstrt('abcdefghijklmnopqrstuvwxyz', text[1:1])].text[2:*] : text

# Labels at the ends of up to 12 lines: eval forget; then for each line k
#   stats table using (last(k, wanted, x, y)) nooutput        to find its end on the right, or first(...) on the left;
# eval spread(gap) moves those apart that are nearer than `gap` decades and beside each other, which near_x(i, j) says;
# gap_of(low, high, pixels) is a line of text on an axis of so many pixels;
# eval label_at(k, text, colour, side) writes one if there is a line.
array end_x[12]; array end_y[12]; array spread_y[12]
near_x(i, j) = 1
gap_of(low, high, pixels) = log10(high / low) * 15 / pixels
forget = 'do for [i = 1:12] { end_x[i] = NaN; end_y[i] = NaN; spread_y[i] = NaN; unset label i }'
further(k, x, y) = (end_x[k] = x, end_y[k] = y, 1)
last(k, wanted, x, y) = !wanted || x != x || y != y ? 0 : end_x[k] != end_x[k] || x >= end_x[k] ? further(k, x, y) : 0
first(k, wanted, x, y) = !wanted || x != x || y != y ? 0 : end_x[k] != end_x[k] || x <= end_x[k] ? further(k, x, y) : 0
apart(i, j, gap, shift) = (spread_y[i] = spread_y[i] - shift, spread_y[j] = spread_y[j] + shift, 1)
push(i, j, gap) = near_x(i, j) && abs(spread_y[i] - spread_y[j]) < gap && (spread_y[i] < spread_y[j] || \
  (spread_y[i] == spread_y[j] && i < j)) ? apart(i, j, gap, (gap - spread_y[j] + spread_y[i]) / 5) : 0
spread(gap) = sprintf('do for [i = 1:12] { spread_y[i] = log10(end_y[i]) }; do for [turn = 1:80] { do for [i = 1:12] { \
  do for [j = 1:12] { moved = push(i, j, %g) } } }; do for [i = 1:12] { spread_y[i] = 10**spread_y[i] }', gap)
label_at(k, text, colour, side) = (label_text = text, label_colour = ink(colour), end_x[k] != end_x[k] ? '' : \
  sprintf("set label %d label_text at %g,%g %s offset %g,0 tc rgb label_colour front", k, end_x[k], spread_y[k], side, \
          side eq 'left' ? 1.1 : -1.1))

# Methods as they are read; 'clamped' is the usual Hessian
method_names = "explicit_euler 'explicit Euler' symplectic_euler 'symplectic Euler' velocity_verlet 'velocity Verlet' \
  rk4 RK4 dormand_prince Dormand-Prince backward_euler 'backward Euler' backward_euler_clamped 'backward Euler' \
  backward_euler_exact 'backward Euler, exact' implicit_midpoint 'implicit midpoint' \
  implicit_midpoint_clamped 'implicit midpoint' implicit_midpoint_exact 'midpoint, exact' bdf2 BDF2 \
  bdf2_clamped BDF2 bdf2_exact 'BDF2, exact' xpbd_1 'XPBD, 1 iteration' xpbd_5 'XPBD, 5 iterations' \
  xpbd_20 'XPBD, 20 iterations' projective_dynamics 'projective dynamics' \
  projective_dynamics_5 'projective, 5 iterations' projective_dynamics_10 'projective, 10 iterations' \
  projective_dynamics_20 'projective, 20 iterations'"
place(list, wanted) = sum [i = 1:words(list)] (word(list, i) eq wanted ? i : 0)
name_of(method) = place(method_names, method) > 0 ? word(method_names, 1 + place(method_names, method)) : readable(method)
# 'XPBD, 1 iteration' in a sentence: 'XPBD with 1 iteration'
in_words(name) = strstrt(name, ', ') ? name[1:strstrt(name, ', ') - 1].' with '.name[strstrt(name, ', ') + 2:*] : name

# Hierarchies look alike in every chart
colour_of(volume) = volume eq 'sphere' ? blue : volume eq 'aabb' ? red : volume eq 'kdop18' ? green : \
                    volume eq 'obb' ? pink : black
title_of_volume(volume) = volume eq 'aabb' ? 'boxes' : volume eq 'obb' ? 'oriented boxes' : volume eq 'kdop18' ? '18-DOPs' : \
                          volume eq 'sphere' ? 'spheres' : volume eq 'brute' ? 'brute force' : volume
marker_of(update) = update eq 'rebuild' ? 7 : update eq 'merge' ? 5 : update eq 'insertion' ? 11 : \
                    update eq 'refit' ? 9 : 13
colour_of_update(update) = update eq 'rebuild' ? black : update eq 'merge' ? blue : update eq 'insertion' ? pink : \
                           update eq 'refit' ? red : green
