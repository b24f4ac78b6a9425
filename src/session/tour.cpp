#include "drape/session/tour.h"

#include <array>
#include <sstream>

#include "drape/base/numbers.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "drape/session/comparison.h"

namespace drape {
namespace {

constexpr std::array<TourStop, 12> stops{{
    {"What a spring does", "hang", "cloth.particles=12,12,view.particles=true",
     "Particles, joined by springs: each pulls by its stiffness times its elongation, and damps.",
     "Drag a corner, and watch the springs pass the pull on.", "include/drape/model/forces.h", 0.4},
    {"Structural springs are not enough", "hang", "cloth.shear.stiffness=0,view.particles=true",
     "Without shear springs the cells shear freely, and the sheet sags like a net.",
     "M, Cloth: raise shear stiffness, and it is cloth again.", "include/drape/model/stencils.h", 1.5},
    {"The step limit", "fails_symplectic_euler", "",
     "The time step is 2 % above the limit of the stiffest mode, which grows by a factor in every step.",
     "When it has diverged, watch the mode swing; Shift+R resets with a stable step.", "src/integrate/stability.cpp",
     0.006},
    {"What a tree prunes", "veil", "contact.leaf_cells=2,view.bounds=true,view.level=4",
     "One test prunes everything inside a sphere that the ball does not touch.",
     "[ and ] change the level; move the ball away, and nearly all of the tree is pruned.",
     "include/drape/bounds/cloth_quadtree.h", 0.4},
    {"Spheres against boxes", "drop", "contact.volume=aabb,contact.leaf_cells=2,view.bounds=true,view.level=4",
     "Boxes along the axes fit flat cloth closely; where cloth is tilted, they waste their corners.",
     "T goes through the bounding volumes; Tab shows node tests and times.", "include/drape/bounds/aabb.h", 0.4},
    {"Rebuild against refit", "curtain", "contact.update=refit,view.bounds=true,view.panel=full",
     "Refit updates parents from their children, and only where cloth has moved.",
     "U goes through the policies: compare the times of build and traverse.", "include/drape/bounds/cloth_quadtree.h",
     1.2},
    {"Tunnelling", "bullet",
     "contact.self=false,contact.continuous=false,solver.dt=5e-3,solver.integrator=backward_euler,ball.velocity=0,1,60,"
     "view.speed=0.5,view.repeat=0.06",
     "The ball is tested at the ends of each step only: at 60 m/s it is through the cloth in between.",
     "M, Contact: set continuous to auto, then R.", "src/contact/detect/cloth_contacts.cpp", 0.05},
    {"Friction", "slide", "", "With a friction coefficient of 0.05 the cloth slides off the ball and down the incline.",
     "M, Contact: set friction to 0.5, then R: it stays.", "src/contact/solve/sweeps.cpp", 0.9},
    {"Resting contact", "trampoline", "view.contacts=true,view.panel=full",
     "The ball comes to rest: contacts push by just its weight, and then the scene falls asleep.",
     "X throws the ball again, and Z lets it fall.", "src/contact/solve/projection.cpp", 2.5},
    {"Self contact", "fold", "view.speed=0.25",
     "Cloth lands on itself and stays apart by its thickness; a second pair of trees finds where.",
     "M, Contact: switch self off, then R: the folds cross.", "src/sim/self_search.cpp", 0.7},
    {"Speed against accuracy", "hang", "solver.integrator=backward_euler,solver.dt=0.016667,view.panel=full",
     "Backward Euler takes 1/60 s in one step: stable, but the swing dies too soon.",
     "Press I for the implicit midpoint, which keeps the swing; compare their times.", "docs/speed-and-accuracy.md",
     0.8},
    {"No more than needed", "drop", "cloth.particles=15,15,view.particles=true",
     "A quarter of the particles: is the drape still the same where you look?",
     "M, Cloth: change particles, and see what it costs in the panel (Tab).", "src/lab/needs/needs.h", 1.5},
}};

constexpr std::string_view introduction = R"(# Tour

Twelve scenes, with what to see in each, what to try, and which file explains it. In the window, F1 begins the tour, as
does `build/release/bin/drape --tour`, and everything can be touched on the way. Under each picture is the command that
shows its scene, and the time at which the picture was taken.

Made by `build/release/bin/drape-lab list tour > docs/tour.md`, and the pictures by

```
build/release/bin/drape-capture --tour --size 840x473 --out docs/tour --again
```
)";

std::string picture_name(std::size_t number) {
    const std::string digits = std::to_string(number);
    return "tour/frame_" + std::string(4 - digits.size(), '0') + digits + ".png";
}

}  // namespace

std::span<const TourStop> tour_stops() { return stops; }

Settings settings_of(const TourStop& stop) {
    Settings settings = load_scene(std::string(stop.scene));
    for (const std::string& change : split_assignments(stop.changes)) assign(settings, change);
    return settings;
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
        page << "`, at " << real_text(stop.time) << " s\n\n";
        page << "See: " << stop.look << "\n\nTry: " << stop.try_it << "\n\n";
        page << "Read: [" << stop.file << "](../" << stop.file << ")\n";
    }
    return page.str();
}

}  // namespace drape
