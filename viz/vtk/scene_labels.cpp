// Labels of a scene: one for what stands at one place, clear of tubes, arrows, instruments and axes where
// there is room.
#include <algorithm>
#include <cmath>

#include "viz/vtk/overlay.h"

namespace covaria::detail {
namespace {

constexpr double one_place = 3.0;        // points: nearer anchors cannot be told apart
constexpr std::size_t most_joined = 3;   // a longer label would find no room
constexpr double thinnest = 2.0;         // points, half of a line
constexpr double gap = 5.0;              // points, from a label to the next
constexpr double glyph_extent = 0.25;    // to each side, of the size of an instrument
constexpr double shaft_of_frame = 0.03;  // of its length, with half of its tip

}  // namespace

std::vector<ScreenLine> Overlay::what_labels_avoid() const {
    std::vector<ScreenLine> drawn;
    const auto add = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
        const double scale = metres_per_pixel(view_.camera, canvas_.size(), (from + to) / 2);
        const ScreenLine line{pixel_of(from), pixel_of(to), std::max(radius / scale, px(thinnest))};
        if (std::isfinite(line.from.x + line.from.y + line.to.x + line.to.y + line.half_width))
            drawn.push_back(line);
    };
    if (view_.layers[Layer::links])
        for (const SceneLink& link : scene_.links)
            add(link.from, link.to, link.radius);  // a thin line has a radius of 0
    if (view_.layers[Layer::vectors])
        for (const SceneVector& vector : scene_.vectors)
            add(vector.item.position, vector.item.position + vector.arrow, vector.radius);
    if (view_.layers[Layer::frames])
        for (const SceneFrame& frame : scene_.frames)
            for (int i = 0; i < 3; ++i)
                add(frame.item.position, frame.item.position + frame.length * frame.R_WF.col(i),
                    shaft_of_frame * frame.length);
    if (view_.layers[Layer::bodies])
        for (const SceneBody& body : scene_.bodies)
            if (body.outline.empty()) add(body.item.position, body.item.position, glyph_extent * body.size);
    if (view_.layers[Layer::ellipsoids] || view_.layers[Layer::clouds])
        for (const SceneEllipsoid& ellipsoid : scene_.ellipsoids) {
            const Eigen::Vector3d longest = ellipsoid.axes.col(0);
            const double half = longest.norm(), width = ellipsoid.axes.col(1).norm();
            if (!(half > 0.0)) continue;
            const Eigen::Vector3d part = longest * std::max(0.0, half - width) / half;
            add(ellipsoid.item.position - part, ellipsoid.item.position + part, width);
        }
    if (view_.layers[Layer::axes])
        for (const AxisEdge& edge : axis_edges()) drawn.push_back({edge.from, edge.to, px(thinnest)});
    return drawn;
}

Overlay::PlannedLabel Overlay::planned(const SceneLabel& label) const {
    const bool is_selected = !view_.selected.empty() && view_.selected == label.item;
    const double scale = metres_per_pixel(view_.camera, canvas_.size(), label.at);
    PlannedLabel made{{label.text, label.role, is_selected, 1.0}, {.anchor = pixel_of(label.at)}, {}};
    made.request.clearance = label.clearance / scale + px(is_selected ? 10 : 4);
    made.request.priority = is_selected ? 1000 : label.priority;
    made.request.gap = px(gap);
    made.request.is_needed = is_selected;
    return made;
}

std::vector<Overlay::PlannedLabel> Overlay::joined(const std::vector<PlannedLabel>& labels) const {
    std::vector<PlannedLabel> places;
    for (const PlannedLabel& label : labels) {
        const auto stands_there = [&](const PlannedLabel& other) {
            return other.parts.size() < most_joined && other.word.role == label.word.role &&
                   other.request.priority == label.request.priority &&
                   std::abs(other.request.anchor.x - label.request.anchor.x) <= px(one_place) &&
                   std::abs(other.request.anchor.y - label.request.anchor.y) <= px(one_place);
        };
        const auto same = std::ranges::find_if(places, stands_there);
        if (same == places.end()) {
            places.push_back(label);
            places.back().parts = {label};
            continue;
        }
        same->parts.push_back(label);
        if (label.word.text != same->word.text)
            same->word.text = same->word.text + Text(", ") + label.word.text;
        same->request.clearance = std::max(same->request.clearance, label.request.clearance);
    }
    return places;
}

std::vector<Overlay::PlannedLabel> Overlay::paint_where_free(const std::vector<PlannedLabel>& labels,
                                                             const std::vector<ScreenRect>& anchors,
                                                             std::vector<ScreenLine>& drawn) {
    std::vector<LabelRequest> requests;
    for (const PlannedLabel& label : labels) {
        const TextMask& mask = mask_of(label.word);
        requests.push_back(label.request);
        requests.back().width = mask.letters.width + px(2);
        requests.back().height = mask.letters.height;
    }
    std::vector<ScreenRect> taken = taken_;
    taken.insert(taken.end(), anchors.begin(), anchors.end());
    const auto placed = place_labels(requests, whole(), std::move(taken), drawn);
    std::vector<PlannedLabel> without_room;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        if (!placed[i]) {
            without_room.push_back(labels[i]);
            continue;
        }
        // Without a place of its own it is read on a ground, as the legend.
        if (std::ranges::any_of(drawn, [&](const ScreenLine& line) { return line.crosses(*placed[i]); }))
            canvas_.rectangle(*placed[i], ground_top(view_.palette), ground_opacity);
        if (const auto leader = leader_of(requests[i], *placed[i])) {
            canvas_.line(leader->from, leader->to, px(0.9), colour(Role::quiet_text), 0.8);
            drawn.push_back(*leader);
        }
        write(labels[i].word, placed[i]->x + px(1), placed[i]->y);
        taken_.push_back(placed[i]->grown(px(gap), 0.0));
    }
    return without_room;
}

void Overlay::paint_labels() {
    std::vector<PlannedLabel> labels;
    std::vector<ScreenRect> anchors;
    for (const SceneLabel& label : scene_.labels) {
        labels.push_back(planned(label));
        const double scale = metres_per_pixel(view_.camera, canvas_.size(), label.at);
        const double half = 0.6 * label.clearance / scale + px(1);
        const Pixel at = labels.back().request.anchor;
        anchors.push_back(square_about(at, half));
    }
    for (const SceneVerdict& mark : scene_.not_met) {
        if (!view_.layers[mark.layer]) continue;
        const double half = half_of_diamond(mark) + px(2);
        const Pixel at = pixel_of(mark.at);
        anchors.push_back(square_about(at, half));
        for (PlannedLabel& label : labels)
            if (std::hypot(label.request.anchor.x - at.x, label.request.anchor.y - at.y) < half)
                label.request.clearance = std::max(label.request.clearance, half);
    }
    std::vector<ScreenLine> drawn = what_labels_avoid();
    // A joined label without room comes apart: some of its parts may have some.
    std::vector<PlannedLabel> apart;
    for (const PlannedLabel& label : paint_where_free(joined(labels), anchors, drawn))
        if (label.parts.size() > 1) apart.insert(apart.end(), label.parts.begin(), label.parts.end());
    paint_where_free(apart, anchors, drawn);
}

}  // namespace covaria::detail
