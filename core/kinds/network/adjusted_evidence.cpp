// Evidence that the residuals of an adjusted network give about the uncertainties stated of its readings.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/disjoint_sets.h"
#include "core/evidence/as_seen.h"
#include "core/evidence/combined.h"
#include "core/kinds/network/adjusted_setup.h"
#include "core/kinds/network/seen_figures.h"
#include "core/kinds/points/component_evidence.h"

namespace covaria::network {

namespace {

/// The key of the readings that one statement of uncertainty is about.
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

/// The first of the kinds that count as one: the three coordinates, also in frames, the three differences,
/// and the two tilts.
ReadingKind first_alike(ReadingKind kind) {
    if (is_of_coordinates(kind)) return ReadingKind::x;
    if (is_of_differences(kind)) return ReadingKind::dx;
    if (is_in_frame(kind)) return ReadingKind::frame_x;
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
        case ReadingKind::frame_x:
        case ReadingKind::frame_y:
        case ReadingKind::frame_z:
            return tell<"coordinates in frames">();
    }
    return {};
}

Message words_of_figure(const FigureKey& key) {
    const Message kind = words_of_kind(key);
    return key.instrument.empty() ? kind : tell<"%1 of %2">(kind, key.instrument);
}

FigureKey key_of(const AdjustedNetwork& network, const AdjustedReading& reading) {
    const bool of_point = is_of_coordinates(reading.kind) &&
                          reading.source == adjustment_fields().place(&StatedAdjustment::points,
                                                                      network.points[reading.from].row);
    return {static_cast<int>(first_alike(reading.kind)), of_point, reading.instrument};
}

class FiguresOfNetwork {
public:
    explicit FiguresOfNetwork(const AdjustedNetwork& network) : network_(network) {
        for (const AdjustedReading& reading : network.readings) {
            const FigureKey key = key_of(network, reading);
            const auto [known, added] = numbers_.try_emplace(key, keys_.size());
            if (added) keys_.push_back(key);
            key_of_.push_back(known->second);
        }
    }

