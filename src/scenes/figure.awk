# Writes the mesh of the scene `figure`, a bust, in metres:  awk -f src/scenes/figure.awk > src/scenes/figure.obj
# Rings of points about the y axis, ellipses whose half widths follow a smooth curve through the rows below, between a
# point at the bottom and one at the top.

BEGIN {
    columns = 40; steps = 3
    # height, half width along x, half width along z, middle along z
    row("0.000 0.160 0.120 0.000"); row("0.020 0.166 0.126 0.000"); row("0.050 0.130 0.100 0.000")
    row("0.120 0.115 0.090 0.000"); row("0.200 0.150 0.104 0.004"); row("0.300 0.194 0.118 0.004")
    row("0.360 0.204 0.104 0.000"); row("0.400 0.160 0.084 0.000"); row("0.428 0.088 0.066 0.000")
    row("0.455 0.060 0.060 0.002"); row("0.480 0.060 0.062 0.006"); row("0.515 0.073 0.084 0.014")
    row("0.570 0.084 0.102 0.012"); row("0.620 0.076 0.094 0.004"); row("0.652 0.048 0.060 0.000")
    row("0.664 0.018 0.023 0.000")
    print "# Made by src/scenes/figure.awk"
    printf "v 0 0 0\n"
    for (k = 1; k < rows; ++k) for (s = 0; s < steps; ++s) ring(k, s / steps)
    ring(rows, 0)
    printf "v 0 %.5f 0\n", value[rows, 1] + 0.002
    for (c = 0; c < columns; ++c) printf "f 1 %d %d\n", point(0, c + 1), point(0, c)
    for (r = 0; r + 1 < rings; ++r) {
        for (c = 0; c < columns; ++c) {
            printf "f %d %d %d\n", point(r, c), point(r, c + 1), point(r + 1, c)
            printf "f %d %d %d\n", point(r, c + 1), point(r + 1, c + 1), point(r + 1, c)
        }
    }
    for (c = 0; c < columns; ++c) printf "f %d %d %d\n", point(rings - 1, c), point(rings - 1, c + 1), rings * columns + 2
}

function row(text) { ++rows; for (i = split(text, words, " "); i > 0; --i) value[rows, i] = words[i] }

function point(r, c) { return 2 + r * columns + c % columns }

# Catmull and Rom's curve between rows k and k + 1
function curve(k, i, t,    a, b, c, d) {
    b = value[k, i]; c = value[k < rows ? k + 1 : rows, i]
    a = k > 1 ? value[k - 1, i] : b; d = k + 1 < rows ? value[k + 2, i] : c
    return b + t * ((c - a) + t * ((2 * a - 5 * b + 4 * c - d) + t * (3 * (b - c) + d - a))) / 2
}

function ring(k, t,    c, turn) {
    ++rings
    for (c = 0; c < columns; ++c) {
        turn = 2 * 3.14159265358979 * c / columns
        printf "v %.5f %.5f %.5f\n", curve(k, 2, t) * cos(turn), curve(k, 1, t), curve(k, 4, t) - curve(k, 3, t) * sin(turn)
    }
}
