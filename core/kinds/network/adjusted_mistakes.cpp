// Mistakes that would explain why readings contradict each other: each is undone in turn, and proposed where
// the readings agree then. Units that were mixed up, names and coordinates that were exchanged.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "core/kinds/network/adjusted_datum_fit.h"
#include "core/kinds/network/adjusted_space_start.h"
#include "core/math/special_quantiles.h"

namespace covaria::network {

namespace {

constexpr double metres_per_millimetre = 1e-3, metres_per_foot = 0.3048;

struct Mistake {
    Message words;
    std::function<bool(AdjustedNetwork&)> undo;  ///< false where it cannot have been made
    std::vector<std::size_t> scaled = {};        ///< readings that are made smaller
    double factor = 1.0;
    bool is_of_datum =
        false;  ///< whether coordinates of the datum agree with the readings only where it is undone
};

/// The sum of squares of the residuals over their u, those of scaled readings as they were typed: a network
/// that is made smaller as a whole has smaller residuals, and agrees no better.
double sum_as_typed(const AdjustedNetwork& network, const Mistake& mistake) {
    Eigen::VectorXd r = residuals_of(network, network.state.data());
    for (const std::size_t i : mistake.scaled) r[static_cast<Eigen::Index>(i)] /= mistake.factor;
    return (network.whitening * r).squaredNorm();
}

/// Readings that were typed in one unit together.
struct TypedTogether {
    Message angles, lengths;
    std::function<bool(const AdjustedReading&)> has;
};

bool is_read_length(const AdjustedReading& r) {
    return r.kind == ReadingKind::slope_distance || r.kind == ReadingKind::horizontal_distance ||
           r.kind == ReadingKind::height_difference ||
           (r.kind >= ReadingKind::dx && r.kind <= ReadingKind::dz);
}
bool is_read_angle(const AdjustedReading& r) {
    return is_read(r.kind) && is_of_angle(r.kind);
}

/// Multiplies what was read; false where a zenith angle leaves the circle.
bool scale(AdjustedReading& r, double factor) {
    constexpr double turn = 2.0 * std::numbers::pi;
    if (r.kind != ReadingKind::zenith_angle) {
        const double back = r.face_two ? 0.5 * turn : 0.0;
        r.value = factor * (r.value + back) - back;
        return true;
    }
    const double read = factor * (r.face_two ? turn - r.value : r.value);
    r.face_two = read > 0.5 * turn;
    r.value = r.face_two ? turn - read : read;
    return r.value > 0.0;
}

/// Units that were mixed up.
class UnitMistakes {
public:
    UnitMistakes(const AdjustedNetwork& network, std::vector<Mistake>& mistakes)
        : network_(network), mistakes_(mistakes) {}

    void add_of_sets() {
        constexpr double degrees_per_gon = 0.9;
        std::set<std::vector<std::size_t>> tried;
        for (const TypedTogether& set : typed_together())
            for (const bool angle : {true, false}) {
                std::vector<std::size_t> readings;
                for (std::size_t i = 0; i < network_.readings.size(); ++i) {
                    const AdjustedReading& r = network_.readings[i];
                    if (set.has(r) && (angle ? is_read_angle(r) : is_read_length(r))) readings.push_back(i);
                }
                if (readings.empty() || !tried.insert(readings).second) continue;
                const Message& words = angle ? set.angles : set.lengths;
                const double small = angle ? degrees_per_gon : metres_per_millimetre;
                add_unit(angle ? tell<"the readings agree if %1 are gon that were typed as degrees">(words)
                               : tell<"the readings agree if %1 are mm that were typed as m">(words),
                         readings, small);
                add_unit(angle ? tell<"the readings agree if %1 are degrees that were typed as gon">(words)
                               : tell<"the readings agree if %1 are m that were typed as mm">(words),
                         readings, 1.0 / small);
                if (!angle)
                    add_unit(tell<"the readings agree if %1 are feet that were typed as m">(words), readings,
                             metres_per_foot);
            }
    }

