# The methods with a limit: how many trials contradict the prediction, and how far the measured limit is from it.
cell("expected_step_s") != "inf" {
    method = cell("method")
    ratio = cell("measured_step_s") / cell("expected_step_s")
    if (!(method in least)) {
        order[++count] = method
        least[method] = most[method] = ratio
    }
    if (cell("agreement") == "close") ++close_to[method]
    else ++trials[method]
    against[method] += cell("agreement") == "disagrees"
    if (ratio < least[method]) least[method] = ratio
    if (ratio > most[method]) most[method] = ratio
}
END {
    print "| Method | Close trials | Other trials | Contradict the prediction | Measured limit / predicted limit |"
    print "| --- | ---: | ---: | ---: | ---: |"
    for (i = 1; i <= count; ++i) {
        printf "| `%s` | %d | %d | %d | %.4f to %.4f |\n", order[i], close_to[order[i]], trials[order[i]], against[order[i]], least[order[i]], most[order[i]]
    }
}
