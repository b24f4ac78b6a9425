# What each scene is, and what one notch less of each knob that it leaves free would break.
cell("part") == "ladder" && cell("integrator") == "dormand_prince" && !(cell("scene") in full) { full[cell("scene")] = cell("cost_s_per_s") }
cell("part") == "notches" && cell("changed") == "none" {
    scene = cell("scene")
    scenes[++count] = scene
    model[scene] = cell("particles_x") " x " cell("particles_y") (cell("bend") == "yes" ? ", bend" : "") (cell("drag") == "yes" ? ", drag" : "")
    step[scene] = sprintf("%.3g", 1e3 * cell("step_s"))
    method[scene] = cell("integrator")
    gsub("_", " ", method[scene])
    cost[scene] = cell("cost_s_per_s")
    error[scene] = cell("error") == "nan" ? "" : sprintf("%.2g of %.2g", 100 * cell("error"), 100 * cell("allowed_error"))
}
cell("part") == "notches" && cell("changed") != "none" {
    knob = cell("changed") == "dt" ? "step" : cell("changed")
    why = cell("miss") == "nan" ? (knob == "step" ? "above 0.9 of its limit" : "no longer fails") : sprintf("%.2g times what is allowed", cell("miss"))
    broken[cell("scene")] = broken[cell("scene")] (broken[cell("scene")] ? "; " : "") knob ": " why
}
END {
    print "| Scene | Model | Method | Step [ms] | Error [% of the side] | Cost [ms/s] | Full model, solved accurately [ms/s] | One notch less of |"
    print "| --- | --- | --- | ---: | ---: | ---: | ---: | --- |"
    for (s = 1; s <= count; ++s) {
        scene = scenes[s]
        printf "| `%s` | %s | %s | %s | %s | %.3g | %s | %s |\n", scene, model[scene], method[scene], step[scene], error[scene], \
            1e3 * cost[scene], scene in full ? sprintf("%.3g", 1e3 * full[scene]) : "", broken[scene] ? broken[scene] : "nothing is free"
    }
}
