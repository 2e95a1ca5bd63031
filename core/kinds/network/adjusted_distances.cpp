// Loops of distances before the adjustment: triangles, six distances between four points of a plane, ten
// between five in space.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/kinds/network/closure_sums.h"

namespace covaria::network {

namespace {

/// A point in the axes of a base of two or three others: along the base, across it in the plane of the base,
/// and the distance from that plane.
struct OnBase {
    double along = 0.0, across = 0.0, beyond = 0.0;
};

/// Distances of one kind between points, each the first that was read of the pair.
class DistanceLoops {
public:
    DistanceLoops(ClosureSums& sums, ReadingKind kind)
        : sums_(sums), network_(sums.network), kind_(kind), neighbours_(network_.points.size()) {
        for (std::size_t i = 0; i < network_.readings.size(); ++i) {
            const AdjustedReading& r = network_.readings[i];
            const bool known = std::ranges::none_of(r.figures, [&](std::size_t f) {
                return network_.figures[f].is_found && sums_.stated(f) == ClosureSums::none;
            });
            const bool raised =
                kind == ReadingKind::slope_distance && (r.height_from != 0.0 || r.height_to != 0.0);
            if (r.kind != kind || !known || raised ||
                !between_.try_emplace(std::minmax(r.from, r.to), i).second)
                continue;
            neighbours_[r.from].push_back(r.to);
            neighbours_[r.to].push_back(r.from);
        }
        for (std::vector<std::size_t>& of : neighbours_) std::ranges::sort(of);
        for (const AdjustedReading& r : network_.readings)
            if (is_in_frame(r.kind) && network_.frames[r.frame].shape == FrameShape::line)
                line_of_.try_emplace(r.from, r.frame);
    }

    void close() {
        for (const auto& [pair, reading] : between_) {
            const std::vector<std::size_t> common = common_neighbours(pair.first, pair.second);
            close_triangle(pair.first, pair.second, common);
            kind_ == ReadingKind::slope_distance ? close_in_space(pair.first, pair.second, common)
                                                 : close_in_plane(pair.first, pair.second, common);
        }
    }

private:
    using Values = ClosureSums::Values;

    std::vector<std::size_t> common_neighbours(std::size_t a, std::size_t b) const {
        std::vector<std::size_t> common;
        std::ranges::set_intersection(neighbours_[a], neighbours_[b], std::back_inserter(common));
        return common;
    }

    std::optional<std::size_t> reading(std::size_t a, std::size_t b) const {
        const auto found = between_.find(std::minmax(a, b));
        return found == between_.end() ? std::nullopt : std::optional(found->second);
    }

    /// The distance of two points without zero and scale of the instrument.
    double distance(const Values& values, std::size_t a, std::size_t b) const {
        const std::size_t i = *reading(a, b);
        double zero = 0.0, scale = 1.0;
        for (const std::size_t f : network_.readings[i].figures) {
            const double figure = sums_.stated(f) != ClosureSums::none
                                      ? values[sums_.stated(f)]
                                      : network_.state[static_cast<Eigen::Index>(network_.figure(f))];
            (network_.figures[f].kind == FigureKind::zero ? zero : scale) += figure;
        }
        return (values[i] - zero) / scale;
    }

    std::string names(const std::vector<std::size_t>& points) const {
        std::string all;
        for (const std::size_t p : points) all += (all.empty() ? "" : " – ") + network_.points[p].name;
        return all;
    }

    /// All readings between the points, and what states the figures of their instruments; that between the
    /// last two comes last.
    std::vector<std::size_t> used(const std::vector<std::size_t>& points) const {
        std::vector<std::size_t> of_figures, all;
        for (std::size_t k = 1; k < points.size(); ++k)
            for (std::size_t i = 0; i < k; ++i) all.push_back(*reading(points[i], points[k]));
        for (const std::size_t i : all)
            for (const std::size_t f : network_.readings[i].figures)
                if (const std::size_t stated = sums_.stated(f);
                    stated != ClosureSums::none && std::ranges::find(of_figures, stated) == of_figures.end())
                    of_figures.push_back(stated);
        all.insert(all.begin(), of_figures.begin(), of_figures.end());
        return all;
    }

    bool on_one_line(std::size_t a, std::size_t b, std::size_t c) const {
        const auto of_a = line_of_.find(a), of_b = line_of_.find(b), of_c = line_of_.find(c);
        return of_a != line_of_.end() && of_b != line_of_.end() && of_c != line_of_.end() &&
               of_a->second == of_b->second && of_a->second == of_c->second;
    }

