// Title, legend, caption, scale bar, selection.
#include "viz/vtk/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text/numbers.h"
#include "core/text/round_numbers.h"
#include "core/text/symbol.h"
#include "core/text/wrapped.h"

namespace covaria::detail {
namespace {

constexpr double margin = picture_margin;

}  // namespace

Overlay::Overlay(const Scene& scene, const OverlayView& view, Image& image, TextMasks& masks)
    : scene_(scene), view_(view), canvas_(image), masks_(masks), taken_{view.reserved} {
    const PictureSize size = canvas_.size();
    if (view.covered > 0.0)
        taken_.push_back({0.0, size.height - view.covered, double(size.width), view.covered});
    if (!(view.inset.width > 0.0)) return;
    taken_.push_back(view.inset);
    const ScreenRect& r = view.inset;
    const Pixel corners[] = {
        {r.x, r.y}, {r.x + r.width, r.y}, {r.x + r.width, r.y + r.height}, {r.x, r.y + r.height}};
    for (int i = 0; i < 4; ++i)
        canvas_.line(corners[i], corners[(i + 1) % 4], px(1.0), grid_colour(view.palette));
}

void Overlay::paint() {
    // Words with a fixed place in a corner claim their room first: the words along the axes and
    // the labels go round them. They are painted after the lines that they cover.
    const std::vector<HeadLine> head =
        head_lines(scene_, view_.layers, view_.ratio, canvas_.size().width, masks_);
    for (const HeadLine& line : head) claim(line.word, line.x, line.y);
    if (const ScreenRect ground = legend_ground(head, view_.ratio, masks_); ground.width > 0.0)
        taken_.push_back(ground);  // it would pale what stands beside a short line
    const double bar_top = view_.layers[Layer::map] ? claim_colour_bar() : 0.0;
    paint_caption();
    if (view_.layers[Layer::legend]) paint_scale_bar();
    if (view_.layers[Layer::axes]) paint_axes();
    if (view_.layers[Layer::map]) paint_colour_bar(bar_top);
    paint_head(head);
    if (view_.layers[Layer::links]) paint_selected_sights();
    paint_verdicts();
    if (view_.layers[Layer::frames]) paint_frames();
    paint_measure();
    paint_selection();
    if (view_.layers[Layer::labels]) paint_labels();
}

const TextMask& Overlay::mask_of(const Word& word) {
    return masks_.of(word.text, px(letter_size * word.scale), word.bold);
}

void Overlay::claim(const Word& word, double x, double y) {
    const Mask& letters = mask_of(word).letters;
    taken_.push_back({x - 2, y - 1, letters.width + 4.0, letters.height + 2.0});
}

void Overlay::write(const Word& word, double x, double y) {
    const TextMask& mask = mask_of(word);
    canvas_.text(mask, x, y, colour(word.role), ground_colour(view_.palette));
    placed_.push_back(
        {word.text, word.role, {x, y, double(mask.letters.width), double(mask.letters.height)}, false});
}

void Overlay::put(const Word& word, double x, double y) {
    write(word, x, y);
    claim(word, x, y);
}

bool Overlay::is_free(const ScreenRect& rect) const {
    return std::none_of(taken_.begin(), taken_.end(), [&](const ScreenRect& t) { return t.overlaps(rect); });
}

bool Overlay::has_room(const ScreenRect& rect) const {
    return whole().contains(rect) && is_free(rect);
}

void Overlay::paint_head(const std::vector<HeadLine>& lines) {
    // The legend has a ground, so that the scene steps back where it reaches under it.
    const ScreenRect ground = legend_ground(lines, view_.ratio, masks_);
    if (ground.width > 0.0) canvas_.rectangle(ground, ground_colour(view_.palette), ground_opacity);
    for (const HeadLine& line : lines) {
        write(line.word, line.x, line.y);
        if (line.legend)
            paint_legend_mark(*line.legend, line.x - px(18),
                              line.y + mask_of(line.word).letters.height / 2.0);
    }
}

void Overlay::paint_legend_mark(const LegendLine& line, double x, double middle) {
    const Colour ink = colour(line.role);
    switch (line.mark) {
        case LegendMark::ellipsoid:
            canvas_.ellipse({x + px(6), middle}, px(6), px(4), ink, 0.9);
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
            for (int i = 0; i < 2; ++i)
                canvas_.line({x + px(8.0 * i), middle}, {x + px(8.0 * i + 5.0), middle}, px(1.2), ink);
            break;
        case LegendMark::arrow:
            canvas_.line({x, middle}, {x + px(15), middle}, px(1.6), ink);
            canvas_.line({x + px(11), middle - px(3)}, {x + px(15.5), middle}, px(1.6), ink);
            canvas_.line({x + px(11), middle + px(3)}, {x + px(15.5), middle}, px(1.6), ink);
            break;
        case LegendMark::diamond:
            paint_diamond({x + px(8), middle}, px(6), px(1.6), ink);
            break;
        case LegendMark::none:
            break;
    }
}

void Overlay::paint_diamond(Pixel centre, double half, double width, Colour ink) {
    const std::array<Pixel, 4> corners{{{centre.x, centre.y - half},
                                        {centre.x + half, centre.y},
                                        {centre.x, centre.y + half},
                                        {centre.x - half, centre.y}}};
    for (std::size_t i = 0; i < corners.size(); ++i)
        canvas_.line(corners[i], corners[(i + 1) % corners.size()], width, ink);
}

double Overlay::half_of_diamond(const SceneVerdict& mark) const {
    return std::max(px(9), 1.6 * mark.radius / metres_per_pixel(view_.camera, canvas_.size(), mark.at));
}

void Overlay::paint_verdicts() {
    for (const SceneVerdict& mark : scene_.not_met) {
        const Pixel at = pixel_of(mark.at);
        if (!view_.layers[mark.layer] || !std::isfinite(at.x + at.y)) continue;
        const double half = half_of_diamond(mark);
        paint_diamond(at, half, px(4.0), ground_colour(view_.palette));
        paint_diamond(at, half, px(2.0), colour(Role::not_met));
    }
}

void Overlay::paint_caption() {
    const bool before = view_.layers[Layer::ellipsoids_before] && !scene_.ellipsoids_before.empty();
    const bool drawn = view_.layers[Layer::ellipsoids] || view_.layers[Layer::clouds] || before;
    if (scene_.caption.empty() || !drawn) return;
    const double room = canvas_.size().width - 2 * px(margin);
    const auto word_of = [](const Text& line) { return Word{line, Role::quiet_text, false, 1.0}; };
    const auto fits = [&](const Text& line) { return mask_of(word_of(line)).letters.width <= room; };
    std::vector<Text> lines{scene_.caption};
    if (!fits(lines.front())) lines = wrapped(scene_.caption, fits);
    double y = canvas_.size().height - view_.covered - px(margin - 3);
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        y -= mask_of(word_of(*line)).letters.height;
        put(word_of(*line), px(margin), y);
        y -= px(2);
    }
}

