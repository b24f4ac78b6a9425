# The largest cloth that each method moves in real time on one thread, by motion.
cell("end") == "realtime" && cell("threads") == 1 {
    m = cell("method")
    if (!(m in known)) known[m] = names[++count] = m
    key = m SUBSEP cell("motion")
    side[key] = cell("side")
    error[key] = 100 * cell("error")
}
END {
    print "| Method, steps a frame | Free: particles a side, error [%] | On a ball | Folding |"
    print "| --- | ---: | ---: | ---: |"
    for (i = 1; i <= count; ++i) {
        line = "| `" names[i] "`"
        split("free ball fold", motions, " ")
        for (k = 1; k <= 3; ++k) {
            key = names[i] SUBSEP motions[k]
            line = line " | " ((key in side) ? sprintf("%d, %.2g", side[key], error[key]) : "-")
        }
        print line " |"
    }
}
