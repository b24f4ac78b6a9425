# What a response takes where a sheet rests, and what it gets wrong at a long and at a short step.
cell("part") == "step" {
    r = cell("response")
    if (!(r in known)) known[r] = names[++count] = r
    rate = sprintf("%.0f", 1 / cell("step_s"))
    height[r, rate] = 100 * cell("height_error")
    impact[r, rate] = 1e3 * cell("impact_error_s")
    sweeps[r, rate] = cell("sweeps")
    cost[r, rate] = 1e6 * cell("respond_s")
}
END {
    print "| Response | Sweeps at rest | CPU time of a response at rest [us] | Time of impact off by [ms], step 1/60 s | 1/960 s | 1/15360 s | Bounce off by [%], step 1/60 s | 1/960 s | 1/15360 s |"
    print "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"
    for (i = 1; i <= count; ++i) {
        r = names[i]
        printf "| `%s` | %.0f | %.1f | %.3g | %.3g | %.3g | %.3g | %.3g | %.3g |\n", r, sweeps[r, 960], cost[r, 960],
               impact[r, 60], impact[r, 960], impact[r, 15360], height[r, 60], height[r, 960], height[r, 15360]
    }
}
