# A solver a line, as multiples of the first, with a column a motion and size; first to the one residual, then to the other.
{
    where = cell("motion") " " cell("side") "²"; to = cell("tolerance"); method = cell("method")
    if (!(where in seen)) { seen[where] = 1; place[++places] = where }
    if (!(to in known)) { known[to] = 1; tolerance[++tolerances] = to }
    if (!(method in named)) { named[method] = 1; name[++methods] = method }
    if (method == name[1]) first[to, where] = cell("total_ms")
    ratio[method, to, where] = cell("total_ms") / first[to, where]
    alone[method, to, where] = cell("solve_ms") / first[to, where]
    direct[method] = cell("iterations") == 0
}
function row(title, method, to, of,   i, line) {
    line = "| " title " |"
    for (i = 1; i <= places; ++i) {
        if (!((method, to, place[i]) in of)) fail("there is no row " method " of " place[i])
        line = line sprintf(" %.3g |", of[method, to, place[i]])
    }
    print line
}
END {
    if (failed) exit 2
    line = "| To a residual of |"; rule = "| --- |"
    for (i = 1; i <= places; ++i) { line = line " " place[i] " |"; rule = rule " ---: |" }
    print line "\n" rule
    for (t = 1; t <= tolerances; ++t) {
        to = tolerance[t]
        line = "| " to ": " name[1] " [ms] |"
        for (i = 1; i <= places; ++i) line = line sprintf(" %.3g |", first[to, place[i]])
        print line
        for (m = 2; m <= methods; ++m) {
            row(to ": " name[m], name[m], to, ratio)
            if (direct[name[m]]) row(to ": " name[m] ", solve alone", name[m], to, alone)
        }
    }
}
