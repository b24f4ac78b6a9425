# The worst of all integrators, by response and detection.
{
    key = cell("response") SUBSEP cell("detection")
    if (!(key in runs)) order[++count] = key
    ++runs[key]
    trees[key] += cell("trees")
    if (cell("penetration_m") > penetration[key] + 0) penetration[key] = cell("penetration_m")
    if (cell("energy_gain_m") > energy[key] + 0) energy[key] = cell("energy_gain_m")
    if (cell("speed_m_per_s") > speed[key] + 0) speed[key] = cell("speed_m_per_s")
    flawed[key] += cell("flaw") != "none"
}
END {
    print "| Response | Detection | Integrators | Trees, all with the bits of brute force | Deepest penetration [mm] | Largest gain of energy [mm] | Fastest at the end [m/s] | Out of bounds |"
    print "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |"
    for (i = 1; i <= count; ++i) {
        split(order[i], part, SUBSEP)
        k = order[i]
        printf "| `%s` | %s | %d | %d | %.2f | %.2f | %.2f | %d |\n", part[1], part[2], runs[k], trees[k],
               1e3 * penetration[k], 1e3 * energy[k], speed[k], flawed[k]
    }
}
