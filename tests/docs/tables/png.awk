# Encoders of PNG: time and size of one picture.
{ row[++count] = sprintf("| %s | %s | %s | %s | %s |", cell("encoder"), cell("filter"), cell("level"), cell("time_ms"), cell("size_kB")) }
END {
    print "| Encoder | Filter | Level | Time [ms] | Size [kB] |"
    print "| --- | --- | --- | ---: | ---: |"
    for (i = 1; i <= count; ++i) print row[i]
}
