// Networks to be adjusted, from true coordinates: readings as they would be, with small deviations.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "core/kinds/network/adjusted_setup.h"

namespace covaria::network {

struct TrueNetwork {
    std::map<std::string, Eigen::Vector3d> places;
    StatedAdjustment stated;
    double deviations = 1.0;                             ///< factor on the deviations of readings, in their u
    std::map<std::string, std::array<double, 2>> tilts;  ///< tilts of instruments: about x, then about y

    /// Coordinates are given where `approximate`, to that many m.
    void point(const std::string& name, const Eigen::Vector3d& at, CoordinateRole plane,
               CoordinateRole height, std::optional<double> approximate = {}) {
        places[name] = at;
        StatedAdjustment::Point point{.name = name, .p = {}, .plane = plane, .height = height, .u = {}};
        for (std::size_t c = 0; c < 3; ++c)
            if (approximate) point.p[c] = at[static_cast<Eigen::Index>(c)] + *approximate * next();
        stated.points.push_back(point);
    }

    void read(ReadingKind kind, const std::string& from, const std::string& to,
              const std::string& second = {}) {
        Eigen::Vector3d v = places.at(to) - places.at(from);
        if (const auto tilt = tilts.find(from); tilt != tilts.end())
            v = Eigen::AngleAxisd(-tilt->second[1], Eigen::Vector3d::UnitY()) *
                (Eigen::AngleAxisd(-tilt->second[0], Eigen::Vector3d::UnitX()) * v);
        const double bearing = std::atan2(v.y(), v.x());
        StatedAdjustment::Reading reading{.kind = kind, .from = from, .to = to, .second = second};
        double value = 0.0;
        switch (kind) {
            case ReadingKind::slope_distance:
                value = v.norm();
                break;
            case ReadingKind::horizontal_distance:
                value = v.head<2>().norm();
                break;
            case ReadingKind::direction:
                value = bearing - 0.3 * static_cast<double>(from.size() + from[0]);
                break;
            case ReadingKind::azimuth:
                value = bearing;
                break;
            case ReadingKind::zenith_angle:
                value = std::atan2(v.head<2>().norm(), v.z());
                break;
            case ReadingKind::angle: {
                const Eigen::Vector3d w = places.at(second) - places.at(from);
                value = std::atan2(w.y(), w.x()) - bearing;
                break;
            }
            default:
                value = v.z();
        }
        const double u = is_of_angle(kind) ? 1e-5 : 1e-3;
        (is_of_angle(kind) ? reading.angle : reading.length) = value + deviations * u * next();
        (is_of_angle(kind) ? reading.u_angle : reading.u_length) = u;
        stated.readings.push_back(reading);
    }
    void read_all(const std::vector<ReadingKind>& kinds, const std::string& from,
                  const std::vector<std::string>& to) {
        for (const std::string& target : to)
            for (const ReadingKind kind : kinds) read(kind, from, target);
    }

    StatedAdjustment::Point& called(const std::string& name) {
        for (StatedAdjustment::Point& point : stated.points)
            if (point.name == name) return point;
        throw std::out_of_range(name);
    }

private:
    /// Between -1 and 1, the same in every run.
    double next() {
        ++count_;
        return std::sin(count_ * 12.9898) * std::cos(count_ * 4.1414);
    }
    int count_ = 0;
};

struct Adjusted {
    Problems problems;
    std::optional<AdjustedNetwork> network;

    explicit Adjusted(const StatedAdjustment& stated) : network(adjust_stated(stated, problems)) {
        if (network) check_adjustment(*network, problems);
    }
    std::string words() const {
        std::string text;
        for (const Problem& problem : problems.items()) text += problem.message.english() + "\n";
        return text;
    }
};

/// A hall: two stations that nobody knows, four points that may be known, two targets. In space.
inline TrueNetwork hall(CoordinateRole known, std::optional<double> approximate,
                        std::map<std::string, std::array<double, 2>> tilts = {}) {
    TrueNetwork net;
    net.tilts = std::move(tilts);
    const bool needs = known == CoordinateRole::fixed || known == CoordinateRole::datum;
    for (const auto& [name, x, y, z] : {std::tuple("A", 0.0, 0.0, 1.2), std::tuple("B", 24.0, 1.5, 1.4),
                                        std::tuple("C", 20.0, 16.0, 2.1), std::tuple("D", -2.0, 14.0, 0.9)})
        net.point(name, {x, y, z}, known, known, needs ? std::optional(0.0) : approximate);
    for (const auto& [name, x, y, z] : {std::tuple("P", 8.0, 5.0, 0.4), std::tuple("Q", 15.0, 9.0, 3.2),
                                        std::tuple("S", 6.0, 9.0, 1.6), std::tuple("T", 16.0, 3.5, 1.65)})
        net.point(name, {x, y, z}, CoordinateRole::unknown, CoordinateRole::unknown, approximate);
    const std::vector<ReadingKind> all{ReadingKind::direction, ReadingKind::zenith_angle,
                                       ReadingKind::slope_distance};
    net.read_all(all, "S", {"A", "B", "C", "D", "P", "Q", "T"});
    net.read_all(all, "T", {"A", "B", "C", "P", "Q", "S"});
    return net;
}

}  // namespace covaria::network
