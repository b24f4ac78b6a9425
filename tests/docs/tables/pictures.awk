# What a picture costs: the last row of each way to draw it.
{
    what = cell("what")
    if (!(what in row)) order[++count] = what
    all = cell("simulating_ms") + cell("drawing_ms") + cell("writing_ms")
    row[what] = sprintf("| %s | %.0f | %.0f | %.0f | %.0f | %s | %s |", what, cell("simulating_ms"), cell("drawing_ms"), \
                        cell("writing_ms"), all, cell("date"), cell("commit"))
}
END {
    print "| Way | Simulating [ms] | Drawing [ms] | Reading back and PNG [ms] | All [ms] | Date | Commit |"
    print "| --- | ---: | ---: | ---: | ---: | --- | --- |"
    for (i = 1; i <= count; ++i) print row[order[i]]
}
