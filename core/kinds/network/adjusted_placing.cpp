#include "core/kinds/network/adjusted_placing.h"

#include <algorithm>
#include <cmath>

namespace covaria::network {

Placing::Placing(AdjustedNetwork& network, PlaneFrame empty) : whole(std::move(empty)), network_(network) {
    for (std::size_t p = 0; p < network.points.size(); ++p) {
        const AdjustedPoint& point = network.points[p];
        if (point.placed[0] && point.placed[1]) whole.places[p] = network.position(p).head<2>();
        heights_.push_back(point.placed[2] || !point.has(2));
    }
    for (const AdjustedReading& r : network.readings) take_coordinate(r);
}

/// Takes a coordinate that was read of a point.
void Placing::take_coordinate(const AdjustedReading& r) {
    if (r.kind == ReadingKind::z && !heights_[r.from]) {
        height(r.from) = r.value;
        heights_[r.from] = 1;
    }
    if (r.kind != ReadingKind::x && r.kind != ReadingKind::y) return;
    AdjustedPoint& point = network_.points[r.from];
    const std::size_t c = r.kind == ReadingKind::x ? 0 : 1;
    if (!point.placed[c]) network_.state[static_cast<Eigen::Index>(network_.at(r.from, c))] = r.value;
    point.placed[c] = true;
    if (point.placed[0] && point.placed[1]) whole.places[r.from] = network_.position(r.from).head<2>();
}

bool Placing::is_empty() const {
    return std::ranges::none_of(whole.places, [](const auto& p) { return p.has_value(); });
}

void Placing::put(std::size_t p, const Eigen::Vector3d& at) {
    network_.state.segment<3>(static_cast<Eigen::Index>(3 * p)) = at;
    whole.places[p] = at.head<2>();
    heights_[p] = 1;
}

void Placing::put_plane() {
    for (std::size_t p = 0; p < network_.points.size(); ++p)
        if (const AdjustedPoint& point = network_.points[p];
            whole.places[p] && (!point.placed[0] || !point.placed[1]))
            network_.state.segment<2>(static_cast<Eigen::Index>(3 * p)) = *whole.places[p];
}

/// The height of `to` above `from` that the reading tells where the plane is placed.
std::optional<double> Placing::rise(const AdjustedReading& r) const {
    const double raised = r.height_from - r.height_to;
    if (r.kind == ReadingKind::height_difference || r.kind == ReadingKind::dz) return r.value + raised;
    if (r.kind != ReadingKind::zenith_angle || wants(r.from) || wants(r.to)) return {};
    const double rho = (network_.position(r.to) - network_.position(r.from)).head<2>().norm();
    return rho / std::tan(r.value) + raised;
}

void Placing::spread_heights() {
    for (bool more = true; more;) {
        more = false;
        for (const AdjustedReading& r : network_.readings) {
            if (heights_[r.from] == heights_[r.to]) continue;
            const auto up = rise(r);
            if (!up) continue;
            if (!network_.points[r.from].has(2) || !network_.points[r.to].has(2)) continue;
            heights_[r.to] ? height(r.from) = height(r.to) - *up : height(r.to) = height(r.from) + *up;
            heights_[r.from] = heights_[r.to] = 1;
            more = true;
        }
    }
}

bool Placing::begin_heights() {
    for (std::size_t p = 0; p < heights_.size(); ++p)
        if (heights_[p] && network_.points[p].has(2)) return false;
    const auto first = std::ranges::find(heights_, 0);
    if (first == heights_.end()) return false;
    *first = 1;
    spread_heights();
    return true;
}

void Placing::place_heights() {
    for (;;) {
        spread_heights();
        const auto first = std::ranges::find(heights_, 0);
        if (first == heights_.end()) return;
        height(static_cast<std::size_t>(first - heights_.begin())) = mean_height();
        *first = 1;
    }
}

double Placing::mean_height() const {
    double sum = 0.0, count = 0.0;
    for (std::size_t p = 0; p < heights_.size(); ++p)
        if (heights_[p] && network_.points[p].has(2)) {
            sum += network_.position(p).z();
            ++count;
        }
    return count > 0.0 ? sum / count : 0.0;
}

std::vector<char> Placing::placed() const {
    std::vector<char> all = heights_;
    for (std::size_t p = 0; p < all.size(); ++p) all[p] = all[p] && !wants(p);
    return all;
}

std::size_t Placing::largest_frame() const {
    std::size_t largest = network_.frames.size(), most = 0;
    for (std::size_t f = 0; f < network_.frames.size(); ++f) {
        if (network_.frames[f].shape != FrameShape::axes) continue;
        const std::size_t count = points_of_frame(network_, f).size();
        if (count <= most) continue;
        most = count;
        largest = f;
    }
    return largest;
}

bool Placing::place_by_own_frames(bool begins) {
    if (network_.frames.empty()) return false;
    const std::vector<char> known = placed();
    const std::size_t first = begins && is_empty() ? largest_frame() : network_.frames.size();
    bool more = false;
    for (std::size_t f = 0; f < network_.frames.size(); ++f) {
        if (network_.frames[f].shape != FrameShape::axes) continue;
        if (f == first || lay_frame(network_, f, known)) more = place_by(f) || more;
    }
    return more;
}

bool Placing::place_by(std::size_t f) {
    bool more = false;
    for (const auto& [p, l] : points_of_frame(network_, f)) {
        const Eigen::Vector3d at = out_of_frame(network_, f, l);
        if (wants(p)) {
            whole.places[p] = at.head<2>();
            more = true;
        }
        if (heights_[p] || network_.frames[f].is_flat) continue;
        height(p) = at.z();
        heights_[p] = 1;
        more = true;
    }
    put_plane();
    return more;
}

void Placing::lay_frames() {
    for (std::size_t f = 0; f < network_.frames.size(); ++f) lay_frame(network_, f, placed());
}

}  // namespace covaria::network
