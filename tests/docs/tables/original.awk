# What does not depend on the machine: calls, vertices and candidates, spheres against boxes.
function same(name, value) {
    if (name in is && is[name] != value) fail(name " differs from row to row: " is[name] " and " value)
    is[name] = value
}
{
    way = cell("volume") cell("bounds_drawn")
    same("calls " way, cell("gl_calls"))
    same("vertices " way, cell("vertices"))
    same("leaves " cell("volume"), cell("candidates"))
    same("single " cell("volume"), cell("single_candidates"))
}
function line(title, key, published) {
    print "| " title " | " is[key "sphere" 0] " | " is[key "aabb" 0] " | " is[key "sphere" 1] " | " is[key "aabb" 1] " | " published " |"
}
function search(title, key) {
    print "| " title " | " is[key "sphere"] " | " is[key "aabb"] " | | | |"
}
END {
    print "| | Spheres | Boxes | Spheres, drawn | Boxes, drawn | Published |"
    print "| --- | ---: | ---: | ---: | ---: | ---: |"
    line("OpenGL calls per frame", "calls ", "15000 (peak)")
    line("vertices per frame", "vertices ", "42000")
    search("candidates, leaves of 7 x 7 cells", "leaves ")
    search("candidates, leaves of one cell", "single ")
}
