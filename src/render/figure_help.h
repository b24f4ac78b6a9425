#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace drape {

/// What a row of the stats panel means, in a sentence.
/// @param name of the row
/// @return empty where its name says all
inline std::string_view figure_help(std::string_view name) {
    static constexpr auto helps = std::to_array<std::pair<std::string_view, std::string_view>>({
        {"state", "What the run does now. Asleep: nothing moves, and nothing is computed until something changes"},
        {"FPS", "Pictures in a second. Coarse: on a slow display, what moves is drawn at half the size"},
        {"speed", "Simulated seconds in a second"},
        {"contacts", "Points where cloth touches a ball, a solid or the ground. Pairs: where cloth touches cloth"},
        {"tests saved",
         "The part of all tests, for balls and for cloth near cloth, that the tree of bounding volumes saves, and how "
         "much faster the search is with it, as measured in the last seconds. B shows the volumes"},
        {"tests, in all", "Tests of one search with the tree, and by brute force"},
        {"search, in all", "Time of one search with the tree"},
        {"by brute force", "Time of the same search without it"},
        {"integrator", "The method that makes a step from forces, positions and velocities. I takes the next"},
        {"time step", "Simulated time of one step. 3 x: a step is made in three parts, to stay below its limit"},
        {"dt / limit", "The time step over the longest stable one. Above 1 errors grow with each step"},
        {"limit", "The longest step that is stable for this method, stiffness and mesh"},
        {"unsolved", "Steps in which a solver has not come to its tolerance"},
        {"residual", "The largest error that a solver has left, relative to what it began with"},
        {"excess", "Energy that the integrator has made from nothing"},
        {"integrate", "Time for forces and the integrator's step"},
        {"build", "Time to fit the tree of bounding volumes to the cloth"},
        {"traverse", "Time to search the tree for cells near the balls"},
        {"narrow phase", "Time to test the triangles of the cells that were found"},
        {"response", "Time to resolve contacts"},
        {"volume", "What the nodes of the tree are. T takes the next"},
        {"update", "How the tree follows the cloth from step to step. U takes the next"},
        {"volume tests", "Nodes that were tested against the balls, of all nodes"},
        {"candidates", "Cells that the search hands to the narrow phase, of all cells for each ball"},
        {"false positives", "Candidates of which no triangle touches: the looser the volumes, the more"},
        {"penetration", "How deep cloth is still inside a ball, a solid or the ground after the response"},
        {"stopped at", "Nodes at which the limited search has ended"},
        {"false nodes", "Of these, nodes of which no triangle touches"},
        {"missed", "How deep cloth is inside a ball that the limited search has missed"},
        {"cloth on cloth", "Time to find where cloth touches cloth"},
        {"listed pairs", "Vertices and triangles, or two edges, that are near enough to be looked at"},
        {"pairs", "Of these, pairs that touch"},
        {"fail-safe", "Particles that were stopped so that cloth does not pass through cloth"},
        {"stretch", "The largest elongation of a structural spring"},
        {"kinetic", "Energy of motion"},
        {"gravity", "Energy of height"},
        {"spring", "Energy of stretched and bent cloth"},
        {"total", "Kinetic energy, gravity and spring energy together"},
        {"to damping", "Energy that the springs' dampers have taken since the start"},
        {"to drag", "Energy that the drag of the air has taken"},
        {"to contact", "Energy that contact has taken. At rest it gives back what each step of the integrator loses"},
        {"integrator loss", "Energy that the integrator's own errors take away"},
        {"from wind", "Work that the wind has done on the cloth"},
        {"from hand", "Work that the hand has done on the cloth"},
        {"from pins", "Work of pins that move"},
        {"from ball", "Work of balls that the keys or a path move"},
        {"to fail-safe", "Energy lost as the fail-safe stopped particles"},
        {"CPU", "Processor time of the program in a second; above 100 % with several threads"},
        {"vertices", "Corners that were drawn in the last picture"},
    });
    const auto* found = std::ranges::find(helps, name, &std::pair<std::string_view, std::string_view>::first);
    return found == helps.end() ? std::string_view() : found->second;
}

}  // namespace drape
