#include "core/kinds/network/adjusted_space_start.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/math/decompositions.h"
#include "core/math/plane_of_points.h"
#include "core/math/points_from_distances.h"

namespace covaria::network {

namespace {

class PlacingBySlopes {
public:
    PlacingBySlopes(AdjustedNetwork& network, Placing& placing, const std::vector<char>& wanted)
        : network_(network), placing_(placing), ties_(network.points.size()) {
        for (std::size_t p = 0; p < ties_.size(); ++p) {
            places_.push_back(placing.is_in_space(p));
            wants_.push_back(wanted[p] && !places_[p]);
        }
        for (std::size_t i = 0; i < network.readings.size(); ++i) {
            const AdjustedReading& r = network.readings[i];
            if (r.kind != ReadingKind::slope_distance) continue;
            for (const auto& [p, other] : {std::pair(r.from, r.to), std::pair(r.to, r.from)})
                if (wants_[p] && (places_[other] || wants_[other])) ties_[p].push_back({i, other});
        }
    }

    bool place() {
        bool any = false;
        // One tie more than coordinates leaves one place, unless all are to places in a plane; as many leave
        // two, images of each other.
        while (place_singly(1) || place_core(1) || place_singly(0) || place_core(0)) any = true;
        return any;
    }

private:
    struct Tie {
        std::size_t reading = 0, other = 0;
    };

    /// The coordinates of a point that are not fixed.
    std::size_t coordinates(std::size_t p) const {
        return static_cast<std::size_t>(std::ranges::count_if(
            network_.points[p].role, [](CoordinateRole role) { return role != CoordinateRole::fixed; }));
    }

    /// Places points by distances to places, of which each has so many more than coordinates.
    bool place_singly(std::size_t more) {
        bool any = false;
        for (std::size_t p = 0; p < ties_.size(); ++p) {
            if (!wants_[p]) continue;
            std::vector<Eigen::Vector3d> others;
            bool waits = false;
            for (const Tie& tie : ties_[p]) {
                if (places_[tie.other]) others.push_back(network_.position(tie.other));
                waits = waits || wants_[tie.other];
            }
            // One that others wait for is placed with them where its own distances leave two places.
            const bool leaves_two = others.size() <= coordinates(p) || plane_of(others).is_flat;
            if (others.size() < coordinates(p) || (waits && more > 0 && leaves_two)) continue;
            place_jointly({p});
            any = true;
        }
        return any;
    }

    /// Points not placed yet that distances tie to each other and to places most often, each by so many more
    /// than its coordinates.
    std::vector<std::size_t> core(std::size_t more) const {
        constexpr std::size_t most_points = 20;
        std::vector<std::size_t> found, count(ties_.size(), 0);
        std::vector<char> in_core(ties_.size(), 0);
        for (std::size_t p = 0; p < ties_.size(); ++p)
            for (const Tie& tie : ties_[p]) count[p] += wants_[p] && places_[tie.other];
        while (found.size() < most_points) {
            std::size_t best = none;
            const auto rank = [&](std::size_t p) { return std::pair(count[p], ties_[p].size()); };
            for (std::size_t p = 0; p < ties_.size(); ++p)
                if (wants_[p] && !in_core[p] && ties_[p].size() >= coordinates(p) + more &&
                    (best == none || rank(p) > rank(best)))
                    best = p;
            if (best == none || (!found.empty() && count[best] == 0)) break;
            found.push_back(best);
            in_core[best] = 1;
            for (const Tie& tie : ties_[best]) ++count[tie.other];
        }
        return well_tied(found, in_core, more);
    }

    std::vector<std::size_t> well_tied(std::vector<std::size_t> core, std::vector<char>& in_core,
                                       std::size_t more) const {
        const auto is_loose = [&](std::size_t p) {
            const auto ties = std::ranges::count_if(
                ties_[p], [&](const Tie& tie) { return places_[tie.other] || in_core[tie.other]; });
            return static_cast<std::size_t>(ties) < coordinates(p) + more;
        };
        for (;;) {
            const auto loose = std::ranges::find_if(core, is_loose);
            if (loose == core.end()) return core;
            in_core[*loose] = 0;
            core.erase(loose);
        }
    }

    bool place_core(std::size_t more) {
        const std::vector<std::size_t> points = core(more);
        if (points.empty()) return false;
        place_jointly(points);
        return true;
    }

