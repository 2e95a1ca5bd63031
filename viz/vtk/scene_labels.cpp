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
constexpr double line_gap = 2.0;         // points, from a name to its fact
constexpr double gap = 5.0;              // points, from a label to the next
constexpr double shaft_of_frame = 0.03;  // part of its length, with half of its tip

}  // namespace

ScreenLine Overlay::line_of(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) const {
    const double scale = metres_per_pixel(view_.camera, canvas_.size(), (from + to) / 2);
    return {pixel_of(from), pixel_of(to), std::max(radius / scale, px(thinnest))};
}

std::vector<ScreenLine> Overlay::bodies() const {
    std::vector<ScreenLine> drawn;
    const auto add = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
        const ScreenLine line = line_of(from, to, radius);
        if (std::isfinite(line.from.x + line.from.y + line.to.x + line.to.y + line.half_width))
            drawn.push_back(line);
    };
    const auto add_all = [&](Layer layer, const std::vector<Solid>& solids) {
        if (!view_.layers[layer]) return;
        for (const Solid& solid : solids) {
            if (solid.shape == Solid::Shape::frustum)
                add(solid.from, solid.to, 0.8 * std::max(solid.from_radius, solid.to_radius));
            if (solid.shape == Solid::Shape::box) add(solid.from, solid.from, 0.4 * solid.edges.maxCoeff());
            if (solid.shape != Solid::Shape::prism || solid.opacity < 1.0) continue;
            for (std::size_t i = 0; i < solid.outline.size(); ++i)
                add(solid.outline[i], solid.outline[(i + 1) % solid.outline.size()], solid.thickness / 2);
        }
    };
    add_all(Layer::bodies, solids_of_bodies(scene_));
    add_all(Layer::links, solids_of_links(scene_));
    add_all(Layer::points, solids_of_points(scene_));
    return drawn;
}

std::vector<ScreenLine> Overlay::what_labels_avoid() const {
    std::vector<ScreenLine> drawn;
    const auto add = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
        const ScreenLine line = line_of(from, to, radius);
        if (std::isfinite(line.from.x + line.from.y + line.to.x + line.to.y + line.half_width))
            drawn.push_back(line);
    };
    if (view_.layers[Layer::links])
        for (const SceneLink& link : scene_.links)
            if (!(link.radius > 0)) add(link.from, link.to, 0.0);
    if (view_.layers[Layer::bodies])
        for (const SceneBody& body : scene_.bodies)  // a plate is written on where there is no other room
            if (!body.outline.empty()) add(body.item.position, body.item.position, body.thickness);
    if (view_.layers[Layer::vectors])
        for (const SceneVector& vector : scene_.vectors)
            add(vector.item.position, vector.item.position + vector.arrow, vector.radius);
    if (view_.layers[Layer::frames])
        for (const SceneFrame& frame : scene_.frames)
            for (int i = 0; i < 3 && shows(frame); ++i)
                add(frame.item.position, frame.item.position + frame.length * frame.R_WF.col(i),
                    shaft_of_frame * frame.length);
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

bool Overlay::is_written(const SceneLabel& label) const {
    if (!label.when_asked || is_asked_for(label.item)) return true;
    if (!view_.layers[Layer::frames]) return false;
    const auto frame = std::ranges::find_if(
        scene_.frames, [&](const SceneFrame& each) { return each.item.id == label.item; });
    return frame != scene_.frames.end() && is_of_asked(*frame);
}

Overlay::PlannedLabel Overlay::planned(const SceneLabel& label) const {
    const bool is_selected = is_asked_for(label.item);
    const double scale = metres_per_pixel(view_.camera, canvas_.size(), label.at);
    const bool is_name = label.role == Role::text;
    PlannedLabel made{{label.text, label.role, is_name, 1.0},
                      {label.fact, Role::quiet_text, false, 1.0},
                      {.anchor = pixel_of(label.at)},
                      {}};
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
        same->fact.text = {};
        same->request.clearance = std::max(same->request.clearance, label.request.clearance);
    }
    return places;
}

std::vector<Overlay::PlannedLabel> Overlay::paint_where_free(const std::vector<PlannedLabel>& labels,
                                                             const std::vector<ScreenRect>& anchors,
                                                             const std::vector<ScreenLine>& bodies,
                                                             std::vector<ScreenLine>& drawn) {
    std::vector<LabelRequest> requests;
    for (const PlannedLabel& label : labels) {
        const TextMask& mask = mask_of(label.word);
        requests.push_back(label.request);
        requests.back().width = mask.letters.width + px(2);
        requests.back().height = mask.letters.height;
        if (label.fact.text.empty()) continue;
        const Mask& fact = mask_of(label.fact).letters;
        requests.back().width = std::max(requests.back().width, fact.width + px(2));
        requests.back().height += px(line_gap) + fact.height;
    }
    std::vector<ScreenRect> taken = taken_;
    taken.insert(taken.end(), anchors.begin(), anchors.end());
    const auto placed = place_labels(requests, whole(), std::move(taken), drawn, bodies);
    std::vector<PlannedLabel> without_room;
    for (std::size_t i = 0; i < placed.size(); ++i) {
        if (!placed[i]) {
            without_room.push_back(labels[i]);
            continue;
        }
        // A label that crosses lines is read on a ground, as the legend.
        if (std::ranges::any_of(drawn, [&](const ScreenLine& line) { return line.crosses(*placed[i]); }))
            canvas_.rectangle(*placed[i], ground_colour(view_.palette), ground_opacity);
        if (const auto leader = leader_of(requests[i], *placed[i])) {
            canvas_.line(leader->from, leader->to, px(1.0), colour(Role::quiet_text), 0.7);
            drawn.push_back(*leader);
        }
        write(labels[i].word, placed[i]->x + px(1), placed[i]->y);
        placed_.back().is_label = true;
        if (!labels[i].fact.text.empty())
            write(labels[i].fact, placed[i]->x + px(1),
                  placed[i]->y + mask_of(labels[i].word).letters.height + px(line_gap));
        placed_.back().is_label = true;
        taken_.push_back(placed[i]->grown(px(gap), 0.0));
    }
    return without_room;
}

void Overlay::paint_labels() {
    std::vector<PlannedLabel> labels;
    std::vector<ScreenRect> anchors;
    for (const SceneLabel& label : scene_.labels) {
        if (!is_written(label)) continue;
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
    const std::vector<ScreenLine> solid = bodies();
    // A joined label without room comes apart: some of its parts may have some.
    std::vector<PlannedLabel> apart;
    for (const PlannedLabel& label : paint_where_free(joined(labels), anchors, solid, drawn))
        if (label.parts.size() > 1) apart.insert(apart.end(), label.parts.begin(), label.parts.end());
    paint_where_free(apart, anchors, solid, drawn);
}

}  // namespace covaria::detail
