# False candidates for a true one of a search that ends at a level; `curtain`, rebuilt, leaves of one cell.
cell("part") == "level" && cell("scene") == "curtain" && cell("update") == "rebuild" {
    name = cell("volume") (cell("sphere_fit") == "welzl" ? " (smallest)" : "")
    if (!(name in known)) known[name] = names[++count] = name
    if (cell("level") > last) last = cell("level")
    ratio[name, cell("level")] = cell("false_per_true")
}
END {
    line = "| Level |"
    rule = "| ---: |"
    for (n = 1; n <= count; ++n) {
        line = line " " names[n] " |"
        rule = rule " ---: |"
    }
    print line "\n" rule
    for (level = 0; level <= last; ++level) {
        line = "| " level " |"
        for (n = 1; n <= count; ++n) line = line sprintf(" %.3g |", ratio[names[n], level])
        print line
    }
}
