// Marks on the picture for an item selected or pointed at: its frame, its sights.
#include <algorithm>
#include <cmath>

#include "viz/vtk/overlay.h"

namespace covaria::detail {
namespace {

constexpr double frame_width = 2.0, sight_width = 1.5;  // points
constexpr double dash = 6.0, gap_of_dash = 4.0;
constexpr double same_place = 1e-6;  // part of the scene's size
constexpr double farthest = 1e5;     // pixels: what is far outside is not drawn dash by dash

bool is_near_picture(Pixel at) {
    return std::abs(at.x) < farthest && std::abs(at.y) < farthest;
}

}  // namespace

bool Overlay::is_asked_for(const std::string& item) const {
    return !item.empty() && (item == view_.selected || item == view_.pointed);
}

bool Overlay::shows(const SceneFrame& frame) const {
    const bool is_of_world =
        frame.item.position.norm() <= same_place * scene_.size && frame.R_WF.isIdentity(same_place);
    return is_of_world || is_of_asked(frame);
}

bool Overlay::is_of_asked(const SceneFrame& frame) const {
    const double near = same_place * scene_.size;
    if (is_asked_for(frame.item.id) || is_asked_for(frame.item.body)) return true;
    return std::ranges::any_of(scene_.points, [&](const ScenePoint& point) {
        return is_asked_for(point.item.id) && (point.item.position - frame.item.position).norm() <= near;
    });
}

void Overlay::paint_frames() {
    static constexpr const char* names[] = {"x", "y", "z"};
    static constexpr Role roles[] = {Role::axis_x, Role::axis_y, Role::axis_z};
    for (const SceneFrame& frame : scene_.frames) {
        if (!shows(frame)) continue;
        for (int i = 0; i < 3; ++i) {
            const Pixel from = pixel_of(frame.item.position);
            const Pixel tip = pixel_of(frame.item.position + frame.length * frame.R_WF.col(i));
            const double length = std::hypot(tip.x - from.x, tip.y - from.y);
            if (!is_near_picture(from) || !is_near_picture(tip) || length < px(2)) continue;
            canvas_.line(from, tip, px(frame_width), colour(roles[i]));
            if (!view_.layers[Layer::labels] || length < px(9)) continue;  // points at the eye
            const Word word{names[i], roles[i], true, 1.0};
            const TextMask& mask = mask_of(word);
            const double reach = 1 + px(8) / length;
            const ScreenRect rect{from.x + reach * (tip.x - from.x) - mask.letters.width / 2.0,
                                  from.y + reach * (tip.y - from.y) - mask.letters.height / 2.0,
                                  double(mask.letters.width), double(mask.letters.height)};
            if (has_room(rect)) put(word, rect.x, rect.y);
        }
    }
}

void Overlay::paint_selected_sights() {
    if (view_.selected.empty()) return;
    const SceneItem* selected = find_item(scene_, view_.selected);
    if (!selected) return;
    const double near = same_place * scene_.size;
    for (const SceneLink& link : scene_.links) {
        if (link.kind != LinkKind::sight_line) continue;
        const bool is_its = link.item.id == view_.selected || (link.to - selected->position).norm() <= near;
        const Pixel from = pixel_of(link.from), to = pixel_of(link.to);
        const double length = std::hypot(to.x - from.x, to.y - from.y);
        if (!is_its || !is_near_picture(from) || !is_near_picture(to) || !(length > 0)) continue;
        for (double at = 0.0; at < length; at += px(dash + gap_of_dash)) {
            const double a = at / length, b = std::min(1.0, (at + px(dash)) / length);
            canvas_.line({from.x + a * (to.x - from.x), from.y + a * (to.y - from.y)},
                         {from.x + b * (to.x - from.x), from.y + b * (to.y - from.y)}, px(sight_width),
                         colour(Role::input));
        }
    }
}

}  // namespace covaria::detail
