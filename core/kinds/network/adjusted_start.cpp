// The start of the search of a network adjustment: points without coordinates are placed by the readings, in
// whatever order these stand; local frames are laid onto what is placed already.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/kinds/network/adjusted_space_start.h"

namespace covaria::network {

namespace {

using Vector2 = Eigen::Vector2d;

struct Sighting {
    std::size_t from = 0, to = 0, round = 0;
    double angle = 0.0;
};

bool put(PlaneFrame& frame, std::size_t point, std::size_t from, const Vector2& v) {
    if (frame.places[point] || !frame.places[from]) return false;
    frame.places[point] = *frame.places[from] + v;
    return true;
}

struct Ray {
    Vector2 from, along;
    std::size_t point;
};

bool intersect(PlaneFrame& frame, std::size_t p, const std::vector<Ray>& rays) {
    constexpr double least_sine = 0.02;
    double best = least_sine;
    for (std::size_t i = 0; i < rays.size(); ++i)
        for (std::size_t k = i + 1; k < rays.size(); ++k) {
            const Vector2 &a = rays[i].along, &b = rays[k].along;
            const double sine = a.x() * b.y() - a.y() * b.x();
            if (rays[i].point == rays[k].point || std::abs(sine) <= best) continue;
            const Vector2 v = rays[k].from - rays[i].from;
            best = std::abs(sine);
            frame.places[p] = rays[i].from + (v.x() * b.y() - v.y() * b.x()) / sine * a;
        }
    return frame.places[p].has_value();
}

/// Readings in the plane: directions in rounds (an angle is a round of two), azimuths in a round whose
/// orientation is 0, horizontal distances, differences of coordinates. Of the points `beyond` no plane knows
/// anything.
class PlaneReadings {
public:
    PlaneReadings(const AdjustedNetwork& network, const std::vector<char>& beyond)
        : network_(network), rounds_(network.rounds.size()), by_point_(network.points.size()) {
        if (std::ranges::none_of(network.points, [](const AdjustedPoint& p) {
                return p.has(0) && !(p.placed[0] && p.placed[1]);
            }))
            return;  // they place nothing
        std::map<std::pair<std::size_t, std::size_t>, double> zenith;
        for (const AdjustedReading& r : network.readings)
            if (r.kind == ReadingKind::zenith_angle) zenith.try_emplace({r.from, r.to}, r.value);
        std::map<std::pair<std::size_t, std::size_t>, Vector2> differences;
        std::map<std::pair<std::size_t, std::size_t>, int> halves;
        for (const AdjustedReading& r : network.readings) {
            take_angles(r);
            if (r.kind == ReadingKind::horizontal_distance) keep_distance(r.from, r.to, r.value);
            if (r.kind == ReadingKind::slope_distance && !beyond[r.from] && !beyond[r.to]) {
                const auto there = zenith.find({r.from, r.to}), back = zenith.find({r.to, r.from});
                const double sine = there != zenith.end()  ? std::sin(there->second)
                                    : back != zenith.end() ? std::sin(back->second)
                                                           : 1.0;
                keep_distance(r.from, r.to, r.value * sine);
            }
            if (r.kind != ReadingKind::dx && r.kind != ReadingKind::dy) continue;
            const std::pair pair(r.from, r.to);
            differences.try_emplace(pair, Vector2::Zero()).first->second[r.kind == ReadingKind::dx ? 0 : 1] =
                r.value;
            halves[pair] |= r.kind == ReadingKind::dx ? 1 : 2;
        }
        for (const auto& [pair, v] : differences)
            if (halves[pair] == 3) vectors_.push_back({pair.first, pair.second, v});
        for (const Sighting& s : sightings_)
            for (const std::size_t p : {s.from, s.to}) by_point_[p].push_back(s);
    }

    Vector2 along(double bearing) const {
        return network_.clockwise ? Vector2(std::sin(bearing), std::cos(bearing))
                                  : Vector2(std::cos(bearing), std::sin(bearing));
    }
    double bearing(const Vector2& v) const {
        return network_.clockwise ? std::atan2(v.x(), v.y()) : std::atan2(v.y(), v.x());
    }