    void place_jointly(const std::vector<std::size_t>& points) {
        PointsAndDistances given;
        std::vector<std::size_t> number(ties_.size(), none);
        const auto add = [&](std::size_t p) {
            if (number[p] != none) return;
            number[p] = given.places.size();
            given.places.push_back(network_.position(p));
            given.holds.push_back({true, true, true});
            for (std::size_t c = 0; c < 3; ++c)
                given.holds.back()[c] = places_[p] || network_.points[p].role[c] == CoordinateRole::fixed;
        };
        for (const std::size_t p : points) add(p);
        std::size_t held = 0;
        for (const std::size_t p : points)
            for (const Tie& tie : ties_[p]) {
                if (!places_[tie.other] && number[tie.other] == none) continue;
                if (!places_[tie.other] && tie.other < p) continue;  // taken from there
                held += places_[tie.other];
                add(tie.other);
                const AdjustedReading& r = network_.readings[tie.reading];
                given.distances.push_back(
                    {number[r.from], number[r.to], r.value, r.u, r.height_to - r.height_from});
            }
        PointsByDistances found = points_from_distances(given);
        if (held == 0) lay_as_stated(points, found.places);
        for (std::size_t i = 0; i < points.size(); ++i) {
            placing_.put(points[i], found.places[i]);
            places_[points[i]] = 1;
            wants_[points[i]] = 0;
        }
    }

    /// Lays points that nothing ties to others, or their mirror image, onto what was stated of them.
    void lay_as_stated(const std::vector<std::size_t>& points, std::vector<Eigen::Vector3d>& places) const {
        Eigen::Matrix3Xd here(3, 0), there(3, 0);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const AdjustedPoint& point = network_.points[points[i]];
            if (!point.is_typed()) continue;
            here.conservativeResize(Eigen::NoChange, here.cols() + 1);
            there.conservativeResize(Eigen::NoChange, there.cols() + 1);
            here.rightCols<1>() = Eigen::Vector3d(*point.typed[0], *point.typed[1], *point.typed[2]);
            there.rightCols<1>() = places[i];
        }
        if (here.cols() < 3) return;
        const Eigen::Vector3d middle_here = here.rowwise().mean(), middle_there = there.rowwise().mean();
        here.colwise() -= middle_here;
        there.colwise() -= middle_there;
        const auto svd = singular_values(Eigen::Matrix3d(here * there.transpose()),
                                         Eigen::ComputeFullU | Eigen::ComputeFullV);
        const Eigen::Matrix3d R = svd.matrixU() * svd.matrixV().transpose();  // or a reflection
        for (Eigen::Vector3d& place : places) place = middle_here + R * (place - middle_there);
    }

    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    AdjustedNetwork& network_;
    Placing& placing_;
    std::vector<char> places_, wants_;  ///< whether each point has a place, or is to get one
    std::vector<std::vector<Tie>> ties_;
};

}  // namespace

std::vector<char> tied_by_slopes_alone(const AdjustedNetwork& network) {
    std::vector<char> alone, read(network.points.size(), 0);
    for (const AdjustedPoint& point : network.points)
        alone.push_back(point.has(0) && point.has(1) && point.has(2));
    for (const AdjustedReading& r : network.readings) {
        if (!is_read(r.kind)) continue;
        for (const std::size_t p : {r.from, r.to, r.second}) {
            read[p] = 1;
            alone[p] = alone[p] && r.kind == ReadingKind::slope_distance;
        }
    }
    for (std::size_t p = 0; p < alone.size(); ++p) alone[p] = alone[p] && read[p];
    return alone;
}

bool lay_anew_in_space(AdjustedNetwork& network) {
    std::vector<char> wanted = tied_by_slopes_alone(network);
    AdjustedNetwork laid = network;
    bool any = false;
    for (std::size_t p = 0; p < wanted.size(); ++p) {
        wanted[p] = wanted[p] && std::ranges::any_of(std::array{0, 1, 2}, [&](std::size_t c) {
                        return network.points[p].is_found(c);
                    });
        any = any || wanted[p];
        laid.points[p].placed.fill(!wanted[p]);
    }
    if (!any) return false;
    Placing placing(laid, {std::vector<std::optional<Eigen::Vector2d>>(wanted.size()), {}});
    if (!place_by_slopes(laid, placing, wanted)) return false;
    network.state = laid.state;
    return true;
}

bool place_by_slopes(AdjustedNetwork& network, Placing& placing, const std::vector<char>& wanted) {
    return PlacingBySlopes(network, placing, wanted).place();
}

}  // namespace covaria::network
