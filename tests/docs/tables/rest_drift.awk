# How far a cloth creeps that rests, by method and step, and what that is in ten minutes.
cell("part") == "drift" {
    m = cell("integrator")
    if (!(m in known)) known[m] = names[++count] = m
    step = sprintf("%.3g", 1e3 * cell("step_s"))
    drift[m, step] = cell("end") == "diverged" ? "diverged" \
                     : sprintf("%.2g", 1e3 * cell("drift_m") * 600 / cell("watched_s"))
    speed[m, step] = cell("end") == "diverged" ? "" : sprintf("%.2g", 1e3 * cell("speed_after_m_per_s"))
    watched[m, step] = sprintf("%.0f", cell("watched_s"))
    if (!(step in seen)) {
        seen[step] = 1
        steps[++step_count] = step
    }
}
END {
    print "| Method | Step [ms] | Watched for [s] | Creep in ten minutes [mm] | Speed [mm/s] |"
    print "| --- | ---: | ---: | ---: | ---: |"
    for (i = 1; i <= count; ++i) {
        for (k = 1; k <= step_count; ++k) {
            m = names[i]
            s = steps[k]
            if ((m, s) in drift) {
                printf "| `%s` | %s | %s | %s | %s |\n", m, s, watched[m, s], drift[m, s], speed[m, s]
            }
        }
    }
}
