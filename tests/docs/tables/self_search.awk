# What a search for pairs costs a triangle, and by which power of their number the broad phase grows.
{
    what = cell("what"); n = cell("triangles") + 0; t = cell("cpu_us") + 0
    if (what != "broad_phase" && what != "new_list" && what != "listed") next
    if (!(n in side)) { side[n] = cell("side"); order[++count] = n }
    cost[what, n] = 1e3 * t / n
    if (what != "broad_phase") next
    x = log(n); y = log(t)
    ++m; sx += x; sy += y; sxx += x * x; sxy += x * y
}
END {
    if (failed) exit 2
    if (count < 2) fail("there is nothing to fit")
    split("broad_phase new_list listed", whats, " ")
    print "| Particles a side | Triangles of all three sheets | Broad phase [ns a triangle] | New list [ns a triangle] | Step with a list [ns a triangle] |"
    print "| ---: | ---: | ---: | ---: | ---: |"
    for (i = 1; i <= count; ++i) {
        n = order[i]
        for (w = 1; w <= 3; ++w) if (!((whats[w], n) in cost)) fail("there is no row " whats[w] " of " n " triangles")
        printf "| %d | %d | %.0f | %.0f | %.0f |\n", side[n], n, cost["broad_phase", n], cost["new_list", n], cost["listed", n]
    }
    printf "\nThe cost of the broad phase grows with the number of triangles by the power %.2f.\n", \
           (m * sxy - sx * sy) / (m * sxx - sx * sx)
}
