// The colour of a node by what the last query did with it.
vec4 node_colour(int node_state) {
    vec4 unvisited = vec4(0.45, 0.48, 0.52, 0.20);
    vec4 pruned = vec4(0.33, 0.37, 0.44, 0.40);
    vec4 visited = vec4(0.00, 0.36, 0.75, 0.60);
    vec4 leaf = vec4(0.00, 0.50, 0.34, 0.65);
    vec4 touching = vec4(1.00, 0.76, 0.05, 0.85);
    return node_state == 4 ? touching : node_state == 3 ? leaf : node_state == 2 ? visited
         : node_state == 1 ? pruned : unvisited;
}
