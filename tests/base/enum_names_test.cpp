#include "drape/base/enum_names.h"

#include <gtest/gtest.h>

namespace drape {

enum class Season { Spring, Summer, Winter };

template <>
inline constexpr auto enum_names<Season> = all_names<Season>("spring", "summer", "winter");

namespace {

enum class Nameless { One };

TEST(EnumNames, AreReadBack) {
    EXPECT_EQ(name_of(Season::Winter), "winter");
    EXPECT_EQ(value_named<Season>("summer"), Season::Summer);
    for (const char* name : {"", "Summer", "summer ", "autumn"}) EXPECT_FALSE(value_named<Season>(name)) << name;
}

TEST(EnumNames, AreCountedByTheCompiler) {
    static_assert(is_enumerator<static_cast<Season>(2)>());
    static_assert(!is_enumerator<static_cast<Season>(3)>(), "so all_names refuses two names or four");
    static_assert(NamedEnum<Season> && !NamedEnum<Nameless> && !NamedEnum<int>);
}

}  // namespace
}  // namespace drape
