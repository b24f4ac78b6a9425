# The methods with a limit: how many trials contradict the prediction, and how far the measured limit is from it.
cell("expected_step_s") != "inf" {
    method = cell("method")
    ratio = cell("measured_step_s") / cell("expected_step_s")
    if (!(method in trials)) {
        order[++count] = method
        least[method] = most[method] = ratio
    }
    ++trials[method]
    against[method] += cell("agreement") == "disagrees"
    if (ratio < least[method]) least[method] = ratio
    if (ratio > most[method]) most[method] = ratio
}
END {
    print "| Method | Trials | Contradict the prediction | Measured limit / predicted limit |"
    print "| --- | ---: | ---: | ---: |"
    for (i = 1; i <= count; ++i) {
        printf "| `%s` | %d | %d | %.4f to %.4f |\n", order[i], trials[order[i]], against[order[i]], least[order[i]], most[order[i]]
    }
}
