#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>

#include "drape/base/input_error.h"
#include "drape/base/resources.h"
#include "drape/sim/scene.h"

namespace drape {
namespace {

std::string repeated(const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

std::string shipped_text(const std::string& name) {
    std::ifstream in(find_resource("scenes/" + name + ".toml"), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Reads a text as a scene; anything that is thrown but InputError fails the test.
bool is_refused(const std::string& text) {
    try {
        parse_scene(text, "bad.toml");
        return false;
    } catch (const InputError& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("bad.toml")) << error.what();
        EXPECT_LT(std::string(error.what()).size(), 1000u);
        return true;
    }
}

TEST(BadToml, IsRefusedWhateverItIs) {
    const std::vector<std::string> corpus{
        "[$a",
        "[",
        "]",
        "[[",
        "[[cloth]",
        "[cloth",
        "=",
        "= 5",
        "a",
        "a =",
        "a = [",
        "a = {",
        "a = \"",
        "a = '''",
        "a = \"\\u{110000}\"",
        "a = 1e99999",
        "a = 99999999999999999999",
        "a = 0x",
        "a = 1__0",
        "a = 2020-13-99",
        "[cloth]\n[cloth]\n",
        "[cloth]\nmass = 1\nmass = 2\n",
        "cloth.mass = 1\n[cloth]\nmass = 2\n",
        "\xef\xbb\xbf",
        "\xff\xfe\x00\x01",
        std::string(1, '\0'),
        std::string(100, '\0'),
        "[cloth]\r",
        "\u00e9 = 1\n",
        "[\u2e80]\n",
        "[cloth]\nmass = \ufb00\n",
        "[cloth]\nmass = 1 \u00e9\n",
        "\"\" = 5\n",
        "[\"\"]\n",
        repeated("a.", 19'999) + "a = 1\n",
        "[" + repeated("a.", 19'999) + "a]\n",
        "[cloth]\n" + repeated("a.", 2'000) + "a = 1\n",
        "[" + repeated("a.", 2'000) + "a]\n",
        "[cloth]\na = " + repeated("[", 2'000) + "\n",
        "[cloth]\na = " + repeated("{a=", 1'000) + "\n",
        "[cloth]\na = " + repeated("[\n", 100'000) + "\n",
        repeated("[[a.b.c]]\n", 20'000),
        "[cloth]\n" + repeated("# comment\n", 30'000),
        "# " + std::string(5'000, 'x') + "\n[cloth]\n",
        "[cloth]\n" + std::string(300'000, '\n'),
    };
    for (const std::string& text : corpus) EXPECT_TRUE(is_refused(text)) << text.substr(0, 60);
}

TEST(BadToml, OfSizesThatTheParserIsNotMadeForNamesTheLimit) {
    const auto message = [](const std::string& text) {
        try {
            parse_scene(text, "bad.toml");
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(message("[cloth]\n#" + std::string(4096, 'x') + "\n"),
              "bad.toml:2:1: a line of 4097 bytes: allowed at most 4096");
    EXPECT_EQ(message("[cloth]\n#" + std::string(4095, 'x') + "\n"), "");
    EXPECT_EQ(message("[cloth]\n" + repeated("# fifteen bytes\n", 16'384)),
              "bad.toml: 262152 bytes: allowed at most 262144");
}

TEST(BadToml, OfRandomBytesIsRefused) {
    std::mt19937 random(7);
    for (int i = 0; i < 2'000; ++i) {
        std::string text(random() % 200, '\0');
        for (char& c : text) c = static_cast<char>(random());
        EXPECT_TRUE(is_refused(text));
    }
}

TEST(DamagedScenes, CutOffAnywhereAreReadOrRefused) {
    for (const std::string& name : scene_names()) {
        const std::string text = shipped_text(name);
        ASSERT_FALSE(is_refused(text));
        for (std::size_t size = 0; size < text.size(); ++size) is_refused(text.substr(0, size));
    }
}

TEST(DamagedScenes, WithAnyByteChangedAreReadOrRefused) {
    std::mt19937 random(11);
    int refused = 0;
    for (const std::string& name : scene_names()) {
        std::string text = shipped_text(name);
        for (std::size_t at = 0; at < text.size(); ++at) {
            const char before = text[at];
            for (const char with : {'"', '\n', static_cast<char>(random())}) {
                text[at] = with;
                refused += is_refused(text) ? 1 : 0;
            }
            text[at] = before;
        }
    }
    EXPECT_GT(refused, 2'000);
}

TEST(DamagedScenes, MadeOfPiecesOfGoodOnesAreReadOrRefused) {
    std::mt19937 random(13);
    const std::string text = shipped_text("curtain") + shipped_text("two_corners");
    for (int i = 0; i < 3'000; ++i) {
        std::string mixed;
        for (int piece = 0; piece < 6; ++piece) mixed += text.substr(random() % text.size(), random() % 80);
        is_refused(mixed);
        is_refused("[cloth]\n" + mixed);
    }
}

}  // namespace
}  // namespace drape
