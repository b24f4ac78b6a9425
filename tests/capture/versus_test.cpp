// How a comparison that cannot begin ends a program: what the user can mend with 2, what the machine lacks with 1.

#include <gmock/gmock.h>
#include <sys/resource.h>

#include "drape/scene/memory.h"
#include "drape/scene/scene.h"
#include "drape/scene/setting_table.h"
#include "program.h"
#include "support/address_space.h"

namespace drape::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Outcome compare_drop_with(const std::string& assignments) {
    return run_program("drape-capture", {"drop", "--versus", assignments, "--frames", "1", "--hash"});
}

TEST(Versus, EndsWithTwoAndTheRangeOnBadInput) {
    const std::pair<const char*, const char*> cases[]{
        {"nonsense", "expected name=value"},
        {"cloth.foo=3", "unknown setting 'cloth.foo'"},
        {"cloth.mass=-1", "allowed 1e-09 <= mass"},
        {"cloth.mass=heavy", "allowed 1e-09 <= mass"},
        {"cloth[3].mass=1", "the scene has 1"},
        {"cloth.particles=4096,4096", "allowed at most"},
        {"solver.dt=1e-9", "allowed 3.13e-07 and more"},
        {"start=/no/such/state.csv", "cannot be read"},
    };
    for (const auto& [assignments, message] : cases) {
        const Outcome outcome = compare_drop_with(assignments);
        EXPECT_EQ(outcome.exit_code, 2) << assignments;
        EXPECT_THAT(outcome.err, AllOf(StartsWith("drape-capture: --versus: "), HasSubstr(message))) << assignments;
        EXPECT_EQ(outcome.out, "") << assignments;
    }
}

#ifdef DRAPE_CAN_LIMIT_ADDRESS_SPACE
// The other cloth alone would just fit, but not beside the program
TEST(Versus, EndsWithOneWhereMemoryIsTooLittleForBoth) {
    Settings other = load_scene("drop");
    assign(other, "cloth.particles=300,300");
    assign(other, "contact.self=false");
    rlimit before{};
    getrlimit(RLIMIT_AS, &before);
    rlimit little = before;
    little.rlim_cur = static_cast<rlim_t>(1.05 * memory_needed(other));
    setrlimit(RLIMIT_AS, &little);
    const Outcome outcome = compare_drop_with("cloth.particles=300,300,contact.self=false");
    setrlimit(RLIMIT_AS, &before);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, StartsWith("drape-capture: --versus: out of memory: 90000 particles"));
}
#endif

}  // namespace
}  // namespace drape::test
