# Time of a frame against the storage of the hierarchy: a panel for each scene, a line for each volume.
# scenes, particles_SCENE; volumes: VOLUME:BYTES, what a node takes; data: scene, volume, bytes of the tree, time
# Lines continue across rows of others
set datafile missing NaN
eval paper(1280, 520)
set multiplot layout 1,words(scenes) margins 0.065,0.985,0.22,0.87 spacing 0.065,0 \
  title 'Time of a frame and storage of the tree' font ',13'
eval room_about_data
eval legend(0.05)
set logscale xy
set xlabel 'volumes of the tree [KiB]'
set ylabel 'time of a frame [us]'
volume_in(text) = text[1:strstrt(text, ':') - 1]
bytes_in(text) = text[strstrt(text, ':') + 1:*]
colour(volume) = volume eq 'kdop6' ? orange : volume eq 'kdop14' ? sky : volume eq 'kdop26' ? grey : colour_of(volume)
here(scene, volume) = is('scene', scene) && is('volume', volume)
do for [scene in scenes] {
  set title sprintf('%s, %d particles', readable(scene), value('particles_'.scene))
  plot for [volume in volumes] data using (only(here(scene, volume_in(volume)), column('bytes') / 1024)) \
         :(1e6 * column('whole_s')) with linespoints lw 1.5 pt 7 ps 0.7 lc rgb colour(volume_in(volume)) \
         title volume_in(volume).', '.bytes_in(volume).' bytes a node'
  unset key
  set ylabel ''
}
unset multiplot
