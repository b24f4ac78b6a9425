# How tight the fits are on cloth: mean radius over that of the smallest sphere. Rebuilt, 128 x 128 particles, leaves of
# 4 x 4 cells.
cell("part") == "fit" && cell("volume") == "sphere" && cell("update") == "rebuild" && cell("leaf_cells") == 4 &&
cell("particles") == 16384 {
    fit = cell("sphere_fit")
    scene = cell("scene")
    if (!(fit in known)) known[fit] = fits[++fit_count] = fit
    if (!(scene in known)) known[scene] = scenes[++scene_count] = scene
    tightness[fit, scene] = cell("tightness")
}
END {
    line = "| Fit |"
    rule = "| --- |"
    for (s = 1; s <= scene_count; ++s) {
        line = line " `" scenes[s] "` |"
        rule = rule " ---: |"
    }
    print line "\n" rule
    for (f = 1; f <= fit_count; ++f) {
        line = "| `" fits[f] "` |"
        for (s = 1; s <= scene_count; ++s) line = line sprintf(" %.4f |", tightness[fits[f], scenes[s]])
        print line
    }
}
