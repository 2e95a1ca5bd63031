// The letters that a picture can write.
#include "viz/vtk/scene_fonts.h"

#include <gtest/gtest.h>

#include <string>

#include "viz/vtk/text_masks.h"

namespace covaria::scene_fonts_test {
namespace {

DocumentLanguage language(const std::string& code) {
    return {code, {","}, [](const std::string& english) { return "#" + english; }};
}

TEST(SceneFonts, ALanguageIsSpokenWhereItsLettersAre) {
    const bool has_east_asian = font_file_for("中文", false) != font_file_for("text", false);
    for (const char* code : {"zh_CN", "ko"}) {
        const DocumentLanguage spoken = scene_language(language(code));
        EXPECT_EQ(spoken.code(), has_east_asian ? code : "en");
        EXPECT_EQ(spoken.say_declared("best") == "best", !has_east_asian);
        EXPECT_EQ(spoken.numbers().decimal, ",");
    }
    EXPECT_EQ(scene_language(language("de")).code(), "de");
    if (!has_east_asian) return;
    detail::TextMasks masks;
    EXPECT_NE(masks.of(Text("中"), 20).letters.opacity, masks.of(Text("한"), 20).letters.opacity)
        << "one box for all letters that are missing";
}

TEST(SceneFonts, LatinLettersGreekOnesAndSignsHaveOneFont) {
    for (const char* text : {"uncertainty × 2000", "größter Wert", "λ, µm, °, −", "a\u202fb"})
        EXPECT_EQ(font_file_for(text, true), font_file_for("a", true)) << text;
}

}  // namespace
}  // namespace covaria::scene_fonts_test
