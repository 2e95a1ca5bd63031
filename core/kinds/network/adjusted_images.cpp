#include "core/kinds/network/adjusted_images.h"

#include <algorithm>
#include <cmath>

#include "core/base/disjoint_sets.h"
#include "core/kinds/network/adjusted_space_start.h"
#include "core/math/plane_of_points.h"
#include "core/math/points_from_distances.h"
#include "core/text/numbers.h"

namespace covaria::network {

namespace {

/// Points that distances tie to others all about in a plane, or to none at all.
struct Mirrored {
    std::vector<std::size_t> points, others;
    PlaneOfPoints plane;
};

/// Places on the other side, as the distances draw them, and how much worse they fit.
struct Image {
    std::vector<Eigen::Vector3d> places;
    double more = 0.0;  ///< sum of squares less that of the places themselves
};

constexpr double excluded = 10.83;  ///< χ² of one degree of freedom at 0.1 %

class Mirrors {
public:
    explicit Mirrors(const AdjustedNetwork& network)
        : network_(network), alone_(tied_by_slopes_alone(network)), ties_(network.points.size()) {
        for (std::size_t p = 0; p < alone_.size(); ++p)
            for (std::size_t c = 0; c < 3; ++c) alone_[p] = alone_[p] && network.points[p].is_found(c);
        for (std::size_t i = 0; i < network.readings.size(); ++i)
            if (const AdjustedReading& r = network.readings[i]; r.kind == ReadingKind::slope_distance) {
                ties_[r.from].push_back(i);
                ties_[r.to].push_back(i);
            }
    }

    /// All groups first, then single points within them.
    std::vector<Mirrored> find() const {
        DisjointSets sets(alone_.size());
        for (const AdjustedReading& r : network_.readings)
            if (r.kind == ReadingKind::slope_distance && alone_[r.from] && alone_[r.to])
                sets.join(r.from, r.to);
        std::vector<std::vector<std::size_t>> groups(alone_.size());
        for (std::size_t p = 0; p < alone_.size(); ++p)
            if (alone_[p]) groups[sets.leader_of(p)].push_back(p);
        std::vector<Mirrored> found;
        for (const auto& group : groups)
            if (group.size() > 1) add(group, found);
        for (std::size_t p = 0; p < alone_.size(); ++p)
            if (alone_[p]) add({p}, found);
        return found;
    }

    /// The other side of the plane, near which the distances find their least sum.
    Image image_of(const Mirrored& m) const {
        PointsAndDistances given;
        std::vector<std::size_t> number(alone_.size(), 0);
        for (const std::vector<std::size_t>* points : {&m.points, &m.others})
            for (const std::size_t p : *points) {
                number[p] = given.places.size();
                given.places.push_back(network_.position(p));
                given.holds.emplace_back().fill(points == &m.others);
            }
        std::vector<std::size_t> readings;
        for (const std::size_t p : m.points)
            readings.insert(readings.end(), ties_[p].begin(), ties_[p].end());
        std::ranges::sort(readings);
        const auto twice = std::ranges::unique(readings);
        readings.erase(twice.begin(), twice.end());
        for (const std::size_t i : readings) {
            const AdjustedReading& r = network_.readings[i];
            // The figures of an instrument stay what they were found to be.
            const double length = r.value - predicted(network_, r, network_.state.data()) + length_of(r);
            given.distances.push_back(
                {number[r.from], number[r.to], length, r.u, r.height_to - r.height_from});
        }
        constexpr std::size_t most_moved = 60;
        const bool moves = m.points.size() <= most_moved;
        if (!moves)
            for (auto& holds : given.holds) holds.fill(true);
        const double own = nearest_by_distances(given).sum_of_squares;
        for (std::size_t i = 0; i < m.points.size(); ++i) given.places[i] = m.plane.image(given.places[i]);
        PointsByDistances found = nearest_by_distances(given);
        found.places.resize(m.points.size());
        return {std::move(found.places), found.sum_of_squares - own};
    }

