# Frames by every method, as multiples of the first, with a column a scene and size.
{
    where = cell("scene") " " cell("side") "²"; method = cell("method")
    if (!(where in first)) { place[++places] = where; first[where] = cell("total_us"); boxes[where] = cell("box_pairs"); near[where] = cell("near_pairs") }
    if (!(method in known)) { known[method] = 1; name[++methods] = method }
    ratio[method, where] = cell("ratio")
    if (cell("ties") != 0) fail(method " has ties: the page says that there are none")
}
function row(title, values, format,   i, line) {
    line = "| " title " |"
    for (i = 1; i <= places; ++i) line = line sprintf(" " format " |", values[place[i]])
    print line
}
END {
    if (failed) exit 2
    line = "| |"; rule = "| --- |"
    for (i = 1; i <= places; ++i) { line = line " " place[i] " |"; rule = rule " ---: |" }
    print line "\n" rule
    row("pairs whose boxes overlap", boxes, "%.0f")
    row("pairs nearer than the thickness", near, "%.0f")
    row(name[1] " [us a frame]", first, "%.0f")
    for (m = 1; m <= methods; ++m) {
        for (i = 1; i <= places; ++i) {
            if (!((name[m], place[i]) in ratio)) fail("there is no row " name[m] " of " place[i])
            one[place[i]] = ratio[name[m], place[i]]
        }
        row(name[m], one, "%.2f")
    }
}
