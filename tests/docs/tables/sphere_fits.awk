# How tight the fits are on cloth, mean radius / radius of the smallest sphere, and what a build with them costs.
# Rebuilt, 128 x 128 particles, leaves of 4 x 4 cells.
cell("part") == "fit" && cell("volume") == "sphere" && cell("update") == "rebuild" && cell("leaf_cells") == 4 &&
cell("particles") == 16384 {
    fit = cell("sphere_fit")
    scene = cell("scene")
    if (!(fit in known)) known[fit] = fits[++fit_count] = fit
    if (!(scene in known)) known[scene] = scenes[++scene_count] = scene
    tightness[fit, scene] = cell("tightness")
    build[fit, scene] = cell("build_s")
}
END {
    line = "| Fit |"
    rule = "| --- |"
    for (s = 1; s <= scene_count; ++s) {
        line = line " `" scenes[s] "` |"
        rule = rule " ---: |"
    }
    print line " build time / that of `centroid` |\n" rule " ---: |"
    for (f = 1; f <= fit_count; ++f) {
        line = "| `" fits[f] "` |"
        least = most = build[fits[f], scenes[1]] / build["centroid", scenes[1]]
        for (s = 1; s <= scene_count; ++s) {
            line = line sprintf(" %.4f |", tightness[fits[f], scenes[s]])
            ratio = build[fits[f], scenes[s]] / build["centroid", scenes[s]]
            if (ratio < least) least = ratio
            if (ratio > most) most = ratio
        }
        print line sprintf(fits[f] == "centroid" ? " 1 |" : " %.1f to %.1f |", least, most)
    }
}