    /// Closes the way from a to b over the point between them that misses most. A way that is longer is no
    /// contradiction unless the three are on a line of the set-up.
    void close_triangle(std::size_t a, std::size_t b, const std::vector<std::size_t>& common) {
        const Values& values = sums_.values();
        std::size_t worst = network_.points.size();
        double most = 0.0;
        for (const std::size_t p : common) {
            const double whole = distance(values, a, b), first = distance(values, a, p),
                         second = distance(values, p, b);
            const bool straight = on_one_line(a, p, b) && first < whole && second < whole;
            const double misses = whole - first - second;
            if (!(straight || misses > 0.0) || std::abs(misses) < most) continue;
            most = std::abs(misses);
            worst = p;
        }
        if (worst == network_.points.size()) return;
        sums_.add(tell<"loop of distances, %1">(names({a, worst, b})), used({worst, a, b}),
                  [=, this](const Values& v) {
                      return distance(v, a, b) - distance(v, a, worst) - distance(v, worst, b);
                  });
    }

    OnBase on_base(const Values& values, const std::vector<std::size_t>& base, std::size_t p) const {
        const double length = distance(values, base[0], base[1]), a = distance(values, base[0], p),
                     b = distance(values, base[1], p);
        OnBase at{(a * a - b * b + length * length) / (2.0 * length), 0.0, 0.0};
        const double off = a * a - at.along * at.along;
        at.across = std::sqrt(off);
        if (base.size() < 3 || p == base[2]) return at;
        const OnBase third = on_base(values, {base[0], base[1]}, base[2]);
        const double c = distance(values, base[2], p), along = at.along - third.along;
        at.across = (off - c * c + third.across * third.across + along * along) / (2.0 * third.across);
        at.beyond = std::sqrt(off - at.across * at.across);
        return at;
    }

    /// The distance of c and d less what their distances from the base make of it, on the same side of it or
    /// on the other, as fits better.
    double misses(const Values& values, const std::vector<std::size_t>& base, std::size_t c,
                  std::size_t d) const {
        OnBase p = on_base(values, base, c), q = on_base(values, base, d);
        const double read = distance(values, c, d);
        double& side = base.size() < 3 ? q.across : q.beyond;
        const auto miss = [&] {
            return read - std::hypot(p.along - q.along, p.across - q.across, p.beyond - q.beyond);
        };
        const double same = miss();
        side = -side;
        const double other = miss();
        return std::abs(same) < std::abs(other) ? same : other;
    }

    /// How far from degenerate the base is for a point: the least of the heights over it.
    double quality(const Values& values, const std::vector<std::size_t>& base, std::size_t p) const {
        const OnBase at = on_base(values, base, p);
        const double height = base.size() < 3 ? at.across : at.beyond;
        return std::isfinite(height) ? height : 0.0;
    }

    void close_over(const std::vector<std::vector<std::size_t>>& bases, std::size_t c, std::size_t d) {
        const Values& values = sums_.values();
        const std::vector<std::size_t>* best = nullptr;
        double most = 0.0;
        for (const std::vector<std::size_t>& base : bases) {
            const double q = std::min(quality(values, base, c), quality(values, base, d));
            if (!(q > most)) continue;
            most = q;
            best = &base;
        }
        if (!best) return;
        std::vector<std::size_t> points = *best;
        points.insert(points.end(), {c, d});
        sums_.add(tell<"loop of distances, %1">(names(points)), used(points),
                  [=, this, base = *best](const Values& v) { return misses(v, base, c, d); });
    }

    static constexpr std::size_t most_tried = 6;  ///< points among which a base is looked for

    void close_in_plane(std::size_t c, std::size_t d, const std::vector<std::size_t>& common) {
        std::vector<std::vector<std::size_t>> bases;
        const std::size_t n = std::min(common.size(), most_tried);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = i + 1; k < n; ++k)
                if (reading(common[i], common[k])) bases.push_back({common[i], common[k]});
        close_over(bases, c, d);
    }

    void close_in_space(std::size_t c, std::size_t d, const std::vector<std::size_t>& common) {
        std::vector<std::vector<std::size_t>> bases;
        const std::size_t n = std::min(common.size(), most_tried);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = i + 1; k < n; ++k)
                for (std::size_t m = k + 1; m < n; ++m)
                    if (reading(common[i], common[k]) && reading(common[i], common[m]) &&
                        reading(common[k], common[m]))
                        bases.push_back({common[i], common[k], common[m]});
        close_over(bases, c, d);
    }

    ClosureSums& sums_;
    const AdjustedNetwork& network_;
    ReadingKind kind_;
    std::vector<std::vector<std::size_t>> neighbours_;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> between_;
    std::map<std::size_t, std::size_t> line_of_;
};

}  // namespace

void close_distances(ClosureSums& sums) {
    constexpr std::size_t most_closed = 5000;
    if (sums.network.readings.size() > most_closed) return;
    for (const ReadingKind kind : {ReadingKind::slope_distance, ReadingKind::horizontal_distance})
        DistanceLoops(sums, kind).close();
}

}  // namespace covaria::network
