#include "core/readers/rounds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace covaria {

namespace {

constexpr double pi = std::numbers::pi;

/// The angle nearest to zero, by whole turns.
double wrapped(double angle) {
    return std::remainder(angle, 2.0 * pi);
}

struct RoundReading {
    double azimuth = 0.0, zenith = 0.0, distance = 0.0;
};

struct TargetRounds {
    std::string point;
    int line = 0;
    std::vector<PolarReading> faces[2];
    std::vector<RoundReading> rounds;
};

RoundReading in_face_one(const PolarReading& reading, bool second) {
    if (!second) return {reading.azimuth, reading.zenith, reading.distance};
    return {reading.azimuth - pi, 2.0 * pi - reading.zenith, reading.distance};
}

RoundReading mean_of(const RoundReading& a, const RoundReading& b) {
    return {a.azimuth + 0.5 * wrapped(b.azimuth - a.azimuth), 0.5 * (a.zenith + b.zenith),
            0.5 * (a.distance + b.distance)};
}

void pair_faces(TargetRounds& target) {
    const std::size_t pairs = std::min(target.faces[0].size(), target.faces[1].size());
    for (std::size_t i = 0; i < pairs; ++i)
        target.rounds.push_back(
            mean_of(in_face_one(target.faces[0][i], false), in_face_one(target.faces[1][i], true)));
    for (std::size_t face = 0; face < 2; ++face)
        for (std::size_t i = pairs; i < target.faces[face].size(); ++i)
            target.rounds.push_back(in_face_one(target.faces[face][i], face == 1));
}

/// The mean of the azimuths of a target; their residuals from it are added.
double mean_azimuth(const TargetRounds& target, std::vector<double>& residuals) {
    const double first = target.rounds.front().azimuth;
    double sum = 0.0;
    for (const RoundReading& round : target.rounds) sum += wrapped(round.azimuth - first);
    const double mean = first + sum / static_cast<double>(target.rounds.size());
    for (const RoundReading& round : target.rounds) residuals.push_back(wrapped(round.azimuth - mean));
    return mean;
}

double mean_figure(const TargetRounds& target, double RoundReading::*figure, PooledFigure& pooled) {
    double mean = 0.0;
    for (const RoundReading& round : target.rounds)
        mean += round.*figure / static_cast<double>(target.rounds.size());
    for (const RoundReading& round : target.rounds) pooled.s += std::pow(round.*figure - mean, 2);
    pooled.degrees_of_freedom += static_cast<int>(target.rounds.size()) - 1;
    return mean;
}

void finish(PooledFigure& pooled) {
    pooled.s = pooled.degrees_of_freedom > 0 ? std::sqrt(pooled.s / pooled.degrees_of_freedom) : 0.0;
}

void pool_azimuths(const std::vector<std::vector<double>>& residuals, PooledFigure& pooled) {
    const std::size_t rounds = residuals.front().size(), targets = residuals.size();
    const bool balanced = targets > 1 && std::all_of(residuals.begin(), residuals.end(),
                                                     [&](const auto& r) { return r.size() == rounds; });
    std::vector<double> turn(rounds, 0.0);
    for (std::size_t k = 0; balanced && k < rounds; ++k)
        for (const auto& r : residuals) turn[k] += r[k] / static_cast<double>(targets);
    for (const auto& r : residuals) {
        for (std::size_t k = 0; k < r.size(); ++k) pooled.s += std::pow(r[k] - (balanced ? turn[k] : 0.0), 2);
        pooled.degrees_of_freedom += static_cast<int>(r.size()) - 1;
    }
    if (balanced) pooled.degrees_of_freedom -= static_cast<int>(rounds) - 1;
    finish(pooled);
}

/// Takes half of the differences of the two faces, averaged.
void take_faces(const std::vector<TargetRounds>& targets, Rounds& rounds) {
    std::size_t pairs = 0;
    rounds.two_faces = true;
    for (const TargetRounds& target : targets) {
        rounds.two_faces = rounds.two_faces && target.faces[0].size() == target.faces[1].size();
        const std::size_t n = std::min(target.faces[0].size(), target.faces[1].size());
        for (std::size_t i = 0; i < n; ++i, ++pairs) {
            const PolarReading &one = target.faces[0][i], &two = target.faces[1][i];
            rounds.collimation += 0.5 * wrapped(two.azimuth - one.azimuth - pi) * std::sin(one.zenith);
            rounds.index += 0.5 * (one.zenith + two.zenith - 2.0 * pi);
        }
    }
    if (pairs == 0) return;
    rounds.collimation /= static_cast<double>(pairs);
    rounds.index /= static_cast<double>(pairs);
}

}  // namespace

Rounds rounds_of(const std::vector<PolarReading>& readings) {
    std::vector<TargetRounds> targets;
    std::map<std::string, std::size_t> index;
    for (const PolarReading& reading : readings) {
        const auto [found, added] = index.try_emplace(reading.point, targets.size());
        if (added) targets.push_back({reading.point, reading.line, {}, {}});
        targets[found->second].faces[reading.zenith > pi ? 1 : 0].push_back(reading);
    }
    Rounds rounds;
    if (targets.empty()) return rounds;
    std::vector<std::vector<double>> residuals;
    rounds.fewest_rounds = readings.size();
    for (TargetRounds& target : targets) {
        pair_faces(target);
        const double azimuth = mean_azimuth(target, residuals.emplace_back());
        const double zenith = mean_figure(target, &RoundReading::zenith, rounds.zenith);
        const double distance = mean_figure(target, &RoundReading::distance, rounds.distance);
        rounds.means.push_back({target.point, target.line, azimuth, zenith, distance, target.rounds.size()});
        rounds.fewest_rounds = std::min(rounds.fewest_rounds, target.rounds.size());
    }
    finish(rounds.zenith);
    finish(rounds.distance);
    pool_azimuths(residuals, rounds.azimuth);
    take_faces(targets, rounds);
    return rounds;
}

}  // namespace covaria
