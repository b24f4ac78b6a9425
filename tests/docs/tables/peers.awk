# The rows as they are, with a column a precision and size.
{
    line = "| " cell("method") " |"
    for (i = 2; i <= columns; ++i) line = line " " $i " |"
    row[++count] = line
    for (name in column) if (column[name] > 1) title[column[name]] = name
}
END {
    line = "| |"
    rule = "| --- |"
    for (i = 2; i <= columns; ++i) {
        name = title[i]
        sub("_", " ", name)
        line = line " " name "² |"
        rule = rule " ---: |"
    }
    print line "\n" rule
    for (i = 1; i <= count; ++i) print row[i]
}
