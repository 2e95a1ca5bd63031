// Texts that people typed, made printable.
#include "core/base/printable.h"

#include <gtest/gtest.h>

#include <string>

#include "core/base/utf8.h"

namespace covaria::printable_test {
namespace {

TEST(Printable, ControlCharactersAreSeen) {
    EXPECT_EQ(printable("\x1b[2J\x07"), "␛[2J␇");
    EXPECT_EQ(printable(std::string(1, '\0')), "␀");
    EXPECT_EQ(printable("\x7f"), "␡");
    EXPECT_EQ(printable("\xC2\x9B"), "\uFFFD") << "the escape of eight bits";
    EXPECT_EQ(printable("a\tb\nc"), "a\tb\nc");
    EXPECT_EQ(printable("a\r\nb\rc"), "a\nb␍c");
}

TEST(Printable, NothingElseIsChanged) {
    for (const char* text : {"", "Prüfling 5 µm ± 0.3 µm", "中文", "\xC2\xA0", "\xC2", "\xFF", "≤ −4×10⁻⁵"})
        EXPECT_EQ(printable(text), text);
}

TEST(Printable, AllOfTheFirst256) {
    for (unsigned c = 0; c < 256; ++c) {
        const std::string letter =
            c < 128 ? std::string(1, static_cast<char>(c))
                    : std::string{static_cast<char>(0xC0 | (c >> 6)), static_cast<char>(0x80 | (c & 0x3F))};
        const std::string shown = printable(letter);
        const bool control = c < 0x20 || (c >= 0x7F && c <= 0x9F), stays = c == '\t' || c == '\n';
        EXPECT_EQ(shown == letter, !control || stays) << c;
        EXPECT_EQ(valid_utf8(shown), shown.size()) << c;
    }
}

}  // namespace
}  // namespace covaria::printable_test
