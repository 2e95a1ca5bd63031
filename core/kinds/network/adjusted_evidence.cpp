// What the residuals of an adjusted network say about the uncertainties that were stated of its readings.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "core/evidence/seen.h"
#include "core/kinds/network/adjusted_setup.h"

namespace covaria::network {

namespace {

/// Readings that one statement of uncertainty is about.
struct FigureKey {
    int kind = 0;
    bool is_stated_of_point = false;
    std::string instrument = {};
    auto operator<=>(const FigureKey&) const = default;
};

bool is_of_coordinates(ReadingKind kind) {
    return kind == ReadingKind::x || kind == ReadingKind::y || kind == ReadingKind::z;
}
bool is_of_differences(ReadingKind kind) {
    return kind == ReadingKind::dx || kind == ReadingKind::dy || kind == ReadingKind::dz;
}
bool is_of_tilts(ReadingKind kind) {
    return kind == ReadingKind::tilt_x || kind == ReadingKind::tilt_y;
}

/// The three coordinates, the three differences and the two tilts are one kind each.
ReadingKind first_alike(ReadingKind kind) {
    if (is_of_coordinates(kind)) return ReadingKind::x;
    if (is_of_differences(kind)) return ReadingKind::dx;
    return is_of_tilts(kind) ? ReadingKind::tilt_x : kind;
}

Message words_of_kind(const FigureKey& key) {
    switch (static_cast<ReadingKind>(key.kind)) {
        case ReadingKind::slope_distance:
            return tell<"slope distances">();
        case ReadingKind::horizontal_distance:
            return tell<"horizontal distances">();
        case ReadingKind::direction:
            return tell<"directions">();
        case ReadingKind::angle:
            return tell<"angles">();
        case ReadingKind::azimuth:
            return tell<"azimuths">();
        case ReadingKind::zenith_angle:
            return tell<"zenith angles">();
        case ReadingKind::height_difference:
            return tell<"height differences">();
        case ReadingKind::tilt_x:
        case ReadingKind::tilt_y:
            return tell<"tilts of instruments">();
        case ReadingKind::figure_length:
        case ReadingKind::figure_ratio:
        case ReadingKind::figure_angle:
            return tell<"stated figures of instruments">();
        case ReadingKind::x:
        case ReadingKind::y:
        case ReadingKind::z:
            return key.is_stated_of_point ? tell<"stated coordinates">() : tell<"coordinates">();
        case ReadingKind::dx:
        case ReadingKind::dy:
        case ReadingKind::dz:
            return tell<"coordinate differences">();
    }
    return {};
}

Message words_of_figure(const FigureKey& key) {
    const Message kind = words_of_kind(key);
    return key.instrument.empty() ? kind : tell<"%1 of %2">(kind, key.instrument);
}

class FiguresOfNetwork {
public:
    explicit FiguresOfNetwork(const AdjustedNetwork& network) : network_(network) {
        for (const AdjustedReading& reading : network.readings) {
            const bool of_point = is_of_coordinates(reading.kind) && is_stated_of_point(reading);
            const FigureKey key{static_cast<int>(first_alike(reading.kind)), of_point, reading.instrument};
            const auto [known, added] = numbers_.try_emplace(key, keys_.size());
            if (added) keys_.push_back(key);
            key_of_.push_back(known->second);
        }
        leader_.resize(keys_.size());
        std::iota(leader_.begin(), leader_.end(), std::size_t{0});
        for (const adjustment::CovarianceBlock& block : network.blocks)
            for (const std::size_t reading : block.readings) join(block.readings.front(), reading);
    }

    void put(evidence::RedundantReadings& readings) const {
        std::vector<std::size_t> number_of(keys_.size());
        for (std::size_t k = 0; k < keys_.size(); ++k) {
            if (leader_of(k) == k) {
                number_of[k] = readings.figures.size();
                readings.figures.push_back({.name = words_of_figure(keys_[k])});
                continue;
            }
            number_of[k] = number_of[leader_of(k)];
            evidence::StatedFigure& figure = readings.figures[number_of[k]];
            figure.name = tell<"%1 and %2">(figure.name, words_of_figure(keys_[k]));
        }
        for (std::size_t i = 0; i < network_.readings.size(); ++i) {
            const AdjustedReading& reading = network_.readings[i];
            evidence::StatedFigure& figure = readings.figures[number_of[key_of_[i]]];
            const Unit unit = unit_of_residual(reading.kind);
            if (figure.count++ == 0) {
                figure.unit = unit;
                figure.least = figure.most = reading.u;
                figure.source = reading.source;
            } else if (unit == figure.unit) {
                figure.least = std::min(figure.least, reading.u);
                figure.most = std::max(figure.most, reading.u);
            }
            readings.figure_of.push_back(number_of[key_of_[i]]);
        }
    }

private:
    bool is_stated_of_point(const AdjustedReading& reading) const {
        return reading.source ==
               adjustment_fields().place(&StatedAdjustment::points, network_.points[reading.from].row);
    }
    std::size_t leader_of(std::size_t k) const {
        while (leader_[k] != k) k = leader_[k];
        return k;
    }
    /// The smaller number leads, which comes first.
    void join(std::size_t reading, std::size_t other) {
        const std::size_t a = leader_of(key_of_[reading]), b = leader_of(key_of_[other]);
        leader_[std::max(a, b)] = std::min(a, b);
    }

