# The methods without a limit: the shortest step that failed, over the stiffness, without damping and with.
function written(step) { return step == "" ? "-" : "1/" sprintf("%.0f", 1 / step) }
cell("expected_step_s") == "inf" && cell("sweep") != "damping" {
    method = cell("method")
    if (!(method in known)) known[method] = order[++count] = method
    key = method SUBSEP (cell("stiffness_N_per_m") + 0) SUBSEP cell("sweep")
    if (cell("end") != "bounded") {
        if (!(key in failed_at) || cell("step_s") < failed_at[key]) failed_at[key] = cell("step_s")
        end = cell("end")
        gsub("_", " ", end)
        if (index(how[method], end) == 0) how[method] = how[method] (how[method] == "" ? "" : ", ") end
    }
}
END {
    print "| Method | 10^2 | 10^3 | 10^4 | 10^5 | 10^6 | How |"
    print "| --- | --- | --- | --- | --- | --- | --- |"
    for (i = 1; i <= count; ++i) {
        name = order[i]
        gsub("_", " ", name)
        line = "| " name " |"
        for (k = 100; k <= 1e6; k *= 10) {
            plain = written(failed_at[order[i], k, "stiffness"])
            damped = written(failed_at[order[i], k, "damped_stiffness"])
            line = line " " plain (damped == plain ? "" : " (" damped ")") " |"
        }
        print line " " how[order[i]] " |"
    }
}
