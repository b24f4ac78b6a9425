#include "drape/session/tour.h"

#include <array>
#include <sstream>

#include "drape/base/numbers.h"
#include "drape/session/comparison.h"

namespace drape {
namespace {

constexpr std::array<TourStop, 13> stops{{
    {"What a spring does", "hang", "cloth.particles=12,12,view.particles=true", "",
     "Particles, joined by springs: each pulls by its stiffness times its elongation, and damps.",
     "Drag a corner, and watch the springs pass the pull on.", "include/drape/model/forces.h", 0.4},
    {"Structural springs are not enough", "hang", "cloth.shear.stiffness=0,view.target=0.35,0.7,0.1",
     "cloth.shear.stiffness=200",
     "Without shear springs (surface) the cells shear freely, and the sheet sags like a net; lines: with them.",
     "M, Cloth: raise shear stiffness, and it is cloth again.", "include/drape/model/stencils.h", 1.5},
    {"The step limit", "fails_symplectic_euler",
     "view.panel=full,view.particles=true,view.eye=0.83,2.3,1.8,view.target=0.33,0,0.69", "",
     "The time step is 2 % above the limit: in the stiffest mode, cells widen and narrow in turn, more in every step.",
     "When it has diverged, watch the mode swing; Shift+R resets with a stable step.", "src/integrate/stability.cpp",
     0.0062},
    {"What a tree prunes", "veil",
     "contact.leaf_cells=2,view.bounds=true,view.level=4,view.eye=1,0.85,1.3,view.target=0.12,0.27,0.1", "",
     "One test prunes everything inside a sphere that the ball does not touch.",
     "[ and ] change the level; move the ball away, and nearly all of the tree is pruned.",
     "include/drape/bounds/cloth_quadtree.h", 0.4},
    {"Spheres against boxes", "drop",
     "contact.volume=aabb,contact.leaf_cells=2,view.bounds=true,view.level=4,view.eye=1.2,0.7,1.6,"
     "view.target=0.25,0.15,0.05",
     "", "Boxes along the axes fit flat cloth closely; where cloth is tilted, they waste their corners.",
     "T goes through the bounding volumes; Tab shows volume tests and times.", "include/drape/bounds/aabb.h", 0.4},
    {"Rebuild against refit", "curtain",
     "contact.update=refit,contact.leaf_cells=4,"
     "ball.path=0,0,0.6,0.25,1,0.3,0.6,-0.15,2,0,0.6,-0.3,3,-0.3,0.6,-0.15,4,0,0.6,0.25,"
     "view.bounds=true,view.colour=plain,view.target=0.38,0.68,0",
     "contact.update=rebuild",
     "Both find the same contacts. Refit (surface) builds less, but has looser spheres to test than rebuild (lines).",
     "U goes through the policies: compare BVH time and volume tests.", "include/drape/bounds/cloth_quadtree.h", 1.4},
    {"Tunnelling", "bullet",
     "contact.self=false,contact.continuous=false,solver.dt=5e-3,solver.integrator=backward_euler,ball.velocity=0,1,60,"
     "view.speed=0.2,view.repeat=0.1,view.eye=2.4,0.95,0.4",
     "contact.continuous=true",
     "The ball is tested at the ends of each step only, and is through the cloth in between; lines: tested on its way.",
     "M, Contact: set continuous to auto, then R.", "src/contact/detect/cloth_contacts.cpp", 0.042},
    {"Friction", "slide", "", "",
     "With a friction coefficient of 0.05 the cloth slides off the ball and down the incline.",
     "M, Contact: set friction to 0.5, then R: it stays.", "src/contact/solve/sweeps.cpp", 0.9},
    {"Resting contact", "trampoline",
     "view.contacts=true,view.panel=full,view.eye=1.15,0.62,1.35,view.target=-0.1,0.47,0", "",
     "The ball comes to rest: contacts push by just its weight, and then the scene falls asleep.",
     "X throws the ball again, and Z lets it fall.", "src/contact/solve/projection.cpp", 10},
    {"Self contact", "fold", "view.speed=0.25", "",
     "Cloth lands on itself and stays apart by its thickness; a second pair of trees finds where.",
     "M, Contact: switch self off, then R: the folds cross.", "src/sim/self_search.cpp", 0.7},
    {"Speed against accuracy", "hang",
     "contact.self=false,solver.integrator=backward_euler,solver.dt=0.016667,view.target=0.35,0.7,0.1",
     "solver.integrator=symplectic_euler,solver.dt=4e-4",
     "Backward Euler takes 1/60 s in one step: stable, but the swing dies too soon. Lines: 42 short explicit steps.",
     "Menu, Time step: 2 ms keeps more of the swing.", "docs/speed-and-accuracy.md", 1.8},
    {"No more than needed", "drop", "cloth.particles=15,15,view.eye=1.2,0.7,1.6,view.target=0.2,0.2,0",
     "cloth.particles=30,30",
     "A quarter of the particles (surface) takes less time, but is it the drape of all of them (lines)?",
     "M, Cloth: change particles, and see where they part.", "src/lab/needs/needs.h", 1.5},
    {"Now do this", "original", "", "", "Three things to do, with nothing prepared.",
     "Hold E: the ball lifts the cloth. Drag the cloth, and let go. G removes all pins.", "docs/tour/session.txt", 1},
}};

constexpr std::string_view introduction = R"(# Tour

Each stop is a scene, with what to see in it, what to try, and which file explains it. In the window, F1 begins
the tour, as does `build/release/bin/drape --tour`, and everything can be touched on the way. Under each picture is the
command that shows its scene, and the time at which the picture was taken. Where a stop compares, the scene is the
surface, and the lines are what it is compared with.

Made by `build/release/bin/drape-lab list tour > docs/tour.md`, and the pictures by

```
build/release/bin/drape-capture --tour --size 840x473 --out docs/tour --again
```

The session of the last stop, [session.txt](tour/session.txt), was recorded in the window, and its hashes were left out:
versions whose motion has other bits replay it too.

```
build/release/bin/drape original --record session.raw
grep -v ' hash ' session.raw > docs/tour/session.txt
build/release/bin/drape --replay docs/tour/session.txt
```
)";

std::string picture_name(std::size_t number) {
    const std::string digits = std::to_string(number);
    return "tour/frame_" + std::string(4 - digits.size(), '0') + digits + ".png";
}

}  // namespace

std::span<const TourStop> tour_stops() { return stops; }

std::vector<Command> commands_of(const TourStop& stop) {
    std::vector<Command> commands{command::Compare{"none"}, command::LoadScene{std::string(stop.scene)}};
    if (!stop.versus.empty()) commands.emplace_back(command::Compare{std::string(stop.versus)});
    for (const std::string& change : split_assignments(stop.changes)) commands.emplace_back(command::Set{change});
    return commands;
}

std::string tour_page() {
    std::ostringstream page;
    page << introduction;
    std::size_t number = 0;
    for (const TourStop& stop : tour_stops()) {
        page << "\n## " << ++number << " " << stop.title << "\n\n";
        page << "![" << stop.title << "](" << picture_name(number) << ")\n\n";
        page << "`build/release/bin/drape " << stop.scene;
        for (const std::string& change : split_assignments(stop.changes)) page << " --set " << change;
        if (!stop.versus.empty()) page << " --versus " << stop.versus;
        page << "`, at " << real_text(stop.time) << " s\n\n";
        page << "See: " << stop.look << "\n\nTry: " << stop.try_it << "\n\n";
        page << "Read: [" << stop.file << "](../" << stop.file << ")\n";
    }
    return page.str();
}

}  // namespace drape