    /// Single lengths in mm, the largest first: a thousand times too large one is among them.
    void add_of_readings() {
        std::vector<std::pair<double, std::size_t>> lengths;
        for (std::size_t i = 0; i < network_.readings.size(); ++i)
            if (const AdjustedReading& r = network_.readings[i]; is_read_length(r))
                lengths.emplace_back(-std::abs(r.value), i);
        std::ranges::sort(lengths);
        for (const auto& [size, i] : lengths)
            add_unit(tell<"the readings agree if the %1 is in mm and was typed as m">(
                         words_of(network_, network_.readings[i])),
                     {i}, metres_per_millimetre);
    }

private:
    /// All readings, those of each kind, from each station, of each instrument; each set once.
    std::vector<TypedTogether> typed_together() const {
        std::vector<TypedTogether> sets{
            {tell<"all angles">(), tell<"all lengths">(), [](const AdjustedReading&) { return true; }}};
        const auto add_kind = [&](ReadingKind kind, const Message& words) {
            sets.push_back({words, words, [kind](const AdjustedReading& r) { return r.kind == kind; }});
        };
        add_kind(ReadingKind::direction, tell<"the directions">());
        add_kind(ReadingKind::zenith_angle, tell<"the zenith angles">());
        add_kind(ReadingKind::slope_distance, tell<"the slope distances">());
        add_kind(ReadingKind::horizontal_distance, tell<"the horizontal distances">());
        add_kind(ReadingKind::height_difference, tell<"the height differences">());
        std::set<std::size_t> stations;
        std::set<std::string> instruments;
        for (const AdjustedReading& r : network_.readings) {
            if (!is_read_angle(r) && !is_read_length(r)) continue;
            stations.insert(r.from);
            if (!r.instrument.empty()) instruments.insert(r.instrument);
        }
        for (const std::size_t station : stations) {
            const std::string& name = network_.points[station].name;
            sets.push_back({tell<"the angles read from %1">(name), tell<"the lengths read from %1">(name),
                            [station](const AdjustedReading& r) { return r.from == station; }});
        }
        for (const std::string& instrument : instruments)
            sets.push_back({tell<"the angles of %1">(instrument), tell<"the lengths of %1">(instrument),
                            [instrument](const AdjustedReading& r) { return r.instrument == instrument; }});
        return sets;
    }

    void add_unit(Message words, const std::vector<std::size_t>& readings, double factor) {
        mistakes_.push_back({std::move(words),
                             [readings, factor](AdjustedNetwork& network) {
                                 return std::ranges::all_of(readings, [&](std::size_t i) {
                                     return scale(network.readings[i], factor);
                                 });
                             },
                             factor < 1.0 ? readings : std::vector<std::size_t>(), factor});
    }

    const AdjustedNetwork& network_;
    std::vector<Mistake>& mistakes_;
};

class Mistakes {
public:
    explicit Mistakes(const AdjustedNetwork& network) : network_(network) {
        UnitMistakes units(network_, mistakes_);
        units.add_of_sets();
        add_sense();
        add_units_of_coordinates();
        add_coordinates();
        add_names();
        units.add_of_readings();
    }

    std::vector<Message> explaining() const {
        constexpr std::size_t most_said = 3, most_work = 20'000;  // trials times readings
        std::vector<Message> said;
        // Places in space are found from many beginnings, which takes as long as so many trials.
        constexpr std::size_t as_many = 100;
        const bool in_space =
            std::ranges::any_of(tied_by_slopes_alone(network_), [](char alone) { return alone; });
        std::size_t work = 0;
        bool says_coordinates = false;
        for (const Mistake& mistake : mistakes_) {
            work += (in_space ? as_many : 1) * network_.readings.size();
            if (work > most_work || said.size() == most_said) break;
            // Coordinates of some points would explain what those of all do.
            if (mistake.is_of_datum && says_coordinates) continue;
            if (!explains(mistake)) continue;
            says_coordinates = says_coordinates || mistake.is_of_datum;
            said.push_back(mistake.words);
        }
        return said;
    }

private:
    /// Whether the readings agree once the mistake is undone.
    bool explains(const Mistake& mistake) const {
        AdjustedNetwork network = network_;
        network.state = network.stated;
        network.adjusted = nullptr;
        network.unsolved = nullptr;
        if (!mistake.undo(network)) return false;
        Problems problems;
        find_start(network, problems);
        if (!problems.has_errors()) adjust(network, problems);
        if (problems.has_errors() || !network.adjusted) return false;
        constexpr double much_less = 0.1;
        const auto datum = datum_fit(network);
        const bool is_of_size = datum && std::abs(std::log(datum->scale)) < 0.05 && datum->misfit < 0.05;
        if (datum && mistake.is_of_datum && !is_of_size) return false;
        if (!is_of_size && !(sum_as_typed(network, mistake) < much_less * sum_as_typed(network_, {})))
            return false;
        const adjustment::Reliability& found = network.reliability;
        return found.degrees_of_freedom > 0 &&
               chi_squared_upper_tail(found.sum_of_squares, found.degrees_of_freedom) >
                   adjustment::significance;
    }

    void add_sense() {
        if (std::ranges::none_of(network_.readings, [](const AdjustedReading& r) {
                return is_read_angle(r) && r.kind != ReadingKind::zenith_angle;
            }))
            return;
        mistakes_.push_back(
            {tell<"the readings agree if angles grow the other way round: the sense of angles, "
                  "clockwise or counter-clockwise, is probably the other one, or x and y are "
                  "exchanged">(),
             [](AdjustedNetwork& network) {
                 network.clockwise = !network.clockwise;
                 return true;
             }});
    }

