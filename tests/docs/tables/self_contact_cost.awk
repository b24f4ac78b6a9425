# What each fail-safe does, and what it costs against none.
{
    key = cell("thickness_m") SUBSEP cell("step_s")
    safe = cell("fail_safe")
    if (safe == "zones") {
        order[++count] = key
        head[key] = sprintf("| %.4g | 1/%.0f | %.0f |", 1e3 * cell("thickness_m"), 1 / cell("step_s"), \
                            100 * cell("unsearched_steps"))
        held[key] = sprintf(" %.1f |", cell("held_back"))
    }
    if (safe == "rejection") {
        rejected[key] = sprintf(" %.1f |", cell("rejected"))
        unsafe[key] = sprintf(" %.0f |", 100 * cell("unsafe_steps"))
    }
    tests[key, safe] = sprintf(" %.0f |", cell("pair_tests"))
    cpu[key, safe] = cell("cpu_s_per_s")
}
END {
    print "| Thickness [mm] | Step [s] | Zones: steps in which the search gave up [%] | Zones: particles held back a step | Rejection: tries taken back a step | Rejection: steps in which 10 halvings were too few [%] | Tests of pairs a step: zones | rejection | CPU time, of that with none: zones | rejection |"
    print "| ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"
    for (i = 1; i <= count; ++i) {
        k = order[i]
        print head[k] held[k] rejected[k] unsafe[k] tests[k, "zones"] tests[k, "rejection"] \
              sprintf(" %.2f | %.2f |", cpu[k, "zones"] / cpu[k, "none"], cpu[k, "rejection"] / cpu[k, "none"])
    }
}
