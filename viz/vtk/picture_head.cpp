#include "viz/vtk/picture_head.h"

#include <algorithm>

#include "core/text/symbol.h"

namespace covaria::detail {
namespace {

constexpr double widest_line = 0.42;  // of a legend, of the width of its picture

const Mask& letters_of(const Word& word, double ratio, TextMasks& masks) {
    return masks.of(word.text, letter_size * word.scale * ratio, word.bold).letters;
}

}  // namespace

std::vector<HeadLine> head_lines(const Scene& scene, const LayerVisibility& layers, double ratio, int width,
                                 TextMasks& masks) {
    std::vector<HeadLine> lines;
    double y = (picture_margin - 4) * ratio;
    const double x = picture_margin * ratio, indent = 24 * ratio, gap = 3 * ratio;
    std::vector<Word> titles{{running_text(scene.title), Role::text, true, 1.15},
                             {running_text(scene.group_title), Role::text, false, 1.0}};
    for (const std::string& note : scene.notes)
        titles.push_back({running_text(note), Role::quiet_text, false, 0.92});
    for (const Word& word : titles) {
        if (word.text.empty()) continue;
        lines.push_back({word, x, y});
        y += letters_of(word, ratio, masks).height + 2 * ratio;
    }
    if (!layers[Layer::legend]) return lines;
    y += 6 * ratio;
    const auto word_of = [](const LegendLine& line) {
        return Word{line.text, Role::quiet_text, false, 0.92};
    };
    const auto is_wide = [&](const LegendLine& line) {
        return indent + letters_of(word_of(line), ratio, masks).width > widest_line * width;
    };
    // A small picture has no room beside the scene; the caption says what matters most, but of no arrow.
    const bool is_small = std::ranges::any_of(scene.legend, is_wide);
    for (const LegendLine& line : scene.legend) {
        if (is_small && (line.mark != LegendMark::arrow || is_wide(line))) continue;
        const Word word = word_of(line);
        lines.push_back({word, x + (line.mark == LegendMark::none ? 0.0 : indent), y, &line});
        y += letters_of(word, ratio, masks).height + gap;
    }
    return lines;
}

ScreenRect legend_ground(const std::vector<HeadLine>& lines, double ratio, TextMasks& masks) {
    const double x = picture_margin * ratio, gap = 3 * ratio;
    double widest = 0.0, top = 0.0, bottom = 0.0;
    for (const HeadLine& line : lines) {
        if (!line.legend) continue;
        const Mask& letters = letters_of(line.word, ratio, masks);
        if (widest == 0.0) top = line.y;
        widest = std::max(widest, line.x - x + letters.width);
        bottom = line.y + letters.height;
    }
    if (widest == 0.0) return {};
    return {x - gap, top - gap, widest + 3 * gap, bottom - top + 2 * gap};
}

}  // namespace covaria::detail
