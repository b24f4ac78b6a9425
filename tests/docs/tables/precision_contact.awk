# The error at a step, by method, where a sheet falls on a ball: at the steps of the series, each half of the one before.
function is_of_series(step) { step = log(0.03 / step) / log(2); return step - int(step + 0.5) < 0.01 && int(step + 0.5) - step < 0.01 }
cell("scene") == "contact" && is_of_series(cell("step_s")) {
    method = cell("method")
    if (!(method in known)) known[method] = methods[++count] = method
    step = cell("step_s")
    if (!(step in known)) known[step] = steps[++step_count] = step
    error[method, step] = cell("end") == "bounded" ? sprintf("%.2g", cell("error")) : "-"
}
END {
    line = "| Method, step [ms] |"
    rule = "| --- |"
    for (s = 1; s <= step_count; ++s) {
        line = line sprintf(" %.3g |", 1e3 * steps[s])
        rule = rule " ---: |"
    }
    print line "\n" rule
    for (m = 1; m <= count; ++m) {
        line = "| `" methods[m] "` |"
        for (s = 1; s <= step_count; ++s) line = line " " error[methods[m], steps[s]] " |"
        print line
    }
}
