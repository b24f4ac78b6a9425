# What a discrete, a continuous and two limited searches miss and leave, and which of them a ball gets through.
{
    key = cell("speed_m_per_s") SUBSEP cell("step_s")
    search = cell("search") == "limited" ? cell("tests") : cell("search")
    if (!(key in through)) {
        order[++count] = key
        through[key] = ""
        travel = cell("speed_m_per_s") * cell("step_s")
        head[key] = sprintf("| %s | 1/%.0f | %.4g |", cell("speed_m_per_s"), 1 / cell("step_s"), 1e3 * travel)
    }
    if (cell("passed") == 1) through[key] = through[key] (through[key] == "" ? "" : ", ") search
    missed[key, search] = sprintf(" %.1f |", 100 * cell("missed_contacts"))
    left[key, search] = sprintf(" %.3g |", 1e3 * cell("left_m"))
    momentum[key, search] = sprintf(" %.1f |", 100 * cell("momentum_error"))
}
END {
    print "| Speed [m/s] | Step [s] | Travel in a step [mm] | Missed contacts [%]: discrete | continuous | 24 tests | 12 tests | Penetration left [mm]: discrete | continuous | Error of momentum [%]: discrete | continuous | Through the cloth |"
    print "| ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- |"
    for (i = 1; i <= count; ++i) {
        k = order[i]
        print head[k] missed[k, "discrete"] missed[k, "continuous"] missed[k, "24"] missed[k, "12"] left[k, "discrete"] \
              left[k, "continuous"] momentum[k, "discrete"] momentum[k, "continuous"] " " through[k] " |"
    }
}
