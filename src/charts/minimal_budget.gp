# How far the motion moves where one knob at a time is as in the full model, and what that costs: a group a scene.
# scenes; cost_SCENE: of the scene as it is [s/s]
eval paper(830, 430)
set title 'How far the motion moves with one part of the full model, and at how many times the cost' font ',13'
knobs = 'particles bend drag integrator dt'
titles = '"particles of the full model" "bend springs" "drag" "Dormand-Prince" "half the step"'
array colours[5] = [blue, sky, pink, orange, green]
place(list, word_) = sum [k=1:words(list)] (word(list, k) eq word_ ? k : 0)
set xrange [0.4:words(scenes) + 0.6]
set xtics scale 0 ()
do for [k = 1:words(scenes)] { set xtics add (readable(word(scenes, k)) k) }
set logscale y
set yrange [0.001:*]
set ylabel 'the motion moves by [% of the side]'
set key below horizontal Left reverse samplen 1.5 maxrows 2
set style fill solid 0.9 noborder
set offsets 0, 0, graph 0.15, 0
least = 0.0012
x(knob) = place(scenes, strcol('scene')) + 0.16 * (place(knobs, knob) - 3)
mine(knob) = is('part', 'budget') && is('changed', knob)
least_shown(knob) = only(mine(knob), 100 * column('moved') < least ? least : 100 * column('moved'))
plot for [k = 1:5] table using (x(word(knobs, k))):(least_shown(word(knobs, k))):(0.14) \
       with boxes lc rgb colours[k] title word(titles, k), \
     for [k = 1:5] '' using (x(word(knobs, k))):(least_shown(word(knobs, k))):(sprintf('%.1fx', column('cost_s_per_s') / value('cost_'.strcol('scene')))) \
       with labels offset 0,0.5 font ',9' notitle
