# The cells that a search passes to the exact test, in per cent: three scenes, 128 x 128 particles, leaves of 4 x 4 cells.
cell("part") == "fit" && cell("particles") == 16384 && cell("leaf_cells") == 4 && cell("volume") != "brute" &&
(cell("volume") != "sphere" || cell("sphere_fit") == "centroid") {
    volume = cell("volume")
    if (!(volume in known)) known[volume] = volumes[++count] = volume
    share = sprintf("%.1f", 100 * cell("candidates") / (127 * 127))
    update = cell("update")
    if (!(update in listed)) listed[update] = updates[++policies] = update
    key = volume SUBSEP update
    shares[key] = shares[key] (shares[key] == "" ? "" : " / ") share
    touching[cell("scene")] = 100 * cell("touching") / (127 * 127)
}
END {
    head = "| Volume |"
    rule = "| --- |"
    for (u = 1; u <= policies; ++u) {
        head = head " `" updates[u] "` |"
        rule = rule " ---: |"
    }
    print head "\n" rule
    for (v = 1; v <= count; ++v) {
        line = "| `" volumes[v] "` |"
        for (u = 1; u <= policies; ++u) line = line " " shares[volumes[v], updates[u]] " |"
        print line
    }
    printf "\nPer cent of all cells in `drop` / `two_corners` / `curtain`; %.1f / %.1f / %.1f touch the ball.\n", \
           touching["drop"], touching["two_corners"], touching["curtain"]
}
