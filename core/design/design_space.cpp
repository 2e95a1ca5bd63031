#include "core/design/design_space.h"

#include <algorithm>
#include <tuple>

#include "core/base/guarded.h"
#include "core/design/search.h"

namespace covaria::detail {

namespace {

constexpr std::size_t most_tracks = 12;
constexpr std::size_t most_followed = 300;        ///< most steps shown of a path
constexpr std::size_t most_region_variables = 3;  ///< most variables that have a box to be drawn
constexpr double same_spot = 1e-9;                ///< m

/// Takes the sources out: where rows have moved up, a source would be another row's.
void forget_sources(Layout& layout) {
    for (LayoutFrame& frame : layout.frames) frame.source = {};
    for (LayoutPoint& point : layout.points) point.source = {};
    for (LayoutBody& body : layout.bodies) body.source = {};
}

std::vector<std::size_t> with(std::vector<std::size_t> rows, std::size_t row) {
    rows.insert(std::lower_bound(rows.begin(), rows.end(), row), row);
    return rows;
}

std::vector<std::size_t> without(std::vector<std::size_t> rows, std::size_t row) {
    std::erase(rows, row);
    return rows;
}

/// The first of `all` that `others` have not, each counted once. A thing that stands elsewhere there under
/// the same name was moved, as a point that is computed from all rows: it is not new.
template <class Stand>
std::optional<Eigen::Vector3d> first_more(const std::vector<Stand>& all, const std::vector<Stand>& others) {
    const auto key = [](const Stand& s) { return std::tuple(s.rank, s.p_W.x(), s.p_W.y(), s.p_W.z()); };
    const auto before = [&](const Stand& a, const Stand& b) { return key(a) < key(b); };
    std::vector<Stand> here = all, there = others, more, less;
    std::stable_sort(here.begin(), here.end(), before);
    std::stable_sort(there.begin(), there.end(), before);
    std::set_difference(here.begin(), here.end(), there.begin(), there.end(), std::back_inserter(more),
                        before);
    std::set_difference(there.begin(), there.end(), here.begin(), here.end(), std::back_inserter(less),
                        before);
    for (const Stand& stand : more) {
        const auto moved = std::find_if(less.begin(), less.end(), [&](const Stand& other) {
            return other.rank == stand.rank && other.name == stand.name;
        });
        if (moved == less.end()) return stand.p_W;
        less.erase(moved);
    }
    return {};
}

/// Steps of a path, at most `most_followed`, evenly, with the last.
std::vector<const DesignStep*> thinned(const std::vector<DesignStep>& steps) {
    std::vector<const DesignStep*> some;
    const std::size_t stride = steps.size() / most_followed + 1;
    for (std::size_t i = 0; i < steps.size(); ++i)
        if ((steps.size() - 1 - i) % stride == 0) some.push_back(&steps[i]);
    return some;
}

}  // namespace

DesignSpace::DesignSpace(CandidateJudge& judge, const PreparedDesign& design, Candidate chosen,
                         std::stop_token stop)
    : judge_(judge), design_(design), chosen_(std::move(chosen)), stop_(std::move(stop)) {
    stands_ = stands_of(chosen_);
}

std::optional<Layout> DesignSpace::layout_of(const Candidate& candidate) {
    if (stop_.stop_requested()) throw Stopped{};
    auto layout = guarded([&]() -> std::optional<Layout> {
        const auto changed = judge_.model_of(candidate);
        if (!changed) return {};
        return changed->model().layout(estimates_of(changed->inputs));
    });
    return layout ? *std::move(layout) : std::nullopt;
}

std::vector<DesignSpace::Stand> DesignSpace::stands_of(const Candidate& candidate) {
    std::vector<Stand> stands;
    const std::optional<Layout> layout = layout_of(candidate);
    if (!layout) return stands;
    const auto add = [&](int rank, const std::string& name, const Eigen::Vector3d& p_W) {
        if (p_W.allFinite()) stands.push_back({rank, name, p_W});
    };
    for (const LayoutBody& body : layout->bodies)
        if (body.kind == BodyKind::instrument) add(0, body.name, body.X_WB.translation());
    for (const LayoutPoint& point : layout->points)
        add(point.kind == PointKind::station ? 0 : 1, point.name, point.p_W);
    for (const LayoutFrame& frame : layout->frames) add(2, frame.name, frame.X_WF.translation());
    return stands;
}

std::vector<std::optional<Eigen::Vector3d>> DesignSpace::places_of_rows() {
    std::vector<std::optional<Eigen::Vector3d>> places;
    for (std::size_t row = 0; row < design_.table->rows.rows.size(); ++row) {
        if (std::binary_search(chosen_.rows.begin(), chosen_.rows.end(), row))
            places.push_back(place_of_kept(row));
        else
            places.push_back(first_more(stands_of({chosen_.values, with(chosen_.rows, row)}), stands_));
    }
    return places;
}

/// Place of a row that was kept; where it cannot be left out, another stands in for it.
std::optional<Eigen::Vector3d> DesignSpace::place_of_kept(std::size_t row) {
    const std::vector<std::size_t> others = without(chosen_.rows, row);
    std::vector<Stand> left;
    if (!others.empty()) left = stands_of({chosen_.values, others});
    for (std::size_t other = 0; left.empty() && other < design_.table->rows.rows.size(); ++other)
        if (!std::binary_search(chosen_.rows.begin(), chosen_.rows.end(), other))
            left = stands_of({chosen_.values, with(others, other)});
    return left.empty() ? std::nullopt : first_more(stands_, left);
}

Candidate DesignSpace::chosen_with(std::size_t variable, double value) const {
    Candidate candidate = chosen_;
    candidate.values[variable] = value;
    return candidate;
}

/// Layouts of the same rows list the same things in the same order.
void DesignSpace::find_moves() {
    for (std::size_t i = 0; i < design_.design.variables.size(); ++i) {
        const StudyAxis& axis = design_.numbers.axes[i];
        std::vector<bool> moved(stands_.size(), false);
        for (const double end : {axis.from, axis.to}) {
            const std::vector<Stand> there = stands_of(chosen_with(i, end));
            for (std::size_t s = 0; s < stands_.size() && there.size() == stands_.size(); ++s)
                moved[s] = moved[s] || (there[s].p_W - stands_[s].p_W).norm() > same_spot;
        }
        moves_.push_back(std::move(moved));
    }
}

std::vector<std::size_t> DesignSpace::moving(std::size_t stand) const {
    std::vector<std::size_t> variables;
    for (std::size_t i = 0; i < moves_.size(); ++i)
        if (moves_[i][stand]) variables.push_back(i);
    return variables;
}

std::vector<Eigen::Vector3d> DesignSpace::region_of(std::size_t stand) {
    const std::vector<std::size_t> variables = moving(stand);
    std::vector<Eigen::Vector3d> corners;
    if (variables.size() > most_region_variables) return corners;
    for (std::size_t corner = 0; corner < (std::size_t{1} << variables.size()); ++corner) {
        Candidate candidate = chosen_;
        for (std::size_t j = 0; j < variables.size(); ++j) {
            const StudyAxis& axis = design_.numbers.axes[variables[j]];
            candidate.values[variables[j]] = (corner >> j) & 1 ? axis.to : axis.from;
        }
        const std::vector<Stand> there = stands_of(candidate);
        if (there.size() != stands_.size()) return {};
        corners.push_back(there[stand].p_W);
    }
    return corners;
}

void DesignSpace::follow(const std::vector<DesignStep>& steps, std::vector<DesignTrack>& tracks,
                         const std::vector<std::size_t>& stands) {
    for (const DesignStep* step : thinned(steps)) {
        const std::vector<Stand> there = stands_of({step->values, chosen_.rows});
        if (there.size() != stands_.size()) continue;
        for (std::size_t t = 0; t < tracks.size(); ++t) {
            tracks[t].path.push_back(there[stands[t]].p_W);
            tracks[t].objectives.push_back(step->objective);
        }
    }
}

DesignPlaces DesignSpace::places(const std::vector<DesignStep>& steps) {
    DesignPlaces places;
    if (auto layout = layout_of(chosen_)) places.layout = *std::move(layout);
    forget_sources(places.layout);
    for (const auto* boxes : {&design_.design.keep_out, &design_.design.hidden_by})
        for (const DesignBox& box : *boxes) {
            DesignObstacle obstacle{box.name.empty() ? "box" : box.name};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                obstacle.low[static_cast<Eigen::Index>(axis)] = box.unit.to_si(box.from[axis]);
                obstacle.high[static_cast<Eigen::Index>(axis)] = box.unit.to_si(box.to[axis]);
            }
            places.obstacles.push_back(std::move(obstacle));
        }
    find_moves();
    std::vector<std::size_t> moved;
    int rank = 3;
    for (std::size_t s = 0; s < stands_.size(); ++s)
        if (!moving(s).empty()) rank = std::min(rank, stands_[s].rank);
    for (std::size_t s = 0; s < stands_.size() && moved.size() < most_tracks; ++s) {
        // A station has a body and a point.
        const bool twice = std::any_of(moved.begin(), moved.end(), [&](std::size_t other) {
            return (stands_[other].p_W - stands_[s].p_W).norm() <= same_spot;
        });
        if (stands_[s].rank == rank && !moving(s).empty() && !twice) moved.push_back(s);
    }
    const std::vector<Stand> before = stands_of({design_.present, chosen_.rows});
    for (const std::size_t s : moved) {
        DesignTrack track{stands_[s].name};
        if (before.size() == stands_.size()) track.before = before[s].p_W;
        track.chosen = stands_[s].p_W;
        track.region = region_of(s);
        places.tracks.push_back(std::move(track));
    }
    if (!moved.empty()) follow(steps, places.tracks, moved);
    return places;
}

}  // namespace covaria::detail
