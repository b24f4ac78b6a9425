#include "bits/matrix.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <sstream>

#include "drape/bounds/broad_phase.h"
#include "drape/integrate/integrator.h"
#include "drape/scene/scene.h"

namespace drape::test {

const std::string small_case =
    "drop --time 0.05 --set cloth.particles=12,12 ball.position=0,0.345,0 solver.dt=0.002 wind.on=1 ";

std::string bits_of(const LabFolder& folder, const Way& way, const std::string& program, const Words& arguments) {
    Words words = way.before;
    words.push_back(program);
    words.insert(words.end(), arguments.begin(), arguments.end());
    const LabRun run = folder.run({words.begin() + 1, words.end()}, words.front(), way.environment);
    const bool told = run.out.size() == 17 && (run.code == 0 || run.code == 1);
    return told ? run.out.substr(0, 16) + ", exit code " + std::to_string(run.code) : "no hash: " + run.err;
}

namespace {

Words words_of(const std::string& command_line) {
    std::istringstream in(command_line);
    return {std::istream_iterator<std::string>(in), {}};
}

/// A figure of the report of a run's last step.
/// @param file what the run wrote by `--stats`
double last_statistic(const LabFolder& folder, const std::string& file, const std::string& name) {
    const std::vector<std::string> lines = lines_of(folder.read(file));
    if (lines.size() < 3) return 0;
    std::istringstream names(lines[1]);
    std::string column;
    for (const double value : values_of(lines.back())) {
        if (std::getline(names, column, ',') && column == name) return value;
    }
    return 0;
}

}  // namespace

void Matrix::add(const std::string& command_line) {
    const Words& words = cells_.emplace_back(words_of("simulate --hash " + command_line));
    plain_.push_back(bits_of(folder_, {"plainly"}, DRAPE_LAB, words));
    EXPECT_FALSE(plain_.back().starts_with("no hash")) << command_line << ": " << plain_.back();
}

void Matrix::add_methods() { add_methods({names_of<IntegratorKind>().begin(), names_of<IntegratorKind>().end()}); }

void Matrix::add_methods(const Words& methods) {
    for (const std::string& method : methods) add(small_case + "integrator=" + method);
    add("hang --time 0.05 --set cloth.particles=24,24 structural.stiffness=3200 solver.dt=0.016667 "
        "integrator=backward_euler");  // multigrid
}

void Matrix::add_threaded() {
    const std::string large =
        "drop --time 0.01 --set cloth.particles=184,184 ball.position=0,0.345,0 solver.dt=5e-4 "
        "contact.self=false ";
    for (const char* method : {"explicit_euler", "symplectic_euler", "velocity_verlet", "rk4"}) {
        add(large + "wind.on=1 integrator=" + method);
    }
    // Threads share the search for pairs too: a sheet that has begun to fold
    add("fold --time 0.6 --stats fold.csv --set cloth.particles=64,64 integrator=xpbd solver.iterations=2 "
        "solver.dt=1.6666e-2 contact.longest_step=1e-3");
    EXPECT_GT(last_statistic(folder_, "fold.csv", "listed_pairs"), 4 * 1024) << "enough for four threads";
}

void Matrix::add_volumes() {
    for (const std::string& volume : names_of<VolumeKind>()) add(small_case + "search_level=2 volume=" + volume);
}

void Matrix::add_scenes(const Words& methods) {
    for (const std::string& scene : scene_names()) {
        // Its methods are in the cases above, and an emulator needs minutes for it
        if (load_scene(scene).cloths[0].particles.particles() > 10'000) continue;
        for (const std::string& method : methods) {
            const std::string given = method.empty() ? "" : " integrator=" + method;
            add(scene + " --time 0.02 --set on_unstable=substep" + given);
        }
    }
}

int Matrix::compare(const Way& way, const Words& more) const {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        Words words = cells_[i];
        words.insert(words.end(), more.begin(), more.end());
        std::string told = "drape-lab";
        for (const std::string& word : words) told += " " + word;
        EXPECT_EQ(bits_of(folder_, way, way.lab, words), plain_[i]) << way.name << ": " << told;
    }
    return static_cast<int>(cells_.size());
}

void tell_comparisons(int count) {
    std::cout << count << " comparisons of bits\n";
    testing::Test::RecordProperty("comparisons", count);
}

std::string no_emulator() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return "sanitizers do not run under qemu";
#else
    return can_run("qemu-x86_64") ? "" : "qemu-x86_64 is not here (package qemu-user)";
#endif
}

bool can_run(const std::string& program) { return std::system(("command -v " + program + " >/dev/null").c_str()) == 0; }

}  // namespace drape::test