    /// How much nearer what was typed of the points is to them than to the image: 1 at them, −1 at the image,
    /// 0 where nothing was typed, or nothing that tells the sides apart.
    double typed_side(const Mirrored& m, const Image& image) const {
        double to_own = 0.0, to_image = 0.0;
        for (std::size_t i = 0; i < m.points.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c)
                if (const auto& typed = network_.points[m.points[i]].typed[c]) {
                    const auto k = static_cast<Eigen::Index>(c);
                    to_own += std::pow(*typed - network_.position(m.points[i])[k], 2);
                    to_image += std::pow(*typed - image.places[i][k], 2);
                }
        return to_own + to_image > 0.0 ? (to_image - to_own) / (to_image + to_own) : 0.0;
    }

    /// The standard uncertainty of a point across a plane.
    double u_across(std::size_t p, const Eigen::Vector3d& normal) const {
        Eigen::VectorXd e = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(network_.place_of.size()));
        for (std::size_t c = 0; c < 3; ++c)
            e[static_cast<Eigen::Index>(network_.unknown_of[network_.at(p, c)])] =
                normal[static_cast<Eigen::Index>(c)];
        return std::sqrt(std::max(0.0, e.dot(network_.adjusted->cofactors(e))));
    }

private:
    double length_of(const AdjustedReading& r) const {
        return (network_.position(r.to) - network_.position(r.from) +
                (r.height_to - r.height_from) * Eigen::Vector3d::UnitZ())
            .norm();
    }

    void add(const std::vector<std::size_t>& points, std::vector<Mirrored>& found) const {
        Mirrored m{points, {}, {}};
        std::vector<char> seen(alone_.size(), 0);
        for (const std::size_t p : points) seen[p] = 1;
        for (const std::size_t p : points)
            for (const std::size_t i : ties_[p])
                for (const std::size_t other : {network_.readings[i].from, network_.readings[i].to})
                    if (!std::exchange(seen[other], 1)) m.others.push_back(other);
        std::vector<Eigen::Vector3d> places;
        for (const std::size_t p : m.others.empty() ? points : m.others)
            places.push_back(network_.position(p));
        if (places.size() < 3) return;
        m.plane = plane_of(places);
        if (m.plane.is_a_line || !(m.plane.is_flat || m.others.empty())) return;
        found.push_back(std::move(m));
    }

    const AdjustedNetwork& network_;
    std::vector<char> alone_;
    std::vector<std::vector<std::size_t>> ties_;
};

constexpr double clearly = 0.6;  ///< side of what was typed: twice as near

std::string names_of(const AdjustedNetwork& network, const std::vector<std::size_t>& points) {
    constexpr std::size_t most_named = 4;
    std::string names;
    for (std::size_t i = 0; i < std::min(points.size(), most_named); ++i)
        names += (i > 0 ? ", " : "") + network.points[points[i]].name;
    return points.size() > most_named ? names + ", …" : names;
}

double distance_from_plane(const AdjustedNetwork& network, const Mirrored& m) {
    double most = 0.0;
    for (const std::size_t p : m.points)
        most = std::max(most, std::abs(m.plane.normal.dot(network.position(p) - m.plane.middle)));
    return most;
}

Message words_of_image(const AdjustedNetwork& network, const Mirrored& m, const Image& image) {
    const std::string names = names_of(network, m.points);
    if (m.others.empty())
        return tell<
            "distances alone do not tell the network of %1 from its mirror image: state approximate "
            "coordinates of four of its points that are not all in a plane">(names);
    const std::string plane = names_of(network, m.others);
    if (m.points.size() > 1)
        return tell<
            "the distances fit as well where %1 are mirrored in the plane of %2: state an approximate "
            "coordinate that tells the side, or add a reading that does">(names, plane);
    const auto figure = [&](Eigen::Index c) {
        return Message::number(format_short(std::round(1e3 * image.places[0][c]) / 1e3, 9));
    };
    return tell<
        "the distances fit as well with %1 on the other side of the plane of %2, at (%3, %4, %5) m: "
        "state an approximate coordinate that tells the side, or add a reading that does">(
        names, plane, figure(0), figure(1), figure(2));
}

Message words_of_nearness(const AdjustedNetwork& network, const Mirrored& m, double u) {
    return tell<
        "%1 lies so near to the plane of %2 that the distances hardly tell how far from it: %3 m, with "
        "u = %4 m, which is no more than its order: add a reading to %1 from outside of the plane, or "
        "one of its height">(network.points[m.points[0]].name, names_of(network, m.others),
                             Message::number(format_significant(distance_from_plane(network, m), 2)),
                             Message::number(format_significant(u, 2)));
}

}  // namespace

