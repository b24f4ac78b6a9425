# How far a cloth has crept that rests, by method and step.
cell("part") == "drift" {
    m = cell("integrator")
    if (!(m in known)) known[m] = names[++count] = m
    step = sprintf("%.3g", 1e3 * cell("step_s"))
    if ((m, step) in watched) fail("two runs of " m " at " step " ms: take the cases of one time alone")
    watched[m, step] = sprintf("%.0f", cell("watched_s"))
    if (cell("end") == "diverged") {
        found[m, step] = "diverged | "
    } else {
        found[m, step] = sprintf("%.2g | %.2g", 1e3 * cell("drift_m"), 1e3 * cell("speed_after_m_per_s"))
    }
    if (!(step in seen)) {
        seen[step] = 1
        steps[++step_count] = step
    }
}
END {
    print "| Method | Step [ms] | Watched for [s] | Farthest of any particle [mm] | Speed, RMS [mm/s] |"
    print "| --- | ---: | ---: | ---: | ---: |"
    for (i = 1; i <= count; ++i) {
        for (k = 1; k <= step_count; ++k) {
            m = names[i]
            s = steps[k]
            if ((m, s) in found) printf "| `%s` | %s | %s | %s |\n", m, s, watched[m, s], found[m, s]
        }
    }
}
