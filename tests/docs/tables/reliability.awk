# What was tried: the last row of each kind.
{
    key = cell("what") " (" cell("build") ")"
    if (!(key in row)) order[++count] = key
    row[key] = "| " key " | " cell("tried") " | " cell("failed") " | " cell("seconds") " | " \
               cell("date") " | " cell("commit") " | " cell("machine") " |"
}
END {
    print "| What was tried (build) | Times | Failed | Seconds | Date | Commit | Machine |"
    print "| --- | --- | --- | --- | --- | --- | --- |"
    for (i = 1; i <= count; ++i) print row[order[i]]
}
