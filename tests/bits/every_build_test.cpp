#include <gtest/gtest.h>

#include <filesystem>

#include "bits/matrix.h"

namespace drape::test {
namespace {

/// A build of the same sources.
struct Build {
    std::string name, compiler;
    Words options;  ///< of CMake
};

void PrintTo(const Build& build, std::ostream* out) { *out << build.name; }

const std::string sanitizers = "-fsanitize=address,undefined -fno-sanitize-recover=undefined";

const std::vector<Build> builds{
    {"gcc_O0", "g++", {"-DCMAKE_BUILD_TYPE=Debug"}},
    {"gcc_O2", "g++", {"-DCMAKE_BUILD_TYPE=RelWithDebInfo"}},
    {"gcc_O3", "g++", {"-DCMAKE_BUILD_TYPE=Release"}},
    {"gcc_sanitizers", "g++", {"-DCMAKE_BUILD_TYPE=RelWithDebInfo", "-DCMAKE_CXX_FLAGS=" + sanitizers}},
    {"clang_O0", "clang++", {"-DCMAKE_BUILD_TYPE=Debug"}},
    {"clang_O2", "clang++", {"-DCMAKE_BUILD_TYPE=RelWithDebInfo"}},
    {"clang_O3", "clang++", {"-DCMAKE_BUILD_TYPE=Release"}}};

class EveryBuild : public testing::TestWithParam<Build> {};

TEST_P(EveryBuild, GivesTheSameBits) {
    const Build& build = GetParam();
    if (!can_run(build.compiler)) GTEST_SKIP() << build.compiler << " is not here";
    const auto folder = std::filesystem::path(DRAPE_BUILD_DIR) / "bits" / build.name;
    std::filesystem::create_directories(folder);
    const auto finished = [&](const Words& words) {
        Process process(words, {}, folder);
        constexpr double an_hour = 3600;
        return process.wait(an_hour) == 0 ? "" : process.standard_output() + process.standard_error();
    };
    Words configure{"cmake", "-S", DRAPE_SOURCE_DIR, "-B", folder, "-G", "Ninja", "-DDRAPE_TESTS=OFF"};
    configure.push_back("-DCMAKE_CXX_COMPILER=" + build.compiler);
    configure.insert(configure.end(), build.options.begin(), build.options.end());
    ASSERT_EQ(finished(configure), "");
    ASSERT_EQ(finished({"cmake", "--build", folder, "--target", "drape-lab"}), "");

    Matrix matrix;
    matrix.add_methods();
    matrix.add_volumes();
    matrix.add_scenes({""});
    const Way way{build.name, {}, {}, folder / "bin" / "drape-lab"};
    int comparisons = matrix.compare(way);
    Matrix threaded;
    threaded.add_threaded();
    for (const char* threads : {"1", "2", "3", "4"}) {
        comparisons += threaded.compare(way, {"--set", std::string("solver.threads=") + threads});
    }
    tell_comparisons(comparisons);
}

INSTANTIATE_TEST_SUITE_P(Nightly, EveryBuild, testing::ValuesIn(builds),
                         [](const testing::TestParamInfo<Build>& one) { return one.param.name; });

}  // namespace
}  // namespace drape::test
