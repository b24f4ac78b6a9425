#include "drape/scene/scene.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "drape/scene/setting_table.h"
#include "support/input_errors.h"
#include "support/scratch_file.h"

namespace drape {
namespace {

using test::input_error_of;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::string error_of(const std::string& text) {
    return input_error_of([&] { parse_scene(text, "mine.toml"); });
}

/// Every key of a scene file, with values that are no defaults.
constexpr const char* full_scene = R"(title = "Two corners, free fall"
start = "state.csv"
[[cloth]]
particles = [16, 12]
size = [1.5, 2.5]
mass = 0.25
plane = "xy"
origin = [0.5, 1.0, -0.5]
pinned = "two"
structural = { stiffness = 1001.0, damping = 0.021 }
shear      = { stiffness =  501.0, damping = 0.022 }
bend       = { stiffness =  101.0, damping = 0.023 }
drag = 2e-4
stretch_limit = 0.15
[[cloth]]
pinned = "row"
[[ball]]
radius = 0.31
position = [0.5, -0.6, 0.25]
velocity = [0.125, 0.0, 0.0]
motion = "still"
speed = 2
mass = 2
path = [[0, 1, 2, 3], [1.5, 4, 5, 6]]
[[solid]]
shape = "mesh"
position = [1, 2, 3]
axis = [1, 0, 0]
angle = 30
size = [0.1, 0.2, 0.3]
radius = 0.2
length = 0.4
file = "mesh.obj"
motion = "path"
path = [[0, 1, 2, 3], [1.5, 4, 5, 6]]
[[pins]]
cloth = 1
particles = [1, 2]
shift = [[0, 0, 0, 0], [1.5, 4, 5, 6]]
turns = [[0, 0, 0, 0], [1.5, 0.25, 0, 0]]
[solver]
integrator = "rk4"
hessian = "exact"
iterations = 5
newton_steps = 2
tolerance = 1e-7
ledger = true
dt = 3e-4
on_unstable = "stop"
kernels = "plain"
threads = 3
sleep_speed = 0.5
[contact]
volume = "brute"
update = "merge"
sphere_fit = "epos14"
leaf_cells = 5
search_level = 3
search_tests = 100
response = "hybrid"
stiffness = 500.0
longest_step = 1e-3
friction = 0.25
restitution = 0.125
rolling = 0.03
thickness = 0.003
continuous = true
self = true
[ground]
height = 0.5
solid = false
friction = 0.4
restitution = 0.1
rolling = 0.02
[world]
gravity = 1.6

[wind]
on = true
velocity = [1, 2, 3]
gust = 0.25
[view]
panel = "off"
controls = true
colour = "speed"
weave = false
smooth = false
grid = false
quality = "fast"
fabric = "silk"
palette = "dusk"
text_scale = 1.5
plots = true
repeat = 0.25
speed = 0.5
help = true
bounds = true
level = 2
wireframe = true
particles = true
contacts = true
eye = [3, 2, 1]
target = [1, 1, 1]
[needs]
position_error = 0.01
measure = "centre_and_spread"
horizon = 0.75
penetration = 0.001
stretch = 0.1
min_stretch = 0.01
diverges = true
keep = "particles, dt"
full.particles = [40, 40]
full.bend = { stiffness = 3.0, damping = 0.03 }
full.drag = 0.01
)";

TEST(SceneFile, SetsEveryRowOfTheTable) {
    const Settings defaults = settings_with_one_of_each();
    const Settings settings = parse_scene(full_scene, "full.toml");
    for (const Setting& setting : setting_table()) {
        EXPECT_NE(setting.read(settings, 0), setting.read(defaults, 0)) << setting.full_name() << " was not read";
    }
    EXPECT_EQ(settings.cloths.size(), 2u);
    const ClothParameters& cloth = settings.cloths[0];
    EXPECT_EQ(cloth.particles, (Grid{16, 12}));
    EXPECT_EQ(cloth.width, 1.5);
    EXPECT_EQ(cloth.height, 2.5);
    EXPECT_EQ(cloth.origin(), Vec3(0.5, 1, -0.5));
    EXPECT_EQ(cloth.structural, (SpringLaw{1001, 0.021}));
    EXPECT_EQ(cloth.shear, (SpringLaw{501, 0.022}));
    EXPECT_EQ(cloth.bend, (SpringLaw{101, 0.023}));
    EXPECT_EQ(settings.balls.at(0).path[1], (PathPoint{1.5, Vec3(4, 5, 6)}));
    EXPECT_EQ(settings.solver.dt, 3e-4);
}

TEST(SceneFile, NeedsNothingButACloth) {
    const Settings settings = parse_scene("[cloth]\n", "mine.toml");
    EXPECT_EQ(settings.cloths, Settings{}.cloths);
    EXPECT_TRUE(settings.balls.empty());
    EXPECT_THAT(error_of(""), AllOf(HasSubstr("mine.toml"), HasSubstr("[cloth] is missing")));
    EXPECT_THAT(error_of("title = \"no cloth\"\n[[ball]]\n"), HasSubstr("[cloth] is missing"));
}

TEST(SceneFile, PlacesAClothByItsCentreToo) {
    for (const auto& [plane, origin] : {std::pair("'xz'", Vec3(0, 2, 1)), {"'xy'", Vec3(0, 4, 3)}}) {
        const std::string text = "[cloth]\ncentre = [1, 2, 3]\nsize = [2.0, 4.0]\nplane = ";
        EXPECT_EQ(parse_scene(text + plane, "mine.toml").cloths[0].origin(), origin);
    }
    EXPECT_THAT(error_of("[cloth]\norigin = [0, 0, 0]\ncentre = [0, 0, 0]\n"),
                AllOf(StartsWith("mine.toml:3:"), HasSubstr("cloth.centre"), HasSubstr("cloth.origin")));
}

TEST(SceneFile, TakesPinsByNameAndByNumber) {
    const Settings settings = parse_scene("[cloth]\npinned = [0, 5, 899]\n", "mine.toml");
    EXPECT_THAT(settings.cloths[0].pinned.list, ElementsAre(0, 5, 899));
    EXPECT_THAT(error_of("[cloth]\nmass = 1\npinned = [0, 900]\n"),
                AllOf(StartsWith("mine.toml:3:"), HasSubstr("cloth.pinned = 900"), HasSubstr("<= 899")));
    EXPECT_THAT(error_of("[cloth]\npinned = [0, -1]\n"), StartsWith("mine.toml:2:"));
    EXPECT_THAT(error_of("[cloth]\npinned = [0.5]\n"), StartsWith("mine.toml:2:"));
    EXPECT_THAT(error_of("[cloth]\npinned = \"too\"\n"), AllOf(StartsWith("mine.toml:2:"), HasSubstr("'two'")));
}

TEST(SceneFile, ErrorsSayWhereAndWhatIsAllowed) {
    EXPECT_THAT(error_of("[cloth]\n[solver]\n  dt = 5\n"),
                StartsWith("mine.toml:3:8: solver.dt = 5: allowed 1e-09 <= dt <= 0.1"));
    EXPECT_THAT(error_of("[cloth]\nparticles = [1, 8]\n"), AllOf(StartsWith("mine.toml:2:13:"), HasSubstr("2 <= x")));
    EXPECT_THAT(error_of("[cloth]\n[[ball]]\n[[ball]]\nradius = 0\n"),
                AllOf(StartsWith("mine.toml:4:"), HasSubstr("1e-06")));
    // Of what does not fit together too
    EXPECT_THAT(error_of("[cloth]\n[[ball]]\nmotion = \"path\"\n"), StartsWith("mine.toml:3:"));
    EXPECT_THAT(error_of("[cloth]\n[[ball]]\n[[ball]]\npath = [[1, 0, 0, 0], [0, 0, 0, 0]]\n"),
                AllOf(StartsWith("mine.toml:4:"), HasSubstr("ascend")));
    EXPECT_THAT(error_of("[[cloth]]\n[[cloth]]\nparticles = [4000, 4000]\n"), StartsWith("mine.toml:3:"));
}

TEST(SceneFile, UnknownKeysNameTheNearestKnownOne) {
    EXPECT_THAT(error_of("[cloth]\nparticels = [4, 4]\n"),
                AllOf(StartsWith("mine.toml:2:"), HasSubstr("'cloth.particels'"), HasSubstr("'cloth.particles'")));
    EXPECT_THAT(error_of("[cloth]\nshear = { stifness = 1 }\n"),
                AllOf(StartsWith("mine.toml:2:"), HasSubstr("'cloth.shear.stiffness'")));
    EXPECT_THAT(error_of("[cloth]\n[slover]\ndt = 1e-4\n"), AllOf(StartsWith("mine.toml:2:"), HasSubstr("'solver'")));
    EXPECT_THAT(error_of("titel = 5\n[cloth]\n"), AllOf(StartsWith("mine.toml:1:"), HasSubstr("'title'")));
    EXPECT_THAT(error_of("[cloth]\na.b.c = 5\n"), StartsWith("mine.toml:2:"));
    EXPECT_THAT(error_of("[cloth]\n[x.y.z]\n"), StartsWith("mine.toml:2:"));
}

TEST(SceneFile, WrongTypesAreNotTakenForDefaults) {
    for (const char* line :
         {"mass = \"0.2\"", "mass = true", "mass = [0.2]", "mass = { a = 1 }", "mass = 1979-05-27", "mass = nan",
          "particles = 16", "particles = [16]", "particles = [16.5, 16]", "particles = [\"16\", 16]",
          "particles = [[16, 16]]", "plane = 1", "plane = \"yz\"", "pinned = 4", "structural = 1000",
          "structural = { stiffness = \"1\" }", "origin = [0, 0]", "origin = [0, inf, 0]", "origin = \"0,0,0\""}) {
        EXPECT_THAT(error_of(std::string("[cloth]\n") + line + "\n"), StartsWith("mine.toml:2:")) << line;
    }
    for (const char* text :
         {"title = 5\n[cloth]\n", "cloth = 5\n", "cloth = [5]\n", "cloth = []\n", "cloth = [[]]\n",
          "solver = 5\n[cloth]\n", "[[solver]]\n[cloth]\n", "[cloth]\n[wind]\non = 1\n",
          "[cloth]\n[[ball]]\npath = [0, 1, 2, 3]\n", "[cloth]\n[[ball]]\npath = [[0, 1, nan, 2]]\n"}) {
        EXPECT_THAT(error_of(text), StartsWith("mine.toml:")) << text;
    }
}

TEST(SceneFile, IsFoundByPath) {
    const test::ScratchFolder folder;
    const auto path = folder.path() / "mine.toml";
    std::ofstream(path) << "[cloth]\nmass = 0.375\n";
    EXPECT_EQ(load_scene(path.string()).cloths[0].mass, 0.375);
    std::ofstream(path) << "[cloth]\nmass = 0\n";
    EXPECT_THAT(input_error_of([&] { load_scene(path.string()); }), StartsWith(path.string() + ":2:8: cloth.mass = 0"));
    std::filesystem::remove(path);
    EXPECT_THAT(input_error_of([&] { load_scene(path.string()); }), HasSubstr("cannot be read"));
    EXPECT_THAT(input_error_of([&] { load_scene(testing::TempDir()); }), HasSubstr("folder"));
}

std::string repeated(const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

/// What is said of a text that is read as a scene: nothing if it is one. Anything that is thrown but InputError fails
/// the test.
std::string refusal_of(const std::string& text) {
    const std::string message = test::input_error_of([&] { parse_scene(text, "bad.toml"); });
    EXPECT_TRUE(message.empty() || message.starts_with("bad.toml")) << message;
    EXPECT_LT(message.size(), 1000u);
    return message;
}

TEST(BadToml, IsRefusedWhateverItIs) {
    const std::vector<std::string> corpus{
        "[$a",
        "a = [",
        "a = \"\\u{110000}\"",
        "a = 2020-13-99",
        "[cloth]\n[cloth]\n",
        "[cloth]\nmass = 1\nmass = 2\n",
        "cloth.mass = 1\n[cloth]\nmass = 2\n",
        "\xef\xbb\xbf",
        "\xff\xfe\x00\x01",
        std::string(1, '\0'),
        "[cloth]\r",
        "\u00e9 = 1\n",
        "[cloth]\nmass = 1 \u00e9\n",
        "\"\" = 5\n",
        repeated("a.", 19'999) + "a = 1\n",
        "[" + repeated("a.", 19'999) + "a]\n",
        "[cloth]\na = " + repeated("[", 2'000) + "\n",
        "[cloth]\na = " + repeated("{a=", 1'000) + "\n",
        "[cloth]\na = " + repeated("[\n", 100'000) + "\n",
        repeated("[[a.b.c]]\n", 20'000),
        "[cloth]\n" + repeated("# comment\n", 30'000),
        "# " + std::string(5'000, 'x') + "\n[cloth]\n",
        "[cloth]\n" + std::string(300'000, '\n'),
    };
    for (const std::string& text : corpus) EXPECT_NE(refusal_of(text), "") << text.substr(0, 60);
}

TEST(BadToml, OfSizesThatTheParserIsNotMadeForNamesTheLimit) {
    EXPECT_EQ(refusal_of("[cloth]\n#" + std::string(4096, 'x') + "\n"),
              "bad.toml:2:1: a line of 4097 bytes: allowed at most 4096");
    EXPECT_EQ(refusal_of("[cloth]\n#" + std::string(4095, 'x') + "\n"), "");
    EXPECT_EQ(refusal_of("[cloth]\n" + repeated("# fifteen bytes\n", 16'384)),
              "bad.toml: 262152 bytes: allowed at most 262144");
}

TEST(ShippedScenes, AllLoadAndHaveATitle) {
    const std::vector<std::string> names = scene_names();
    EXPECT_THAT(names, testing::IsSupersetOf({"original", "drop", "curtain", "hang", "slide", "three_balls",
                                              "trampoline", "two_corners"}));
    EXPECT_EQ(names.front(), "veil");
    EXPECT_THAT(names.back(), StartsWith("fails_"));
    for (const std::string& name : names) {
        const Settings settings = load_scene(name);
        EXPECT_NE(settings.title, Settings{}.title) << name;
        EXPECT_EQ(settings.contact.self, !name.starts_with("fails_")) << name;
    }
}

TEST(ShippedScenes, AreNamedWhereOneIsNotFound) {
    EXPECT_THAT(input_error_of([] { load_scene("curtian"); }),
                AllOf(HasSubstr("'curtian'"), HasSubstr("'drop'"), HasSubstr("did you mean 'curtain'?")));
    EXPECT_THROW(load_scene(""), InputError);
    EXPECT_THROW(load_scene("../scenes/drop"), InputError);
}

}  // namespace
}  // namespace drape