    const AdjustedNetwork& network_;
    std::map<FigureKey, std::size_t> numbers_;
    std::vector<FigureKey> keys_;
    std::vector<std::size_t> key_of_;  ///< of each reading
    std::vector<std::size_t> leader_;  ///< of each key among those that have one figure
};

struct Factor {
    double factor = 1.0;
    double degrees_of_freedom = infinity;
};

/// Of each reading; 1 with infinite degrees of freedom: as stated.
void scale(AdjustedNetwork& network, const std::vector<std::size_t>& figure_of,
           const std::vector<Factor>& factors, Problems& problems) {
    Eigen::VectorXd by(static_cast<Eigen::Index>(network.readings.size()));
    for (std::size_t i = 0; i < network.readings.size(); ++i) {
        const Factor& of = factors[figure_of[i]];
        AdjustedReading& reading = network.readings[i];
        by[static_cast<Eigen::Index>(i)] = 1.0 / of.factor;
        if (std::isinf(of.degrees_of_freedom)) continue;
        reading.estimate = figure_of[i];
        reading.factor = of.factor;
        reading.degrees_of_freedom = of.degrees_of_freedom;
        reading.u *= of.factor;
    }
    for (adjustment::CovarianceBlock& block : network.blocks) {
        const double factor = factors[figure_of[block.readings.front()]].factor;
        block.covariance *= factor * factor;
    }
    network.whitening = adjustment::SparseRows(by.asDiagonal() * network.whitening);
    adjust(network, problems);
}

void warn(Problems& problems, Message words) {
    problems.warning(adjustment_fields().place(&StatedAdjustment::uncertainties), std::move(words));
}

void take_one_factor(AdjustedNetwork& network, Problems& problems) {
    const adjustment::Reliability found = reliability_of(network);
    if (!(found.s0 > 0.0))
        return warn(problems,
                    tell<"The readings have no residuals that could tell their uncertainty: it stays as "
                         "stated">());
    scale(network, std::vector<std::size_t>(network.readings.size(), 0),
          {{found.s0, static_cast<double>(found.degrees_of_freedom)}}, problems);
}

}  // namespace

evidence::RedundantReadings redundant_readings(const AdjustedNetwork& network) {
    evidence::RedundantReadings readings;
    readings.design = design_of(network, network.state.data());
    readings.whitening = network.whitening;
    readings.residuals = residuals_of(network, network.state.data());
    readings.datum = network.datum;
    FiguresOfNetwork(network).put(readings);
    const adjustment::Reliability found = reliability_of(network);
    for (std::size_t i = 0; i < network.readings.size(); ++i) {
        readings.names.push_back(words_of(network, network.readings[i]));
        readings.sources.push_back(network.readings[i].source);
        readings.w.push_back(found.readings[i].controlled ? found.readings[i].w
                                                          : std::numeric_limits<double>::quiet_NaN());
    }
    for (std::size_t k = 0; k < network.place_of.size(); ++k) {
        const std::size_t place = network.place_of[k];
        if (place >= 3 * network.points.size()) break;
        const CoordinateRole role = network.points[place / 3].role[place % 3];
        if (role == CoordinateRole::unknown || role == CoordinateRole::datum)
            readings.measurands.push_back(k);
    }
    readings.unit_of_measurands = Unit::of("mm");
    readings.take_over = {"uncertainties", "stated", "seen"};
    return readings;
}

void take_as_seen(AdjustedNetwork& network, ReadingUncertainties from, Problems& problems) {
    if (from == ReadingUncertainties::stated) return;
    if (!network.evidence)
        return warn(problems, tell<"Nothing is redundant: uncertainties of the readings stay as stated">());
    if (from == ReadingUncertainties::one_factor) return take_one_factor(network, problems);
    const evidence::Seen seen = evidence::see(*network.evidence);
    if (!seen.found)
        return warn(problems, tell<"The residuals give no factors: uncertainties of the readings stay as "
                                   "stated">());
    std::vector<Factor> factors(seen.figures.size());
    Message kept;
    for (std::size_t k = 0; k < factors.size(); ++k) {
        const evidence::SeenFigure& figure = seen.figures[k];
        if (figure.verdict != evidence::Verdict::too_little && !figure.clamped) {
            factors[k] = {figure.factor, figure.degrees_of_freedom};
            continue;
        }
        kept += Message(kept.empty() ? "" : ", ") + network.evidence->figures[k].name;
    }
    if (!kept.empty()) warn(problems, tell<"Too little redundancy to say, so they stay as stated: %1">(kept));
    scale(network, network.evidence->figure_of, factors, problems);
}

}  // namespace covaria::network