    PlaneFrame empty_frame() const {
        return {std::vector<std::optional<Vector2>>(by_point_.size()),
                std::vector<std::optional<double>>(rounds_)};
    }
    std::size_t azimuths() const { return azimuth_round_; }
    const std::vector<Sighting>& sightings() const { return sightings_; }

    /// Places in the frame all points that follow from those that are placed.
    void propagate(PlaneFrame& frame) const {
        for (bool more = true; more;) {
            more = orient(frame);
            for (const auto& [from, to, v] : vectors_) {
                more = put(frame, to, from, v) || more;
                more = put(frame, from, to, Vector2(-v)) || more;
            }
            for (std::size_t p = 0; p < frame.places.size(); ++p)
                if (!frame.places[p]) more = place(frame, p) || more;
        }
    }

private:
    struct Difference {
        std::size_t from, to;
        Vector2 v;
    };

    void take_angles(const AdjustedReading& r) {
        if (r.kind == ReadingKind::direction) sightings_.push_back({r.from, r.to, r.round, r.value});
        if (r.kind == ReadingKind::azimuth) {
            if (azimuth_round_ == none) azimuth_round_ = rounds_++;
            sightings_.push_back({r.from, r.to, azimuth_round_, r.value});
        }
        if (r.kind != ReadingKind::angle) return;
        sightings_.push_back({r.from, r.to, rounds_, 0.0});
        sightings_.push_back({r.from, r.second, rounds_++, r.value});
    }

    void keep_distance(std::size_t a, std::size_t b, double d) {
        distances_.try_emplace({std::min(a, b), std::max(a, b)}, d);
    }
    std::optional<double> distance(std::size_t a, std::size_t b) const {
        const auto found = distances_.find({std::min(a, b), std::max(a, b)});
        return found == distances_.end() ? std::nullopt : std::optional(found->second);
    }

    /// Orients rounds by the farthest target that is placed.
    bool orient(PlaneFrame& frame) const {
        bool more = false;
        std::map<std::size_t, std::pair<double, double>> best;
        for (const Sighting& s : sightings_) {
            if (frame.orientations[s.round] || !frame.places[s.from] || !frame.places[s.to]) continue;
            const Vector2 v = *frame.places[s.to] - *frame.places[s.from];
            auto& [length, orientation] = best[s.round];
            if (v.norm() <= length) continue;
            length = v.norm();
            orientation = bearing(v) - s.angle;
        }
        for (const auto& [round, found] : best) {
            if (!(found.first > 0.0)) continue;
            frame.orientations[round] = found.second;
            more = true;
        }
        return more;
    }

    bool place(PlaneFrame& frame, std::size_t p) const {
        std::vector<Ray> rays;
        for (const Sighting& s : by_point_[p]) {
            if (!frame.orientations[s.round]) continue;
            const Vector2 along = this->along(s.angle + *frame.orientations[s.round]);
            if (s.to == p && frame.places[s.from]) rays.push_back({*frame.places[s.from], along, s.from});
            if (s.from == p && frame.places[s.to]) rays.push_back({*frame.places[s.to], -along, s.to});
        }
        for (const Ray& ray : rays)
            if (const auto d = distance(ray.point, p)) {
                frame.places[p] = ray.from + *d * ray.along;
                return true;
            }
        return intersect(frame, p, rays) || stand_freely(frame, p, rays) || by_distances(frame, p);
    }

    struct Sighted {
        Vector2 at;
        double angle;
        std::optional<double> distance;
    };
    struct Standing {
        double misfit = std::numeric_limits<double>::infinity(), orientation = 0.0;
        Vector2 at = Vector2::Zero();
    };

