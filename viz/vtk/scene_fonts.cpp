#include "viz/vtk/scene_fonts.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace covaria {
namespace {

struct FontFiles {
    std::string regular = {}, bold = {};
};

/// The first of both that is there; `bold` is the regular one where a font has no other.
FontFiles first_of(const std::vector<FontFiles>& candidates) {
    const auto is_there = [](const std::string& file) {
        std::error_code ignored;
        return std::filesystem::is_regular_file("/usr/share/fonts/" + file, ignored);
    };
    FontFiles found;
    for (const FontFiles& files : candidates) {
        if (found.regular.empty() && is_there(files.regular))
            found.regular = "/usr/share/fonts/" + files.regular;
        if (found.bold.empty() && is_there(files.bold)) found.bold = "/usr/share/fonts/" + files.bold;
    }
    if (found.bold.empty()) found.bold = found.regular;
    return found;
}

const FontFiles& latin_fonts() {
    static const FontFiles files = first_of(
        {{"opentype/inter/Inter-Regular.otf", "opentype/inter/Inter-SemiBold.otf"},
         {"truetype/liberation2/LiberationSans-Regular.ttf", "truetype/liberation2/LiberationSans-Bold.ttf"},
         {"truetype/liberation/LiberationSans-Regular.ttf", "truetype/liberation/LiberationSans-Bold.ttf"},
         {"liberation-sans/LiberationSans-Regular.ttf", "liberation-sans/LiberationSans-Bold.ttf"},
         {"truetype/dejavu/DejaVuSans.ttf", "truetype/dejavu/DejaVuSans-Bold.ttf"},
         {"TTF/DejaVuSans.ttf", "TTF/DejaVuSans-Bold.ttf"}});
    return files;
}

/// Fonts with Latin letters, too, since a text has one font: not Droid Sans Fallback, which has none.
const FontFiles& east_asian_fonts() {
    static const FontFiles files =
        first_of({{"opentype/noto/NotoSansCJK-Regular.ttc", "opentype/noto/NotoSansCJK-Bold.ttc"},
                  {"noto-cjk/NotoSansCJK-Regular.ttc", "noto-cjk/NotoSansCJK-Bold.ttc"},
                  {"google-noto-cjk/NotoSansCJK-Regular.ttc", "google-noto-cjk/NotoSansCJK-Bold.ttc"},
                  {"truetype/wqy/wqy-zenhei.ttc", ""},
                  {"truetype/wqy/wqy-microhei.ttc", ""}});
    return files;
}

/// Leading bytes of UTF-8 from U+3000 to the end of the first plane.
bool has_east_asian_letters(std::string_view text) {
    return std::ranges::any_of(text, [](char byte) {
        const auto b = static_cast<unsigned char>(byte);
        return b >= 0xE3 && b < 0xF0;
    });
}

}  // namespace

const std::string& font_file_for(std::string_view text, bool bold) {
    const FontFiles& files = has_east_asian_letters(text) && !east_asian_fonts().regular.empty()
                                 ? east_asian_fonts()
                                 : latin_fonts();
    return bold ? files.bold : files.regular;
}

DocumentLanguage scene_language(const DocumentLanguage& wanted) {
    const bool east_asian = wanted.code().starts_with("zh") || wanted.code().starts_with("ko");
    if (!east_asian || !east_asian_fonts().regular.empty()) return wanted;
    return {"en", wanted.numbers(), {}};
}

}  // namespace covaria
