# What contact adds to a step of a sheet that cannot touch itself, and what a second of `fold` takes.
{ us[cell("what")] = cell("cpu_us") + 0 }
END {
    print "| What | CPU time | Of the goal |"
    print "| --- | ---: | ---: |"
    for (i = split("flat draped", sheets, " "); i > 0; --i) order[i] = sheets[i]
    for (i = 1; i <= 2; ++i) {
        s = order[i]
        added = us[s "_self"] - us[s]
        printf "| `self = true` for the %s sheet, a step | %.0f us | %.1f of the integration's %.0f us |\n", s, added, added / us["integration"], us["integration"]
    }
    for (i = split("symplectic_euler backward_euler xpbd projective_dynamics", methods, " "); i > 0; --i) last = i
    for (i = 1; i <= 4; ++i) {
        if (!("fold_" methods[i] in us)) continue
        t = us["fold_" methods[i]] / 1e6
        printf "| A second of `fold`, `%s` | %.1f s | %.1f of real time |\n", methods[i], t, t
    }
}
