// The fields of "distance meter on a baseline", and what follows from them.
#include "core/kinds/sheets/distance_meter_setup.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace covaria::sheets {

namespace {

const Unit baseline_m = Unit::of("m"), baseline_mm = Unit::of("mm"), baseline_ppm = Unit::of("ppm");
constexpr std::size_t most_pillars = 100, most_distances = 20'000;

Columns<BaselineReading> reading_columns() {
    return Columns<BaselineReading>()
        .add(&BaselineReading::from, "from", "from", "Pillar of the instrument.")
        .add(&BaselineReading::to, "to", "to", "Pillar of the reflector.")
        .add(&BaselineReading::distance, "distance", "distance",
             "As read, with the correction for the atmosphere and without one for the zero.",
             {.unit = baseline_m, .range = {.low = 0.0, .low_open = true}, .observed = true})
        .add(&BaselineReading::height_difference, "height_difference", "height difference",
             "Of the reflector above the instrument, where the distance is a slope distance; empty: it is "
             "horizontal.",
             {.unit = baseline_m, .optional = true});
}

Columns<ReferenceLength> reference_columns() {
    return Columns<ReferenceLength>()
        .add(&ReferenceLength::pillar, "pillar", "pillar", "As in the readings.")
        .add(&ReferenceLength::distance, "distance", "distance", "From the pillar where the line begins.",
             {.unit = baseline_m, .range = {.low = 0.0, .low_open = true}})
        .add(&ReferenceLength::u, "u", "u",
             "Standard uncertainty of this length alone, beside what all share; empty: none.",
             {.unit = baseline_mm, .range = {.low = 0.0}, .optional = true});
}

void add_tests(Fields<DistanceMeterSetup>& fields) {
    fields.section("Statistical tests")
        .add(&DistanceMeterSetup::stated_s, "stated_s", "σ, stated or wanted",
             "Standard deviation of one distance that test a holds s against: of the maker, or what a job "
             "needs. Empty: no test a.",
             {.unit = baseline_mm, .range = {.low = 0.0, .low_open = true}, .optional = true})
        .add(&DistanceMeterSetup::other_s, "other_s", "s of another campaign",
             "Experimental standard deviation that test b compares s with: of another instrument or day. "
             "Empty: no test b.",
             {.unit = baseline_mm, .range = {.low = 0.0, .low_open = true}, .optional = true})
        .add(&DistanceMeterSetup::other_degrees_of_freedom, "other_degrees_of_freedom",
             "Its degrees of freedom", "Of the s of the other campaign: 14 for all pairs of seven pillars.",
             {.range = {.low = 1.0, .high = 1e6}, .default_value = Quantity{14.0, Unit{}}})
        .add(&DistanceMeterSetup::probability, "probability", "Probability of the tests",
             "1 − α: an instrument that is as good as stated passes a test with this probability.",
             {.range = {.low = 0.5, .high = 0.9999}, .default_value = Quantity{0.95, Unit{}}});
}

void add_scale(Fields<DistanceMeterSetup>& fields) {
    fields.section("Scale")
        .choice(&DistanceMeterSetup::with_scale, "scale", "Scale correction",
                "Readings alone say nothing of it: it needs lengths of the baseline that are known better.",
                {{false, "none", "not asked for"}, {true, "reference", "by reference lengths"}}, false)
        .table(&DistanceMeterSetup::reference, "reference", "Reference lengths",
               "Horizontal lengths from the pillar where the line begins, of a certificate.",
               reference_columns(), {.min_rows = 1})
        .add(&DistanceMeterSetup::u_reference_scale, "u_reference_scale", "u of the baseline's scale",
             "Relative standard uncertainty that all reference lengths share.",
             {.unit = baseline_ppm, .range = {.low = 0.0}, .default_value = Quantity{0.0, baseline_ppm}})
        .add(&DistanceMeterSetup::u_atmosphere, "u_atmosphere", "u of the correction for the atmosphere",
             "Relative standard uncertainty that all readings share: 1 °C or 3.5 hPa are about 1 ppm.",
             {.unit = baseline_ppm, .range = {.low = 0.0}, .default_value = Quantity{0.0, baseline_ppm}})
        .shown_where(&DistanceMeterSetup::with_scale, {true}, &DistanceMeterSetup::reference,
                     &DistanceMeterSetup::u_reference_scale, &DistanceMeterSetup::u_atmosphere);
}

/// Index of a pillar, which is added where it is new.
std::size_t pillar_of(DistanceMeterSetup& setup, const std::string& name) {
    const auto found = std::ranges::find(setup.pillars, name);
    if (found != setup.pillars.end()) return std::size_t(found - setup.pillars.begin());
    setup.pillars.push_back(name);
    return setup.pillars.size() - 1;
}

/// Places of the pillars, one after the other: each has two places beside one that stands already, and the
/// readings to others say which.
class Arrangement {
public:
    explicit Arrangement(DistanceMeterSetup& setup)
        : setup_(setup), along_(setup.pillars.size()), placed_(setup.pillars.size(), false) {
        placed_[0] = true;
    }

