// Letters as masks of opacity, kept for the next picture.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "core/text/text.h"

namespace covaria::detail {

struct Mask {
    int width = 0, height = 0;
    std::vector<std::uint8_t> opacity = {};  ///< rows from top to bottom
    int at(int x, int y) const {
        return opacity[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(x)];
    }
};

struct TextMask {
    Mask letters;
    Mask halo;  ///< the letters grown by halo_width on every side
    int halo_width = 0;
};

/// The masks of one renderer. Text is UTF-8; the font is that of scene_fonts.h, else VTK's
/// own.
class TextMasks {
public:
    const TextMask& of(const Text& text, double pixels, bool bold = false);

private:
    std::map<std::tuple<Text, int, bool>, TextMask> masks_;
};

}  // namespace covaria::detail