void take_stated_sides(AdjustedNetwork& network) {
    const Mirrors mirrors(network);
    for (const Mirrored& m : mirrors.find()) {
        if (m.others.empty()) continue;
        const Image image = mirrors.image_of(m);
        const bool typed_there = mirrors.typed_side(m, image) < -clearly && image.more < excluded;
        if (!typed_there && !(image.more < -excluded)) continue;
        AdjustedNetwork there = network;
        for (std::size_t i = 0; i < m.points.size(); ++i)
            there.state.segment<3>(static_cast<Eigen::Index>(3 * m.points[i])) = image.places[i];
        there.adjusted = nullptr;
        Problems problems;
        adjust(there, problems);
        if (problems.has_errors()) continue;
        const double more = there.reliability.sum_of_squares - network.reliability.sum_of_squares;
        if (more < (typed_there ? excluded : 0.0)) network = std::move(there);
    }
}

void check_images(const AdjustedNetwork& network, Problems& problems) {
    constexpr std::size_t most_said = 3;
    constexpr double hardly = 3.0;  // u
    const Mirrors mirrors(network);
    std::size_t said = 0, first = 0;
    std::vector<char> of_group(network.points.size(), 0);
    const auto warn = [&](std::size_t p, Message words) {
        if (said++ == 0) first = p;
        if (said <= most_said)
            problems.warning(adjustment_fields().place(&StatedAdjustment::points, network.points[p].row),
                             std::move(words));
    };
    for (const Mirrored& m : mirrors.find()) {
        if (m.points.size() == 1 && of_group[m.points[0]]) continue;
        const Image image = mirrors.image_of(m);
        if (!(std::abs(image.more) < excluded)) continue;
        if (m.points.size() == 1)
            if (const double u = mirrors.u_across(m.points[0], m.plane.normal);
                distance_from_plane(network, m) < hardly * u) {
                warn(m.points[0], words_of_nearness(network, m, u));
                continue;
            }
        if (std::abs(mirrors.typed_side(m, image)) > clearly) continue;
        for (const std::size_t p : m.points) of_group[p] = 1;
        warn(m.points[0], words_of_image(network, m, image));
    }
    if (said > most_said)
        problems.warning(adjustment_fields().place(&StatedAdjustment::points, network.points[first].row),
                         tell<"and %1 more points with a mirror image that fits as well">(said - most_said));
}

bool put_into_planes(AdjustedNetwork& network) {
    constexpr double near = 0.1;  // of the extent of what it is tied to
    const Mirrors mirrors(network);
    bool any = false;
    for (const Mirrored& m : mirrors.find()) {
        if (m.points.size() > 1 || m.others.empty()) continue;
        double extent = 0.0;
        for (const std::size_t p : m.others)
            extent = std::max(extent, (network.position(p) - m.plane.middle).norm());
        const double from_plane = distance_from_plane(network, m);
        if (!(from_plane < near * extent)) continue;
        auto place = network.state.segment<3>(static_cast<Eigen::Index>(3 * m.points[0]));
        place -= m.plane.normal.dot(place - m.plane.middle) * m.plane.normal;
        any = true;
    }
    return any;
}

}  // namespace covaria::network
