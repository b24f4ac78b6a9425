#include <gtest/gtest.h>

#include <fstream>

#include "bits/matrix.h"
#include "drape/integrate/integrator.h"

namespace drape::test {
namespace {

/// As on a processor without fused multiply-add, but for the C library alone. glibc 2.33 and later spell it so.
const Way without_fma{"without FMA", {}, {{"GLIBC_TUNABLES", "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4"}}};

/// Generations of processors as qemu knows them: one without AVX, then with AVX2 and FMA, of two makers.
const std::vector<std::string> generations{"Nehalem", "Haswell", "Skylake-Client", "EPYC"};

Way emulated(const std::string& processor) { return {processor, {"qemu-x86_64", "-cpu", processor}}; }

bool this_processor_has_fma() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string word; in >> word;) {
        if (word == "fma") return true;
    }
    return false;
}

/// A fault that is always planted: the C library's sine must be seen to differ. Our own must not.
void expect_to_see_the_sine_of_the_c_library(const Way& one, const Way& other) {
    const LabFolder folder;
    const auto bits = [&](const Way& way, const std::string& whose) {
        return bits_of(folder, way, SINE_PROBE, {whose});
    };
    EXPECT_NE(bits(one, "library"), bits(other, "library")) << "this comparison would miss it";
    EXPECT_EQ(bits(one, "own"), bits(other, "own"));
}

TEST(SameBits, ComeWhateverTheCLibraryHasForTheProcessor) {
    if (!this_processor_has_fma()) GTEST_SKIP() << "the C library has one variant of each function for this processor";
    expect_to_see_the_sine_of_the_c_library({"plainly"}, without_fma);
    Matrix matrix;
    matrix.add_methods();
    matrix.add_volumes();
    matrix.add_scenes({""});
    matrix.add("curtain --time 2 --set wind.on=1");
    tell_comparisons(1 + matrix.compare(without_fma));
}

TEST(SameBits, ComeFromAnyNumberOfThreads) {
    Matrix matrix;
    matrix.add_threaded();
    int comparisons = 0;
    for (const char* threads : {"2", "4"}) {
        comparisons += matrix.compare({"threads"}, {"--set", std::string("solver.threads=") + threads});
    }
    tell_comparisons(comparisons);
}

TEST(SameBits, ComeFromTheOldestAndTheNewestProcessor) {
    if (const std::string why = no_emulator(); !why.empty()) GTEST_SKIP() << why;
    expect_to_see_the_sine_of_the_c_library(emulated("Nehalem"), emulated("Haswell"));
    Matrix all, some;
    all.add_methods();
    some.add_methods({"rk4", "backward_euler", "xpbd", "projective_dynamics"});
    tell_comparisons(1 + all.compare(emulated(generations.front())) + some.compare(emulated(generations.back())));
}

/// All scenes with all methods, and all volumes.
class EveryCell : public testing::TestWithParam<std::string> {};

TEST_P(EveryCell, HasTheSameBitsOnAProcessor) {
    if (const std::string why = no_emulator(); !why.empty()) GTEST_SKIP() << why;
    Matrix matrix;
    matrix.add_volumes();
    matrix.add_scenes({names_of<IntegratorKind>().begin(), names_of<IntegratorKind>().end()});
    tell_comparisons(matrix.compare(emulated(GetParam())));
}

std::string name_of_processor(const testing::TestParamInfo<std::string>& one) {
    std::string name = one.param;
    std::erase(name, '-');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Nightly, EveryCell, testing::ValuesIn(generations), name_of_processor);

}  // namespace
}  // namespace drape::test