    /// False: readings do not connect all pillars.
    bool arrange() {
        for (std::size_t k = 1; k < along_.size(); ++k) {
            const auto next = most_connected();
            if (!next) return false;
            along_[*next] = place_of(*next);
            placed_[*next] = true;
        }
        sort();
        return true;
    }

private:
    /// All readings between a pillar and those that stand: their places and the distances.
    std::vector<std::pair<double, double>> seen_from(std::size_t pillar) const {
        std::vector<std::pair<double, double>> seen;
        for (std::size_t i = 0; i < setup_.places.size(); ++i) {
            const auto [a, b] = setup_.places[i];
            const double distance = setup_.readings[i].horizontal();
            if (a == pillar && placed_[b]) seen.emplace_back(along_[b], distance);
            if (b == pillar && placed_[a]) seen.emplace_back(along_[a], distance);
        }
        return seen;
    }

    std::optional<std::size_t> most_connected() const {
        std::vector<std::size_t> seen(placed_.size(), 0);
        for (const auto& [a, b] : setup_.places) {
            seen[a] += !placed_[a] && placed_[b] ? 1u : 0u;
            seen[b] += !placed_[b] && placed_[a] ? 1u : 0u;
        }
        const auto most = std::ranges::max_element(seen);
        if (*most == 0) return std::nullopt;
        return std::size_t(most - seen.begin());
    }

    double place_of(std::size_t pillar) const {
        const auto seen = seen_from(pillar);
        const auto misfit = [&](double place) {
            double sum = 0.0;
            for (const auto& [other, distance] : seen) sum += std::abs(std::abs(place - other) - distance);
            return sum;
        };
        const double beyond = seen.front().first + seen.front().second;
        const double before = seen.front().first - seen.front().second;
        return misfit(before) < misfit(beyond) ? before : beyond;
    }

    /// The line begins at the end where the first reading was made from, or the nearer one to it.
    void sort() {
        const auto [low, high] = std::ranges::minmax(along_);
        const double sign = along_[0] - low <= high - along_[0] ? 1.0 : -1.0;
        std::vector<std::size_t> order(along_.size()), rank(along_.size());
        for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
        std::ranges::stable_sort(order, {}, [&](std::size_t k) { return sign * along_[k]; });
        std::vector<std::string> names;
        for (std::size_t k = 0; k < order.size(); ++k) {
            rank[order[k]] = k;
            names.push_back(setup_.pillars[order[k]]);
            setup_.along.push_back(sign * (along_[order[k]] - along_[order[0]]));
        }
        setup_.pillars = std::move(names);
        for (auto& [from, to] : setup_.places) std::tie(from, to) = std::minmax({rank[from], rank[to]});
    }

