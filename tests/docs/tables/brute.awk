# Brute force beside the fastest tree: time of a frame, 128 x 128 particles.
cell("part") == "fit" && cell("particles") == 16384 {
    scene = cell("scene")
    if (!(scene in known)) known[scene] = scenes[++count] = scene
    if (cell("volume") == "brute") brute[scene] = cell("whole_s")
    else if (!(scene in best) || cell("whole_s") < best[scene]) {
        best[scene] = cell("whole_s")
        tree[scene] = cell("volume") (cell("volume") == "sphere" ? " (" cell("sphere_fit") ")" : "") ", " cell("update") \
                      ", leaves of " cell("leaf_cells") " x " cell("leaf_cells")
    }
}
END {
    print "| Scene | Fastest tree | Time of a frame [us] | Brute force [us] | Fastest tree / brute force |"
    print "| --- | --- | ---: | ---: | ---: |"
    for (i = 1; i <= count; ++i) {
        s = scenes[i]
        printf "| `%s` | %s | %.1f | %.1f | %.2f |\n", s, tree[s], 1e6 * best[s], 1e6 * brute[s], best[s] / brute[s]
    }
}
