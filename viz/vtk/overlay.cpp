// Title, legend, caption, scale bar, labels.
#include "viz/vtk/overlay.h"

#include <algorithm>
#include <cmath>

#include "core/text/round_numbers.h"
#include "core/text/symbol.h"

namespace covaria::detail {
namespace {

constexpr double letter_size = 13.0;
constexpr double margin = 14.0;

}  // namespace

Overlay::Overlay(const Scene& scene, const OverlayView& view, Image& image, TextMasks& masks)
    : scene_(scene), view_(view), canvas_(image), masks_(masks) {}

void Overlay::paint() {
    paint_caption();
    if (view_.layers[Layer::axes]) paint_scale_bar();
    if (view_.layers[Layer::axes]) paint_axes();
    if (view_.layers[Layer::map]) paint_colour_bar();
    paint_heading();
    paint_selection();
    if (view_.layers[Layer::frames] && view_.layers[Layer::labels]) paint_triad_letters();
    if (view_.layers[Layer::labels]) paint_labels();
}

const TextMask& Overlay::mask_of(const Word& word) {
    return masks_.of(word.text, px(letter_size * word.scale), word.bold);
}

void Overlay::put(const Word& word, double x, double y, bool claim) {
    const TextMask& mask = mask_of(word);
    canvas_.text(mask, x, y, colour(word.role), ground_top(view_.palette));
    if (claim) taken_.push_back({x - 2, y - 1, mask.letters.width + 4.0, mask.letters.height + 2.0});
}

bool Overlay::is_free(const ScreenRect& rect) const {
    return std::none_of(taken_.begin(), taken_.end(), [&](const ScreenRect& t) { return t.overlaps(rect); });
}

void Overlay::paint_heading() {
    double y = px(margin - 4);
    const double x = px(margin);
    for (const Word& word : {Word{running_text(scene_.title), Role::text, true, 1.15},
                             Word{running_text(scene_.group), Role::text, false, 1.0}}) {
        if (word.text.empty()) continue;
        put(word, x, y);
        y += mask_of(word).letters.height + px(2);
    }
    if (view_.layers[Layer::legend]) paint_legend(y + px(6));
}

void Overlay::paint_legend(double y) {
    const double x = px(margin), indent = px(24), gap = px(3);
    const auto word_of = [](const LegendLine& line) {
        return Word{line.text, Role::quiet_text, false, 0.92};
    };
    double widest = 0.0, height = 0.0;
    for (const LegendLine& line : scene_.legend) {
        widest = std::max(widest, indent + mask_of(word_of(line)).letters.width);
        height += mask_of(word_of(line)).letters.height + gap;
    }
    // A small picture has no room beside the scene; the caption says what matters most.
    if (widest > 0.3 * canvas_.size().width) return;
    // Where the scene reaches under the legend, it steps back.
    canvas_.rectangle({x - gap, y - gap, widest + 3 * gap, height + gap}, ground_top(view_.palette), 0.8);
    for (const LegendLine& line : scene_.legend) {
        const TextMask& mask = mask_of(word_of(line));
        put(word_of(line), x + (line.mark == LegendMark::none ? 0.0 : indent), y);
        paint_legend_mark(line, x, y + mask.letters.height / 2.0);
        y += mask.letters.height + gap;
    }
}

void Overlay::paint_legend_mark(const LegendLine& line, double x, double middle) {
    const Colour ink = colour(line.role);
    switch (line.mark) {
        case LegendMark::ellipsoid:
            canvas_.ellipse({x + px(8), middle}, px(8), px(5), ink, 0.30);
            canvas_.ellipse({x + px(8), middle}, px(7), px(4), ink, 0.15);
            break;
        case LegendMark::cloud:
            for (int i = 0; i < 14; ++i) {  // points at the golden angle
                const double r = std::sqrt((i + 0.5) / 14), angle = 2.39996 * i;
                canvas_.ellipse({x + px(8 + 7 * r * std::cos(angle)), middle + px(5 * r * std::sin(angle))},
                                px(0.9), px(0.9), ink, 0.9);
            }
            break;
        case LegendMark::histogram:
            for (int i = 0; i < 5; ++i) {
                static constexpr double heights[] = {3, 7, 10, 6, 2};
                canvas_.rectangle({x + px(1 + 3 * i), middle + px(5 - heights[i]), px(2.4), px(heights[i])},
                                  ink, 0.62);
            }
            break;
        case LegendMark::line:
            for (int i = 0; i < 3; ++i)
                canvas_.line({x + px(6.0 * i), middle}, {x + px(6.0 * i + 3.5), middle}, px(1.4), ink);
            break;
        case LegendMark::arrow:
            canvas_.line({x, middle}, {x + px(15), middle}, px(1.6), ink);
            canvas_.line({x + px(11), middle - px(3)}, {x + px(15.5), middle}, px(1.6), ink);
            canvas_.line({x + px(11), middle + px(3)}, {x + px(15.5), middle}, px(1.6), ink);
            break;
        case LegendMark::none:
            break;
    }
}

void Overlay::paint_caption() {
    const bool drawn = view_.layers[Layer::ellipsoids] || view_.layers[Layer::clouds];
    if (scene_.caption.empty() || !drawn) return;
    const Word word{scene_.caption, Role::text, false, 1.0};
    put(word, px(margin), canvas_.size().height - px(margin - 4) - mask_of(word).letters.height);
}

void Overlay::paint_scale_bar() {
    if (!scene_.scale_bar) return;
    const double scale = metres_per_pixel(view_.camera, canvas_.size());
    const double longest = std::min(0.18 * canvas_.size().width, px(220)) * scale * scene_.unit.per_metre;
    if (!(longest > 0) || !std::isfinite(longest)) return;
    const double shown = round_number_below(longest);
    const double length = shown / scene_.unit.per_metre / scale;
    const Word word{round_number_text(shown) + " " + scene_.unit.text, Role::text, false, 0.92};
    const TextMask& mask = mask_of(word);
    const double right = canvas_.size().width - px(margin), y = canvas_.size().height - px(margin);
    const Colour ink = colour(Role::text);
    canvas_.rectangle({right - length - px(3), y - px(7), length + px(6), px(10)}, ground_top(view_.palette),
                      0.7);
    canvas_.line({right - length, y}, {right, y}, px(1.4), ink);
    for (double end : {right - length, right}) canvas_.line({end, y - px(4)}, {end, y}, px(1.4), ink);
    const double left = std::min(right - length / 2 - mask.letters.width / 2.0, right - mask.letters.width);
    put(word, left, y - px(6) - mask.letters.height);
    taken_.push_back({right - length - px(3), y - px(7), length + px(6), px(10)});
}

void Overlay::paint_colour_bar() {
    if (!scene_.map || !(scene_.map->high > scene_.map->low)) return;
    const SceneMap& map = *scene_.map;
    const double height = std::min(0.42 * canvas_.size().height, px(260)), width = px(14);
    const double right = canvas_.size().width - px(margin), top = px(margin + 22);
    double widest = 0.0;
    for (const AxisTick& tick : map.ticks)
        widest = std::max(widest, double(mask_of({tick.text, Role::text, false, 0.92}).letters.width));
    const double left = right - widest - px(6) - width;
    const Word title{map.title, Role::text, false, 1.0};
    put(title, right - mask_of(title).letters.width, px(margin - 4));
    constexpr int steps = 64;
    for (int i = 0; i < steps; ++i)
        canvas_.rectangle({left, top + i * height / steps, width, height / steps + 1.0},
                          magnitude_colour(1.0 - (i + 0.5) / steps), 1.0);
    for (const AxisTick& tick : map.ticks) {
        const Word word{tick.text, Role::text, false, 0.92};
        const TextMask& mask = mask_of(word);
        const double y = top + height * (map.high - tick.at) / (map.high - map.low);
        canvas_.line({left + width, y}, {left + width + px(3), y}, px(1.0), colour(Role::text));
        put(word, left + width + px(6), y - mask.letters.height / 2.0);
    }
    taken_.push_back({left, top, right - left, height});
}

void Overlay::paint_triad_letters() {
    static constexpr const char* names[] = {"x", "y", "z"};
    static constexpr Role roles[] = {Role::axis_x, Role::axis_y, Role::axis_z};
    for (const SceneFrame& frame : scene_.frames)
        for (int i = 0; i < 3; ++i) {
            const Pixel from = pixel_of(frame.item.position);
            const Pixel tip = pixel_of(frame.item.position + frame.length * frame.R_WF.col(i));
            const double length = std::hypot(tip.x - from.x, tip.y - from.y);
            if (length < px(9)) continue;  // points at the eye
            const Word word{names[i], roles[i], true, 0.92};
            const TextMask& mask = mask_of(word);
            const double reach = 1 + px(8) / length;
            const ScreenRect rect{from.x + reach * (tip.x - from.x) - mask.letters.width / 2.0,
                                  from.y + reach * (tip.y - from.y) - mask.letters.height / 2.0,
                                  double(mask.letters.width), double(mask.letters.height)};
            if (is_free(rect)) put(word, rect.x, rect.y);
        }
}

void Overlay::paint_selection() {
    const SceneItem* item = view_.selected.empty() ? nullptr : find_item(scene_, view_.selected);
    if (!item) return;
    double radius = px(9);
    const double scale = metres_per_pixel(view_.camera, canvas_.size());
    for (const ScenePoint& point : scene_.points)
        if (point.item.id == item->id) radius = std::max(radius, point.radius / scale + px(5));
    const Pixel at = pixel_of(item->position);
    if (!(std::abs(at.x) < 1e5 && std::abs(at.y) < 1e5)) return;
    canvas_.ring(at, radius, px(4.5), ground_top(view_.palette), 0.8);
    canvas_.ring(at, radius, px(2.2), selection_colour(view_.palette));
}

void Overlay::paint_labels() {
    const SceneItem* selected = view_.selected.empty() ? nullptr : find_item(scene_, view_.selected);
    const double scale = metres_per_pixel(view_.camera, canvas_.size());
    std::vector<Word> words;
    std::vector<LabelRequest> requests;
    std::vector<ScreenRect> taken = taken_;
    for (const SceneLabel& label : scene_.labels) {
        const bool is_selected =
            selected && running_text(selected->name) == label.text && selected->position == label.at;
        const Word word{label.text, label.role, is_selected, 1.0};
        const TextMask& mask = mask_of(word);
        const Pixel at = pixel_of(label.at);
        const double clearance = label.clearance / scale + px(is_selected ? 10 : 4);
        words.push_back(word);
        requests.push_back({at, mask.letters.width + px(2), double(mask.letters.height), clearance,
                            is_selected ? 1000 : label.priority});
        const double half = 0.6 * label.clearance / scale + px(1);
        taken.push_back({at.x - half, at.y - half, 2 * half, 2 * half});
    }
    const ScreenRect inside{2, 2, canvas_.size().width - 4.0, canvas_.size().height - 4.0};
    const auto placed = place_labels(requests, inside, std::move(taken));
    for (std::size_t i = 0; i < placed.size(); ++i)
        if (placed[i]) put(words[i], placed[i]->x + px(1), placed[i]->y);
}

}  // namespace covaria::detail