    DistanceMeterSetup& setup_;
    std::vector<double> along_;
    std::vector<bool> placed_;
};

void check_readings(DistanceMeterSetup& setup, Problems& problems) {
    const auto& fields = distance_meter_fields();
    for (std::size_t row = 0; row < setup.readings.size(); ++row) {
        const BaselineReading& r = setup.readings[row];
        const std::size_t from = pillar_of(setup, r.from), to = pillar_of(setup, r.to);
        setup.places.emplace_back(from, to);
        if (from == to)
            problems.error(fields.place(&DistanceMeterSetup::readings, row, &BaselineReading::to),
                           tell<"a distance from pillar '%1' to itself">(r.from));
        if (!std::isfinite(r.distance * r.distance))
            problems.error(fields.place(&DistanceMeterSetup::readings, row, &BaselineReading::distance),
                           tell<"the distance in row %1 is too long">(row + 1));
        if (!(std::abs(r.height_difference) < r.distance))
            problems.error(
                fields.place(&DistanceMeterSetup::readings, row, &BaselineReading::height_difference),
                tell<"the height difference in row %1 is not shorter than the slope distance">(row + 1));
    }
    const std::string table = fields.place(&DistanceMeterSetup::readings);
    if (setup.pillars.size() > most_pillars || setup.readings.size() > most_distances)
        problems.error(table, tell<"%1 distances between %2 pillars are more than a baseline has: at most %3 "
                                   "between %4">(setup.readings.size(), setup.pillars.size(), most_distances,
                                                 most_pillars));
    else if (setup.pillars.size() < 3)
        problems.error(table, tell<"a zero offset needs distances between three pillars or more">());
    else if (!(setup.degrees_of_freedom() > 0.0))
        problems.error(
            table,
            tell<"%1 distances for %2 lengths and the zero offset leave nothing that would tell "
                 "the scatter: read more pairs of pillars">(setup.readings.size(), setup.pillars.size() - 1));
    else if (!problems.has_errors() && !Arrangement(setup).arrange())
        problems.error(table, tell<"the distances do not connect all pillars">());
}

void check_reference(const DistanceMeterSetup& setup, Problems& problems) {
    const auto& fields = distance_meter_fields();
    std::set<std::string> known;
    for (std::size_t row = 0; row < setup.reference.size() && setup.with_scale; ++row) {
        const std::string& pillar = setup.reference[row].pillar;
        const std::string place = fields.place(&DistanceMeterSetup::reference, row, &ReferenceLength::pillar);
        if (!known.insert(pillar).second)
            problems.error(place, tell<"pillar '%1' has two reference lengths">(pillar));
        else if (std::ranges::find(setup.pillars, pillar) == setup.pillars.end())
            problems.error(place, tell<"no reading is to or from pillar '%1'">(pillar));
        else if (pillar == setup.pillars.front())
            problems.error(place, tell<"reference lengths begin at pillar '%1'">(pillar));
    }
}

}  // namespace

double BaselineReading::horizontal() const {
    return std::sqrt((distance - height_difference) * (distance + height_difference));
}

const Fields<DistanceMeterSetup>& distance_meter_fields() {
    static const Fields<DistanceMeterSetup> fields = [] {
        Fields<DistanceMeterSetup> made;
        made.section("Readings")
            .table(&DistanceMeterSetup::readings, "readings", "Readings",
                   "Distances between pillars that stand on a line, best of all pairs, each with the "
                   "instrument set up anew.",
                   reading_columns(), {.min_rows = 4, .measured = true});
        add_tests(made);
        add_scale(made);
        return made;
    }();
    return fields;
}

std::optional<DistanceMeterSetup> read_distance_meter_setup(const SetupReader& reader,
                                                            const AssetLibrary& assets, Problems& problems) {
    DistanceMeterSetup setup = distance_meter_fields().read(reader, assets, problems);
    check_readings(setup, problems);
    check_reference(setup, problems);
    if (problems.has_errors()) return std::nullopt;
    return setup;
}

}  // namespace covaria::sheets
