# What contact adds to a step of a sheet that cannot touch itself, and what a second of `fold` takes.
function need(what) { if (!(what in us)) fail("there is no row " what); return us[what] }
{ us[cell("what")] = cell("cpu_us") + 0 }
END {
    if (failed) exit 2
    print "| What | CPU time | Compared |"
    print "| --- | ---: | ---: |"
    for (i = 1; i <= split("flat draped", sheets, " "); ++i) {
        added = need(sheets[i] "_added")
        integration = need(sheets[i] "_integration")
        printf "| `self = true` for %s, a step | %.0f us | %.1f of its integration, %.0f us |\n", i == 1 ? "the flat sheet" : "the sheet that falls over the ball", added, \
               added / integration, integration
    }
    for (i = 1; i <= split("symplectic_euler backward_euler xpbd projective_dynamics", methods, " "); ++i) {
        t = need("fold_" methods[i]) / 1e6
        printf "| A second of `fold`, `%s` | %.1f s | %.1f seconds of one core for one |\n", methods[i], t, t
    }
}