void Overlay::paint_scale_bar() {
    if (!scene_.scale_bar || view_.camera.perspective) return;  // it would hold at one depth only
    const double scale = metres_per_pixel(view_.camera, canvas_.size());
    const double longest = std::min(0.18 * canvas_.size().width, px(220)) * scale * scene_.unit.per_metre;
    if (!(longest > 0) || !std::isfinite(longest)) return;
    const double shown = round_number_below(longest);
    const double length = shown / scene_.unit.per_metre / scale;
    const Word word{typeset_number(round_number_text(shown), scene_.numbers) + " " + scene_.unit.text,
                    Role::quiet_text, false, 1.0};
    const TextMask& mask = mask_of(word);
    const double right = canvas_.size().width - px(margin), height = mask.letters.height + px(14);
    double y = canvas_.size().height - view_.covered - px(margin);
    // A narrow picture has it above the caption.
    const auto is_clear = [&] {
        return is_free({right - length - px(3), y - height, length + px(6), height});
    };
    for (int lines = 0; lines < 2 && !is_clear(); ++lines) y -= height;
    const Colour ink = colour(Role::quiet_text);
    canvas_.rectangle({right - length - px(3), y - px(7), length + px(6), px(10)},
                      ground_colour(view_.palette), 0.7);
    canvas_.line({right - length, y}, {right, y}, px(1.0), ink);
    for (double end : {right - length, right}) canvas_.line({end, y - px(4)}, {end, y + px(4)}, px(1.0), ink);
    const double left = std::min(right - length / 2 - mask.letters.width / 2.0, right - mask.letters.width);
    put(word, left, y - px(6) - mask.letters.height);
    taken_.push_back({right - length - px(3), y - px(7), length + px(6), px(10)});
}

