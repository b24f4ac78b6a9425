#include "fallback.h"

#include <filesystem>
#include <iostream>
#include <vector>

#include "drape/base/child_program.h"
#include "drape/base/resources.h"

namespace drape {

namespace {

constexpr int frames = 120;
constexpr const char* folder = "drape-frames";

}  // namespace

void capture_instead(const Options& options, const std::string& reason) {
    const std::string program = (program_folder() / "drape-capture").string();
    const std::string out = std::filesystem::absolute(folder).string();
    const std::string size = std::to_string(options.size.width) + "x" + std::to_string(options.size.height);
    std::vector<std::string> words{program};
    if (!options.start.scene.empty()) {
        words.push_back(options.start.scene);
    } else if (options.start.replay.empty()) {
        words.insert(words.end(), {"drop", "--set", "view.eye=0.85,0.7,1.25"});  // the README's picture
    }
    for (const std::string& assignment : options.start.assignments) words.insert(words.end(), {"--set", assignment});
    if (!options.start.replay.empty()) words.insert(words.end(), {"--replay", options.start.replay});
    if (options.hash) words.emplace_back("--hash");
    words.insert(words.end(), {"--frames", std::to_string(frames), "--size", size, "--out", out, "--again"});

    std::cerr << "drape: " << reason << "; drawing " << frames << " pictures into " << out << " instead"
              << (std::filesystem::exists(out) ? ", in place of those that are there" : "")
              << (options.record.empty() ? "" : " (nothing is recorded)") << std::endl;
    become_program(std::move(words));
}

}  // namespace drape