    /// Coordinates of all points, of those that are known, and of each.
    void add_units_of_coordinates() {
        std::vector<std::size_t> all, known;
        for (std::size_t p = 0; p < network_.points.size(); ++p) {
            const AdjustedPoint& point = network_.points[p];
            if (std::ranges::none_of(point.typed, [](const auto& c) { return c.has_value(); })) continue;
            all.push_back(p);
            if (is_known(p)) known.push_back(p);
        }
        const auto add = [&](const std::vector<std::size_t>& points, const Message& whose) {
            if (points.empty()) return;
            for (const auto& [words, factor] :
                 {std::pair(
                      tell<"the readings agree if the coordinates of %1 are mm that were typed as m">(whose),
                      metres_per_millimetre),
                  std::pair(tell<"the readings agree if the coordinates of %1 are feet that were typed as m">(
                                whose),
                            metres_per_foot)})
                mistakes_.push_back({.words = words,
                                     .undo =
                                         [points, factor](AdjustedNetwork& network) {
                                             for (const std::size_t p : points)
                                                 scale_coordinates(network, p, factor);
                                             return true;
                                         },
                                     .is_of_datum = true});
        };
        add(all, tell<"all points">());
        if (known.size() > 1 && known.size() < all.size()) add(known, tell<"the known points">());
        if (all.size() > 1)
            for (const std::size_t p : all) add({p}, network_.points[p].name);
    }

    static void scale_coordinates(AdjustedNetwork& network, std::size_t p, double factor) {
        for (std::size_t c = 0; c < 3; ++c) {
            auto& typed = network.points[p].typed[c];
            if (!typed) continue;
            *typed *= factor;
            const auto place = static_cast<Eigen::Index>(network.at(p, c));
            network.state[place] = network.stated[place] = *typed;
        }
        for (AdjustedReading& r : network.readings)
            if (is_stated_coordinate(r) && r.from == p) r.value *= factor;
    }

    static bool is_stated_coordinate(const AdjustedReading& r) {
        return (r.kind == ReadingKind::x || r.kind == ReadingKind::y || r.kind == ReadingKind::z) &&
               r.row == AdjustedReading::no_round;
    }

    bool is_known(std::size_t point) const {
        return std::ranges::any_of(network_.points[point].role, [](CoordinateRole role) {
            return role == CoordinateRole::fixed || role == CoordinateRole::stated;
        });
    }

    /// Exchanges the coordinates of each two points of which the same is known.
    void add_coordinates() {
        for (std::size_t a = 0; a < network_.points.size(); ++a)
            for (std::size_t b = a + 1; b < network_.points.size() && is_known(a); ++b)
                if (is_known(b) && network_.points[a].role == network_.points[b].role)
                    mistakes_.push_back(
                        {tell<"the readings agree if the coordinates of %1 and %2 are exchanged">(
                             network_.points[a].name, network_.points[b].name),
                         [a, b](AdjustedNetwork& network) {
                             exchange_coordinates(network, a, b);
                             return true;
                         }});
    }

    static void exchange_coordinates(AdjustedNetwork& network, std::size_t a, std::size_t b) {
        for (Eigen::VectorXd* values : {&network.state, &network.stated})
            values->segment<3>(static_cast<Eigen::Index>(3 * a))
                .swap(values->segment<3>(static_cast<Eigen::Index>(3 * b)));
        std::swap(network.points[a].placed, network.points[b].placed);
        std::swap(network.points[a].typed, network.points[b].typed);
        for (AdjustedReading& r : network.readings) {
            if (is_stated_coordinate(r) && (r.from == a || r.from == b))
                r.from = r.to = r.second = r.from == a ? b : a;
        }
    }

    /// Exchanges the names of each two targets of a station.
    void add_names() {
        std::vector<std::set<std::size_t>> targets(network_.points.size());
        for (const AdjustedReading& r : network_.readings) {
            if (!is_read(r.kind) || r.from == r.to) continue;
            targets[r.from].insert({r.to, r.second});
        }
        for (std::size_t station = 0; station < targets.size(); ++station)
            for (auto a = targets[station].begin(); a != targets[station].end(); ++a)
                for (auto b = std::next(a); b != targets[station].end(); ++b)
                    mistakes_.push_back({words_of_exchange(network_, station, *a, *b),
                                         [station, a = *a, b = *b](AdjustedNetwork& network) {
                                             const auto exchanged = [&](std::size_t p) {
                                                 return p == a ? b : p == b ? a : p;
                                             };
                                             for (AdjustedReading& r : network.readings) {
                                                 if (!is_read(r.kind) || r.from != station || r.from == r.to)
                                                     continue;
                                                 r.to = exchanged(r.to);
                                                 r.second = exchanged(r.second);
                                             }
                                             return true;
                                         }});
    }

    const AdjustedNetwork& network_;
    std::vector<Mistake> mistakes_;
};

}  // namespace

std::vector<Message> likely_mistakes(const AdjustedNetwork& network) {
    constexpr std::size_t most_readings = 1000;
    if (network.readings.size() > most_readings) return {};
    return Mistakes(network).explaining();
}

}  // namespace covaria::network
