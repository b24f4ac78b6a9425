# How deep a ball is when the full search finds it, against how far it goes in a step; and which searches it gets through.
{
    key = cell("speed_m_per_s") SUBSEP cell("step_s")
    if (!(key in through)) {
        order[++count] = key
        through[key] = ""
    }
    search = cell("search") == "full" ? "full" : cell("tests")
    if (cell("passed") == 1) through[key] = through[key] (through[key] == "" ? "" : ", ") search
}
cell("search") == "full" {
    travel = cell("speed_m_per_s") * cell("step_s")
    ratio = cell("passed") == 1 ? "" : sprintf("%.2f", cell("penetration_m") / travel)
    row[key] = sprintf("| %s | 1/%.0f | %.4g | %.3g | %s | %.1f |", cell("speed_m_per_s"), 1 / cell("step_s"), 1e3 * travel, \
                       1e3 * cell("penetration_m"), ratio, 100 * cell("missed_contacts"))
}
END {
    print "| Speed [m/s] | Step [s] | Travel in a step [mm] | Penetration [mm] | Penetration / travel | Missed contacts [%] | Through the cloth, by search |"
    print "| ---: | ---: | ---: | ---: | ---: | ---: | --- |"
    for (i = 1; i <= count; ++i) print row[order[i]] " " through[order[i]] " |"
}
