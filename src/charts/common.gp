# What all charts share: paper, colours and how rows of a table are picked.
# A chart begins with values that are set above: `name` (of the picture), `table` (a file in this folder), and its own.
if (!exists('kind')) { kind = 'svg' }
reset
set datafile separator ','
set datafile columnheaders
set grid xtics ytics lt 1 lc rgb '#e0e0e0'

# Okabe and Ito's colours, which people with any colour vision tell apart
black = '#000000'; grey = '#555555'; pale = '#d0d0d0'
blue = '#0072B2'; sky = '#56B4E9'; red = '#D55E00'; orange = '#E69F00'; green = '#009E73'; pink = '#CC79A7'

# eval paper(width, height): opens the picture
terminal = kind eq 'png' ? 'pngcairo' : "svg background rgb 'white'"
paper(width, height) = sprintf("set terminal %s enhanced font 'DejaVu Sans,11' size %d,%d; set output '%s.%s'", \
                               terminal, width, height, name, kind)

# A row's value where the row is wanted, else no point
only(wanted, value) = wanted ? value : NaN
is(column_name, word) = strcol(column_name) eq word

# "two_corners" as it is read: "two corners"
readable(text) = strstrt(text, '_') ? readable(text[1:strstrt(text, '_') - 1].' '.text[strstrt(text, '_') + 1:*]) : text

# A legend of two lines below all panels: eval legend(height on the paper)
legend(height) = sprintf("set key at screen 0.5,%g center center vertical maxrows 2 samplen 2", height)
room_about_data = 'set autoscale fix; set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05'

# Hierarchies look alike in every chart
colour_of(volume) = volume eq 'sphere' ? blue : volume eq 'aabb' ? red : volume eq 'kdop18' ? green : \
                    volume eq 'obb' ? pink : black
marker_of(update) = update eq 'rebuild' ? 7 : update eq 'merge' ? 5 : update eq 'insertion' ? 11 : \
                    update eq 'refit' ? 9 : 13
colour_of_update(update) = update eq 'rebuild' ? black : update eq 'merge' ? blue : update eq 'insertion' ? pink : \
                           update eq 'refit' ? red : green
