# The cheapest point of each family that is at most so wrong. A point counts if the method was stable at all shorter
# steps of the series too; the cheapest of a row is bold.
{
    method = cell("method")
    if (cell("end") != "bounded") {
        points[method] = 0
        next
    }
    if (!(method in points)) points[method] = 0
    n = ++points[method]
    error[method, n] = cell("error")
    cost[method, n] = cell("cost_s_per_s")
    step[method, n] = cell("step_s")
}
function family(method) {
    if (method ~ /^(backward|implicit|bdf2)/) return 2
    return method ~ /^(xpbd|projective)/ ? 3 : 1
}
END {
    print "| Error at most | Explicit: step [ms], cost [s/s] | Implicit | Positional |"
    print "| ---: | --- | --- | --- |"
    levels = split("1e-1 1e-2 1e-3 1e-4 1e-5 1e-6 1e-8", level, " ")
    for (l = 1; l <= levels; ++l) {
        delete least
        all = 0
        for (method in points) {
            f = family(method)
            for (n = 1; n <= points[method]; ++n) {
                if (error[method, n] + 0 > level[l] + 0) continue
                c = cost[method, n] + 0
                if (!(f in least) || c < least[f]) {
                    least[f] = c
                    text[f] = sprintf("`%s`: %.3g, %.2g", method, 1e3 * step[method, n], c)
                }
                if (all == 0 || c < all) all = c
            }
        }
        if (all == 0) continue
        line = "| " level[l] " |"
        for (f = 1; f <= 3; ++f) {
            shown = f in least ? text[f] : "-"
            line = line " " (f in least && least[f] == all ? "**" shown "**" : shown) " |"
        }
        print line
    }
}
