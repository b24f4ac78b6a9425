# Error and cost of every method by its step: the two longest, then every second one.
{
    step = cell("step_ms"); method = cell("method")
    if (!(method in known)) { known[method] = 1; name[++methods] = method }
    if (!(step in seen)) { seen[step] = 1; steps[++count] = step }
    point[method, step] = sprintf("%.2g, %.2g", cell("error_percent"), cell("cost_s_per_s"))
}
END {
    if (failed) exit 2
    line = "| Method, step [ms] |"; rule = "| --- |"
    for (i = 1; i < count; i += i < 3 ? 1 : 2) { line = line sprintf(" %.3g |", steps[i]); rule = rule " ---: |" }
    print line "\n" rule
    for (m = 1; m <= methods; ++m) {
        line = "| " name[m] " |"
        for (i = 1; i < count; i += i < 3 ? 1 : 2) line = line " " ((name[m], steps[i]) in point ? point[name[m], steps[i]] : "-") " |"
        print line
    }
}
