# What drawing a picture costs: our own code, and all of it.
function cost(name) { return sprintf("%.3g (%.3g to %.3g)", cell(name "_ms"), cell(name "_q1_ms"), cell(name "_q3_ms")) }
!printed++ {
    print "| Picture | OpenGL calls | Drape's own code [ms] | All of it [ms] |"
    print "| --- | ---: | ---: | ---: |"
}
{ printf "| %s | %d | %s | %s |\n", cell("what"), cell("calls"), cost("own"), cost("all") }