    /// The place of a station whose circle points to `orientation`, by linear least squares.
    Standing standing(const std::vector<Sighted>& targets, const std::vector<Ray>& rays,
                      double orientation) const {
        Eigen::Matrix2d N = Eigen::Matrix2d::Zero();
        Vector2 g = Vector2::Zero();
        const Vector2& origin = targets.front().at;
        const auto rows = [&](const auto& take) {
            for (const Sighted& t : targets) {
                const Vector2 e = along(orientation + t.angle), across(-e.y(), e.x());
                take(across, across.dot(t.at - origin));
                if (t.distance) take(e, e.dot(t.at - origin) - *t.distance);
            }
            for (const Ray& ray : rays) {
                const Vector2 across(-ray.along.y(), ray.along.x());
                take(across, across.dot(ray.from - origin));
            }
        };
        rows([&](const Vector2& a, double b) {
            N += a * a.transpose();
            g += b * a;
        });
        Standing found{.orientation = orientation};
        const double determinant = N(0, 0) * N(1, 1) - N(0, 1) * N(1, 0);
        if (!(determinant > 1e-9)) return found;
        const Vector2 p((N(1, 1) * g[0] - N(0, 1) * g[1]) / determinant,
                        (N(0, 0) * g[1] - N(1, 0) * g[0]) / determinant);
        found.at = origin + p;
        for (const Sighted& t : targets)
            if (along(orientation + t.angle).dot(t.at - found.at) < 0.0) return found;
        for (const Ray& ray : rays)
            if (ray.along.dot(found.at - ray.from) < 0.0) return found;
        found.misfit = 0.0;
        rows([&](const Vector2& a, double b) { found.misfit += std::pow(a.dot(p) - b, 2); });
        return found;
    }

    /// Places a station by resection, with distances and sights from others where there are some: of all
    /// orientations it takes the one that fits best.
    bool stand_freely(PlaneFrame& frame, std::size_t p, const std::vector<Ray>& rays) const {
        std::map<std::size_t, std::vector<Sighted>> targets;
        std::map<std::size_t, std::size_t> rows;
        for (const Sighting& s : by_point_[p]) {
            if (s.from != p || !frame.places[s.to] || frame.orientations[s.round]) continue;
            const auto d = distance(p, s.to);
            targets[s.round].push_back({*frame.places[s.to], s.angle, d});
            rows[s.round] += d ? 2 : 1;
        }
        for (const auto& [round, seen] : targets) {
            if (seen.size() < 2 || rows[round] + rays.size() < 3) continue;
            constexpr int steps = 720;
            Standing best;
            for (int k = 0; k < steps; ++k)
                if (const Standing s = standing(seen, rays, 2.0 * std::numbers::pi * k / steps);
                    s.misfit < best.misfit)
                    best = s;
            if (!std::isfinite(best.misfit)) continue;
            for (double width = 2.0 * std::numbers::pi / steps; width > 1e-8; width *= 0.25) {
                const double middle = best.orientation;
                for (int k = -4; k <= 4; ++k)
                    if (const Standing s = standing(seen, rays, middle + 0.25 * k * width);
                        s.misfit < best.misfit)
                        best = s;
            }
            frame.places[p] = best.at;
            frame.orientations[round] = best.orientation;
            return true;
        }
        return false;
    }

