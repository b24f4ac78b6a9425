#include <gtest/gtest.h>

#include "drape/scene/scene.h"
#include "support/input_errors.h"

namespace drape {
namespace {

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

}  // namespace
}  // namespace drape
