# What is left with the fail-safe and without, and what both cost.
{
    key = cell("thickness_m") SUBSEP cell("step_s")
    if (!(key in head)) {
        order[++count] = key
        head[key] = sprintf("| %.4g | 1/%.0f |", 1e3 * cell("thickness_m"), 1 / cell("step_s"))
        tests[key] = sprintf(" %.0f |", cell("pair_tests"))
    }
    safe = cell("fail_safe")
    crossed[key, safe] = sprintf(" %.0f |", 100 * cell("crossed_steps"))
    entered[key, safe] = sprintf(" %.3g |", 1e3 * cell("penetration_m"))
    momentum[key, safe] = sprintf(" %.1f |", 100 * cell("momentum_error"))
    if (safe == "on") held[key] = sprintf(" %.1f |", cell("held_back"))
    unsearched[key] = sprintf(" %.0f |", 100 * cell("unsearched_steps"))
    cpu[key, safe] = cell("cpu_s_per_s")
}
END {
    print "| Thickness [mm] | Step [s] | Steps with crossings [%]: fail-safe on | off | Penetration [mm]: on | off | Error of momentum [%]: on | off | Steps in which the search gave up [%] | Tests of pairs a step: on | Particles held back a step: on | CPU time on / off |"
    print "| ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"
    for (i = 1; i <= count; ++i) {
        k = order[i]
        print head[k] crossed[k, "on"] crossed[k, "off"] entered[k, "on"] entered[k, "off"] momentum[k, "on"] \
              momentum[k, "off"] unsearched[k] tests[k] held[k] sprintf(" %.2f |", cpu[k, "on"] / cpu[k, "off"])
    }
}
