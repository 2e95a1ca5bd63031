#include "viz/vtk/picture_head.h"

#include <algorithm>

#include "core/text/symbol.h"
#include "core/text/wrapped.h"

namespace covaria::detail {
namespace {

constexpr double widest_row = 0.55;  // part of a picture's width: the other corner has the rest
constexpr double swatch = 18.0, between = 14.0;

bool is_shown(const LegendLine& line, const LayerVisibility& layers) {
    switch (line.mark) {
        case LegendMark::cloud:
            return layers[Layer::clouds];
        case LegendMark::histogram:
            return layers[Layer::wall_histograms];
        case LegendMark::ellipsoid:
            return layers[line.role == Role::before ? Layer::ellipsoids_before : Layer::ellipsoids];
        case LegendMark::line:
            return layers[Layer::links];
        case LegendMark::arrow:
            return layers[Layer::vectors];
        default:
            return true;
    }
}

const Mask& letters_of(const Word& word, double ratio, TextMasks& masks) {
    return masks.of(word.text, letter_size * word.scale * ratio, word.bold).letters;
}

}  // namespace

std::vector<HeadLine> head_lines(const Scene& scene, const LayerVisibility& layers, double ratio, int width,
                                 TextMasks& masks) {
    std::vector<HeadLine> lines;
    const double left = picture_margin * ratio, row = 16.0 * ratio;
    double x = left, y = (picture_margin - 3) * ratio;
    const auto add = [&](const Word& word, double indent, const LegendLine* legend) {
        const double wide = indent + letters_of(word, ratio, masks).width;
        if (x > left && x + wide > widest_row * width) {
            x = left;
            y += row;
        }
        lines.push_back({word, x + indent, y, legend});
        x += wide + between * ratio;
    };
    if (!scene.group_title.empty())
        add({running_text(scene.group_title), Role::text, true, 1.0}, 0.0, nullptr);
    std::vector<Word> remarks;
    for (const LegendLine& line : scene.legend) {
        if (!layers[Layer::legend] || !is_shown(line, layers)) continue;
        const Word word{line.text, Role::quiet_text, false, 1.0};
        if (line.mark == LegendMark::none)
            remarks.push_back(word);
        else
            add(word, swatch * ratio, &line);
    }
    for (const std::string& note : scene.notes)
        remarks.push_back({running_text(note), Role::quiet_text, false, 1.0});
    if (x > left) y += row;
    for (const Word& word : remarks) {
        const auto fits = [&](const Text& line) {
            return letters_of({line, word.role}, ratio, masks).width <= widest_row * width;
        };
        for (const Text& line : fits(word.text) ? std::vector<Text>{word.text} : wrapped(word.text, fits)) {
            lines.push_back({{line, word.role, false, 1.0}, left, y, nullptr});
            y += row;
        }
    }
    return lines;
}

ScreenRect legend_ground(const std::vector<HeadLine>& lines, double ratio, TextMasks& masks) {
    if (lines.empty()) return {};
    const double left = picture_margin * ratio, top = lines.front().y, gap = 3 * ratio;
    double right = left, bottom = top;
    for (const HeadLine& line : lines) {
        const Mask& letters = letters_of(line.word, ratio, masks);
        right = std::max(right, line.x + letters.width);
        bottom = std::max(bottom, line.y + letters.height);
    }
    return {left - gap, top - gap, right - left + 2 * gap, bottom - top + 2 * gap};
}

}  // namespace covaria::detail
