# The largest cloth that each method moves in real time, by motion, on one thread and on two.
cell("end") == "realtime" {
    m = cell("method")
    if (!(m in known)) known[m] = names[++count] = m
    key = m SUBSEP cell("motion")
    if (cell("threads") == 1) { side[key] = cell("side"); error[key] = 100 * cell("error") }
    if (cell("threads") == 2) two[key] = cell("side")
}
END {
    print "| Method, steps a frame | Free: particles a side (two threads), error [%] | On a ball | Folding |"
    print "| --- | ---: | ---: | ---: |"
    for (i = 1; i <= count; ++i) {
        line = "| `" names[i] "`"
        split("free ball fold", motions, " ")
        for (k = 1; k <= 3; ++k) {
            key = names[i] SUBSEP motions[k]
            both = (key in two) ? two[key] : "-"
            line = line " | " ((key in side) ? sprintf("%d (%s), %.2g", side[key], both, error[key]) : "-")
        }
        print line " |"
    }
}
