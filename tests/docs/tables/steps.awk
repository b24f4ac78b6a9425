# The longest step at which each method held the sheet, and the longest at which it neither blew up nor was ruined.
{
    method = cell("method")
    if (!(method in seen)) seen[method] = methods[++count] = method
    if (cell("end") == "held" && cell("step_s") > held[method]) { held[method] = cell("step_s"); cost[method] = cell("cost_s_per_s") }
    if (cell("end") != "blew_up" && cell("end") != "ruined" && cell("step_s") > whole[method]) { whole[method] = cell("step_s") }
}
END {
    print "| Method | Held up to [ms] | at a cost of [s/s] | Neither ruined nor blown up, up to [ms] |"
    print "| --- | ---: | ---: | ---: |"
    for (m = 1; m <= count; ++m) {
        method = methods[m]
        if (!held[method]) printf "| `%s` | - | - | %s |\n", method, whole[method] ? sprintf("%.3g", 1e3 * whole[method]) : "-"
        else printf "| `%s` | %.3g | %.2g | %.3g |\n", method, 1e3 * held[method], cost[method], 1e3 * whole[method]
    }
}