    /// Places a point by two circles, and a third distance that tells their two meeting points apart; in a
    /// frame of two points either will do.
    bool by_distances(PlaneFrame& frame, std::size_t p) const {
        std::vector<std::pair<Vector2, double>> circles;
        std::size_t placed = 0;
        for (std::size_t q = 0; q < frame.places.size(); ++q) {
            if (!frame.places[q]) continue;
            ++placed;
            if (const auto d = distance(p, q)) circles.push_back({*frame.places[q], *d});
        }
        if (circles.size() < 2 || (circles.size() < 3 && placed > 2)) return false;
        const auto& [a, da] = circles[0];
        const auto& [b, db] = circles[1];
        const Vector2 base = b - a;
        const double length = base.norm();
        if (!(length > 0.0)) return false;
        const double along = (da * da - db * db + length * length) / (2.0 * length);
        const double height = std::sqrt(std::max(0.0, da * da - along * along));
        const Vector2 e = base / length, across(-e.y(), e.x());
        const Vector2 left = a + along * e + height * across, right = a + along * e - height * across;
        double misfit = 0.0;
        for (std::size_t i = 2; i < circles.size(); ++i)
            misfit += std::abs((left - circles[i].first).norm() - circles[i].second) -
                      std::abs((right - circles[i].first).norm() - circles[i].second);
        frame.places[p] = misfit <= 0.0 ? left : right;
        return true;
    }

    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    const AdjustedNetwork& network_;
    std::size_t rounds_, azimuth_round_ = none;
    std::vector<Sighting> sightings_;
    std::vector<std::vector<Sighting>> by_point_;  ///< sightings from and to each point
    std::vector<Difference> vectors_;
    std::map<std::pair<std::size_t, std::size_t>, double> distances_;
};

/// The turn that most agree on: of the first ones the one with the least sum of absolute differences, then
/// the mean of all within 0.1 rad of it.
double agreed(const std::vector<double>& turns) {
    constexpr std::size_t most_tried = 30;
    constexpr double about = 0.1;
    double best = infinity, middle = 0.0;
    for (std::size_t i = 0; i < std::min(most_tried, turns.size()); ++i) {
        double sum = 0.0;
        for (const double turn : turns)
            sum += std::abs(std::remainder(turn - turns[i], 2.0 * std::numbers::pi));
        if (sum >= best) continue;
        best = sum;
        middle = turns[i];
    }
    double sum = 0.0, count = 0.0;
    for (const double turn : turns) {
        const double d = std::remainder(turn - middle, 2.0 * std::numbers::pi);
        if (std::abs(d) > about) continue;
        sum += d;
        ++count;
    }
    return std::remainder(middle + (count > 0.0 ? sum / count : 0.0), 2.0 * std::numbers::pi);
}

class Start {
public:
    Start(AdjustedNetwork& network, Problems& problems)
        : network_(network),
          problems_(problems),
          by_slopes_(tied_by_slopes_alone(network)),
          readings_(network, by_slopes_),
          placing_(network, readings_.empty_frame()) {}