double Overlay::colour_bar_height() const {
    return std::min(0.42 * canvas_.size().height, px(260));
}

/// Claims the room of the colour bar; returns its upper edge. It is below the title where both do not fit.
double Overlay::claim_colour_bar() {
    if (!scene_.map || !(scene_.map->high > scene_.map->low)) return 0.0;
    const Mask& title = mask_of({scene_.map->title, Role::text, false, 1.0}).letters;
    const double right = canvas_.size().width - px(margin);
    double top = px(margin - 4);
    const double first = top;
    while (!is_free({right - title.width - px(8), top, title.width + px(8), double(title.height)}) &&
           top < first + 0.3 * canvas_.size().height)
        top += px(4);
    const double widest = std::max(double(title.width), px(70));
    taken_.push_back({right - widest, top, widest + px(margin), px(26) + colour_bar_height() + px(8)});
    return top;
}

void Overlay::paint_colour_bar(double title_top) {
    if (!scene_.map || !(scene_.map->high > scene_.map->low)) return;
    const SceneMap& map = *scene_.map;
    const double height = colour_bar_height(), width = px(14);
    const double right = canvas_.size().width - px(margin), top = title_top + px(26);
    double widest = 0.0;
    for (const AxisTick& tick : map.ticks)
        widest = std::max(widest, double(mask_of({tick.text, Role::quiet_text, false, 1.0}).letters.width));
    const double left = right - widest - px(6) - width;
    const Word title{map.title, Role::text, false, 1.0};
    write(title, right - mask_of(title).letters.width, title_top);
    constexpr int steps = 64;
    for (int i = 0; i < steps; ++i)
        canvas_.rectangle({left, top + i * height / steps, width, height / steps + 1.0},
                          magnitude_colour(1.0 - (i + 0.5) / steps), 1.0);
    for (const AxisTick& tick : map.ticks) {
        const Word word{tick.text, Role::quiet_text, false, 1.0};
        const TextMask& mask = mask_of(word);
        const double y = top + height * (map.high - tick.at) / (map.high - map.low);
        canvas_.line({left + width, y}, {left + width + px(3), y}, px(1.0), colour(Role::text));
        write(word, left + width + px(6), y - mask.letters.height / 2.0);
    }
}

void Overlay::paint_selection() {
    const SceneItem* item = view_.selected.empty() ? nullptr : find_item(scene_, view_.selected);
    if (!item) return;
    double radius = px(9);
    const double scale = metres_per_pixel(view_.camera, canvas_.size(), item->position);
    for (const ScenePoint& point : scene_.points)
        if (point.item.id == item->id) radius = std::max(radius, point.radius / scale + px(5));
    const Pixel at = pixel_of(item->position);
    if (!(std::abs(at.x) < 1e5 && std::abs(at.y) < 1e5)) return;
    canvas_.ring(at, radius, px(4.5), ground_colour(view_.palette), 0.8);
    canvas_.ring(at, radius, px(2.2), selection_colour(view_.palette));
}

}  // namespace covaria::detail
