# What a search that ends early does to the simulated motion; spheres.
cell("part") == "budget" && cell("volume") == "sphere" {
    end = cell("tests") == "nan" ? "level " cell("level") : cell("tests") (cell("tests") == 1 ? " test" : " tests")
    if (!(end in known)) known[end] = ends[++count] = end
    value[end, cell("scene")] = sprintf("%.3g | %.2g | %.3g", 1e3 * cell("missed_penetration_m"), cell("false_contacts"), 1e3 * cell("distance_m"))
}
END {
    print "| Search ends at | `drop`: missed [mm] | false | distance [mm] | `curtain`: missed [mm] | false | distance [mm] |"
    print "| --- | ---: | ---: | ---: | ---: | ---: | ---: |"
    for (i = 1; i <= count; ++i) {
        if (!((ends[i], "drop") in value) || !((ends[i], "curtain") in value)) continue
        print "| " ends[i] " | " value[ends[i], "drop"] " | " value[ends[i], "curtain"] " |"
    }
}
