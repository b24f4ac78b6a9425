# The step limit of a penalty, measured over predicted, over all stiffnesses.
cell("part") == "limit" {
    e = cell("restitution")
    ratio = cell("measured_step_s") / cell("predicted_step_s")
    if (!(e in low)) { order[++count] = e; low[e] = high[e] = ratio }
    if (ratio < low[e]) low[e] = ratio
    if (ratio > high[e]) high[e] = ratio
}
END {
    print "| Restitution | Measured / predicted, least | Greatest |"
    print "| ---: | ---: | ---: |"
    for (i = 1; i <= count; ++i) printf "| %s | %.2f | %.2f |\n", order[i], low[order[i]], high[order[i]]
}