    void find() {
        if (readings_.azimuths() != none) placing_.whole.orientations[readings_.azimuths()] = 0.0;
        for (bool more = true; more;) {
            while (placing_.place_by_own_frames(readings_.sightings().empty())) {
            }
            readings_.propagate(placing_.whole);
            lay_frames();
            placing_.put_plane();
            placing_.spread_heights();
            more = placing_.place_by_own_frames(false) ||
                   (!network_.frames.empty() && placing_.begin_heights()) ||
                   place_by_slopes(network_, placing_, by_slopes_);
        }
        say_unplaced();
        if (problems_.has_errors()) return;
        placing_.place_heights();
        orient_rounds();
        placing_.lay_frames();
        network_.stated = network_.state;
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    /// Lays frames of single stations, each grown as far as it goes, onto the whole where they meet it.
    void lay_frames() {
        for (bool more = true; more;) {
            more = false;
            for (const Sighting& seed : readings_.sightings()) {
                if (!placing_.wants(seed.from) && !placing_.wants(seed.to)) continue;
                PlaneFrame frame = readings_.empty_frame();
                frame.places[seed.from] = Vector2::Zero();
                frame.orientations[seed.round] = 0.0;
                readings_.propagate(frame);
                if (!lay(frame)) continue;
                readings_.propagate(placing_.whole);
                more = true;
            }
        }
        if (placing_.is_empty()) seed_by_distance();
    }

    bool lay(const PlaneFrame& frame) {
        std::vector<std::size_t> common;
        bool nothing_placed = true, brings = false;
        for (std::size_t p = 0; p < frame.places.size(); ++p) {
            nothing_placed = nothing_placed && !placing_.whole.places[p];
            brings = brings || (frame.places[p] && placing_.wants(p));
            if (frame.places[p] && placing_.whole.places[p]) common.push_back(p);
        }
        if (!brings) return false;
        const bool by_azimuth = readings_.azimuths() != none && frame.orientations[readings_.azimuths()];
        double turn =
            !by_azimuth ? 0.0 : (network_.clockwise ? 1.0 : -1.0) * *frame.orientations[readings_.azimuths()];
        if (nothing_placed) {
            take(frame, turn, Vector2::Zero(), Vector2::Zero());
            return true;
        }
        if (common.empty() || (common.size() == 1 && !by_azimuth)) return false;
        Vector2 here = Vector2::Zero(), there = Vector2::Zero();
        for (const std::size_t p : common) {
            here += *frame.places[p] / double(common.size());
            there += *placing_.whole.places[p] / double(common.size());
        }
        if (common.size() > 1) {
            double sine = 0.0, cosine = 0.0;
            for (const std::size_t p : common) {
                const Vector2 a = *frame.places[p] - here, b = *placing_.whole.places[p] - there;
                cosine += a.dot(b);
                sine += a.x() * b.y() - a.y() * b.x();
            }
            if (std::hypot(sine, cosine) == 0.0) return false;
            turn = std::atan2(sine, cosine);
        }
        take(frame, turn, here, there);
        return true;
    }

    void take(const PlaneFrame& frame, double turn, const Vector2& here, const Vector2& there) {
        const Eigen::Rotation2Dd R(turn);
        for (std::size_t p = 0; p < frame.places.size(); ++p)
            if (frame.places[p] && !placing_.whole.places[p])
                placing_.whole.places[p] = there + R * (*frame.places[p] - here);
    }

    /// Begins a network of distances alone, with nothing placed.
    void seed_by_distance() {
        for (const AdjustedReading& r : network_.readings) {
            if (r.kind != ReadingKind::horizontal_distance && r.kind != ReadingKind::slope_distance) continue;
            if (by_slopes_[r.from] || by_slopes_[r.to]) continue;
            placing_.whole.places[r.from] = Vector2::Zero();
            placing_.whole.places[r.to] = Vector2(r.value, 0.0);
            return readings_.propagate(placing_.whole);
        }
    }

    void say_unplaced() {
        std::string names;
        std::size_t missing = 0, first = 0;
        for (std::size_t p = 0; p < network_.points.size(); ++p) {
            if (!placing_.wants(p)) continue;
            constexpr std::size_t most_named = 10;
            network_.unplaced.push_back(p);
            if (missing == 0) first = p;
            if (missing++ < most_named) names += (names.empty() ? "" : ", ") + network_.points[p].name;
        }
        if (missing == 0) return;
        problems_.error(
            adjustment_fields().place(&StatedAdjustment::points, network_.points[first].row),
            missing == 1
                ? tell<"the readings do not place point %1: too few of them tie it to the others; "
                       "add readings, or state approximate coordinates">(names)
                : tell<"the readings do not place %1 points (%2): too few tie them to the others; add "
                       "readings, or state approximate coordinates">(missing, names));
    }

    /// Gives each round the turn that its directions agree with best: a direction to a wrong target turns no
    /// others.
    void orient_rounds() {
        std::vector<std::vector<double>> turns(network_.rounds.size());
        for (const AdjustedReading& r : network_.readings) {
            if (r.kind != ReadingKind::direction) continue;
            const Vector2 v = (network_.position(r.to) - network_.position(r.from)).head<2>();
            turns[r.round].push_back(readings_.bearing(v) - r.value);
        }
        for (std::size_t k = 0; k < turns.size(); ++k)
            network_.state[static_cast<Eigen::Index>(network_.orientation(k))] = agreed(turns[k]);
    }

    AdjustedNetwork& network_;
    Problems& problems_;
    std::vector<char> by_slopes_;
    PlaneReadings readings_;
    Placing placing_;
};

}  // namespace

void find_start(AdjustedNetwork& network, Problems& problems) {
    Start(network, problems).find();
}

}  // namespace covaria::network