    void put(evidence::RedundantReadings& readings) const {
        DisjointSets one_figure(keys_.size());
        for (const adjustment::CovarianceBlock& block : network_.blocks)
            for (const std::size_t reading : block.readings)
                one_figure.join(key_of_[block.readings.front()], key_of_[reading]);
        std::vector<std::size_t> number_of(keys_.size());
        for (std::size_t k = 0; k < keys_.size(); ++k) {
            const std::size_t leader = one_figure.leader_of(k);
            if (leader == k) {
                number_of[k] = readings.figures.size();
                readings.figures.push_back({.name = words_of_figure(keys_[k])});
                continue;
            }
            number_of[k] = number_of[leader];
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
    const AdjustedNetwork& network_;
    std::map<FigureKey, std::size_t> numbers_;
    std::vector<FigureKey> keys_;
    std::vector<std::size_t> key_of_;  ///< index of the figure of each reading
};

/// Lengths of the lines that are read, and heights of what is read; those of no reading are left out.
std::vector<evidence::Abscissa> abscissas_of(const AdjustedNetwork& network) {
    constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
    evidence::Abscissa length{tell<"distance">(), Unit::of("m"), {}},
        height{tell<"height">(), Unit::of("m"), {}};
    for (const AdjustedReading& reading : network.readings) {
        const bool is_of_figure = reading.kind == ReadingKind::figure_length ||
                                  reading.kind == ReadingKind::figure_ratio ||
                                  reading.kind == ReadingKind::figure_angle || is_of_tilts(reading.kind);
        const bool is_of_point = is_of_coordinates(reading.kind) || is_in_frame(reading.kind);
        const std::size_t at = is_of_point ? reading.from : reading.to;
        const bool is_line = !is_of_figure && !is_of_point && reading.from != reading.to;
        length.values.push_back(
            is_line ? (network.position(reading.to) - network.position(reading.from)).norm() : no_value);
        height.values.push_back(!is_of_figure && network.points[at].has(2) ? network.position(at).z()
                                                                           : no_value);
    }
    std::vector<evidence::Abscissa> all;
    for (evidence::Abscissa* one : {&length, &height})
        if (std::ranges::any_of(one->values, [](double value) { return std::isfinite(value); }))
            all.push_back(std::move(*one));
    return all;
}

/// Scales the uncertainties of readings with the factors of the figures that are seen.
void scale(AdjustedNetwork& network, const std::vector<std::size_t>& figure_of,
           const std::vector<evidence::TakenFactor>& factors) {
    Eigen::VectorXd by(static_cast<Eigen::Index>(network.readings.size()));
    for (std::size_t i = 0; i < network.readings.size(); ++i) {
        const evidence::TakenFactor& of = factors[figure_of[i]];
        AdjustedReading& reading = network.readings[i];
        by[static_cast<Eigen::Index>(i)] = 1.0 / of.factor;
        if (!of.is_seen()) continue;
        reading.estimate = figure_of[i];
        reading.seen_in.clear();
        reading.factor = of.factor;
        reading.degrees_of_freedom = of.degrees_of_freedom;
        reading.u *= of.factor;
    }
    for (adjustment::CovarianceBlock& block : network.blocks) {
        const double factor = factors[figure_of[block.readings.front()]].factor;
        block.covariance *= factor * factor;
    }
    network.whitening = adjustment::SparseRows(by.asDiagonal() * network.whitening);
}

/// The figure of readings of one kind and instrument that other analyses see; empty: none of them sees it.
struct SeenElsewhere {
    std::optional<SeenFigureOfReadings> figure = {};
    double between = 0.0;  ///< standard deviation of ln u between them
    std::string ids = {}, names = {};
    std::vector<FigureOverCampaigns::Campaign> campaigns = {};
    bool has_u = false;  ///< the campaigns say u, and not how many times what is stated
};

std::string names_of(const std::vector<Offered<SeenFiguresSource>>& campaigns) {
    std::string names;
    for (const auto& campaign : campaigns) names += (names.empty() ? "" : ", ") + campaign.name;
    return names;
}

SeenElsewhere seen_elsewhere(const std::vector<Offered<SeenFiguresSource>>& campaigns,
                             const AdjustedReading& reading) {
    SeenElsewhere seen;
    std::vector<SeenFigureOfReadings> figures;
    std::vector<Offered<SeenFiguresSource>> sees;
    for (const auto& campaign : campaigns)
        if (const auto figure = campaign->figure_of(reading.kind, reading.instrument)) {
            figures.push_back(*figure);
            sees.push_back(campaign);
            seen.ids += (seen.ids.empty() ? "" : "+") + campaign.id;
        }
    if (figures.empty()) return {};
    seen.names = names_of(sees);
    seen.figure = figures.front();
    const bool has_u = std::ranges::all_of(figures, [](const auto& figure) { return figure.u.has_value(); });
    std::vector<evidence::CampaignFigure> of_campaigns;
    for (std::size_t k = 0; k < figures.size(); ++k) {
        const double value = has_u ? *figures[k].u : figures[k].factor;
        of_campaigns.push_back({value, figures[k].degrees_of_freedom});
        seen.campaigns.push_back({sees[k].name, sees[k]->day(), value, figures[k].degrees_of_freedom});
    }
    seen.has_u = has_u;
    const evidence::CombinedFigure found = evidence::combined(of_campaigns);
    if (!has_u) seen.figure->u.reset();
    (has_u ? *seen.figure->u : seen.figure->factor) = found.u;
    seen.figure->degrees_of_freedom = found.degrees_of_freedom;
    seen.between = found.between;
    return seen;
}

FigureOverCampaigns over_campaigns(const FigureKey& key, const SeenElsewhere& seen) {
    FigureOverCampaigns figure{words_of_kind(key).english(), key.instrument};
    if (seen.has_u) figure.unit = unit_of_residual(static_cast<ReadingKind>(key.kind));
    figure.campaigns = seen.campaigns;
    figure.combined = {.name = {},
                       .value = seen.has_u ? *seen.figure->u : seen.figure->factor,
                       .degrees_of_freedom = seen.figure->degrees_of_freedom};
    return figure;
}

}  // namespace

evidence::RedundantReadings redundant_readings(const AdjustedNetwork& network) {
    evidence::RedundantReadings readings;
    readings.design = design_of(network, network.state.data());
    readings.whitening = network.whitening;
    readings.residuals = residuals_of(network, network.state.data());
    readings.datum = network.datum;
    FiguresOfNetwork(network).put(readings);
    const adjustment::Reliability& found = reliability_of(network);
    for (std::size_t i = 0; i < network.readings.size(); ++i) {
        readings.names.push_back(words_of(network, network.readings[i]));
        readings.w.push_back(found.readings[i].controlled ? found.readings[i].w
                                                          : std::numeric_limits<double>::quiet_NaN());
    }
    readings.abscissas = abscissas_of(network);
    for (std::size_t k = 0; k < network.place_of.size(); ++k) {
        const std::size_t place = network.place_of[k];
        if (place >= 3 * network.points.size()) break;
        const CoordinateRole role = network.points[place / 3].role[place % 3];
        if (role == CoordinateRole::unknown || role == CoordinateRole::datum)
            readings.measurands.push_back(k);
    }
    readings.unit_of_measurands = Unit::of("mm");
    readings.take_over = take_over_of_uncertainties();
    return readings;
}

void take_as_seen(AdjustedNetwork& network, UncertaintiesFrom from, Problems& problems) {
    if (from == UncertaintiesFrom::stated) return;
    if (network.adjusted->degrees_of_freedom() > 0)
        network.evidence = std::make_shared<const evidence::RedundantReadings>(redundant_readings(network));
    const evidence::AsSeen taken = evidence::as_seen(
        network.evidence.get(), from, adjustment_fields().place(&StatedAdjustment::uncertainties), problems);
    if (!taken.has_any()) return;
    // With one factor for all, every reading rests on the same estimate.
    const bool one = from == UncertaintiesFrom::one_factor;
    scale(network, one ? std::vector<std::size_t>(network.readings.size(), 0) : network.evidence->figure_of,
          taken.factors);
    adjust(network, problems);
}

std::shared_ptr<const evidence::RedundantReadings> NetworkEvidence::readings() const {
    if (network.evidence || network.adjusted->degrees_of_freedom() == 0) return network.evidence;
    std::call_once(asked_, [&] {
        readings_ = std::make_shared<const evidence::RedundantReadings>(redundant_readings(network));
    });
    return readings_;
}

std::optional<SeenFigureOfReadings> NetworkEvidence::figure_of(ReadingKind kind,
                                                               const std::string& instrument) const {
    const auto redundant = readings();
    if (!redundant) return {};
    const evidence::Seen& seen = evidence::seen_of(*redundant);
    const FigureKey sought{static_cast<int>(first_alike(kind)), false, instrument};
    for (std::size_t i = 0; i < network.readings.size() && seen.found; ++i) {
        if (key_of(network, network.readings[i]) != sought) continue;
        const std::size_t k = redundant->figure_of[i];
        if (!evidence::is_known(seen.figures[k])) return {};
        SeenFigureOfReadings figure{seen.figures[k].factor, {}, seen.figures[k].degrees_of_freedom, k};
        const evidence::StatedFigure& stated = redundant->figures[k];
        const auto alike = std::ranges::count_if(network.readings, [&](const AdjustedReading& reading) {
            return key_of(network, reading) == sought;
        });
        if (static_cast<std::size_t>(alike) == stated.count &&
            stated.most - stated.least <= 1e-12 * stated.most)
            figure.u = figure.factor * stated.least;
        return figure;
    }
    return {};
}

std::vector<Offered<SeenFiguresSource>> campaigns_of(const StatedAdjustment& stated) {
    std::vector<Offered<SeenFiguresSource>> campaigns;
    const auto take = [&](const Offered<SeenFiguresSource>& campaign) {
        const auto same = [&](const Offered<SeenFiguresSource>& known) { return known.id == campaign.id; };
        if (campaign && std::ranges::none_of(campaigns, same)) campaigns.push_back(campaign);
    };
    take(stated.seen_in);
    for (const StatedAdjustment::Campaign& further : stated.further_campaigns) take(further.seen_in);
    return campaigns;
}

void take_seen_elsewhere(AdjustedNetwork& network, const std::vector<Offered<SeenFiguresSource>>& campaigns,
                         Problems& problems) {
    std::map<FigureKey, SeenElsewhere> figures;
    std::vector<std::size_t> figure_of;
    std::vector<evidence::TakenFactor> factors;
    Message kept;
    for (AdjustedReading& reading : network.readings) {
        const FigureKey key = key_of(network, reading);
        const auto [known, added] = figures.try_emplace(key);
        SeenElsewhere& seen = known->second;
        if (added && !key.is_stated_of_point) seen = seen_elsewhere(campaigns, reading);
        if (added && !seen.figure) kept += Message(kept.empty() ? "" : ", ") + words_of_figure(key);
        figure_of.push_back(factors.size());
        factors.emplace_back();
        if (!seen.figure) continue;
        const SeenFigureOfReadings& figure = *seen.figure;
        factors.back() = {figure.u ? *figure.u / reading.u : figure.factor, figure.degrees_of_freedom};
    }
    if (!kept.empty())
        problems.warning(adjustment_fields().place(&StatedAdjustment::seen_in),
                         tell<"%1 does not see these figures, so they stay as stated here: %2">(
                             names_of(campaigns), kept));
    for (const adjustment::CovarianceBlock& block : network.blocks)
        for (const std::size_t i : block.readings)
            if (factors[i].factor != factors[block.readings.front()].factor)
                return problems.error(
                    adjustment_fields().place(&StatedAdjustment::seen_in),
                    tell<"readings of figures that are seen elsewhere are correlated with others here">());
    scale(network, figure_of, factors);
    for (const auto& [key, seen] : figures)
        if (seen.campaigns.size() > 1) network.over_campaigns.push_back(over_campaigns(key, seen));
    for (AdjustedReading& reading : network.readings) {
        const SeenElsewhere& seen = figures.at(key_of(network, reading));
        if (!seen.figure) continue;
        reading.seen_in = seen.ids;
        reading.seen_in_name = seen.names;
        reading.estimate = seen.figure->estimate;
        reading.between = seen.between;
    }
}

}  // namespace covaria::network
