# What is left with each fail-safe and with none.
{
    key = cell("thickness_m") SUBSEP cell("step_s")
    if (!(key in head)) {
        order[++count] = key
        head[key] = sprintf("| %.4g | 1/%.0f |", 1e3 * cell("thickness_m"), 1 / cell("step_s"))
    }
    crossed[key] = crossed[key] sprintf(" %.0f |", 100 * cell("crossed_steps"))
    entered[key] = entered[key] sprintf(" %.3g |", 1e3 * cell("penetration_m"))
    momentum[key] = momentum[key] sprintf(" %.1f |", 100 * cell("momentum_error"))
}
END {
    print "| Thickness [mm] | Step [s] | Steps with crossings [%]: zones | rejection | none | Penetration [mm]: zones | rejection | none | Error of momentum [%]: zones | rejection | none |"
    print "| ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"
    for (i = 1; i <= count; ++i) print head[order[i]] crossed[order[i]] entered[order[i]] momentum[order[i]]
}
