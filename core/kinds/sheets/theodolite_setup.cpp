// The fields of "theodolite in rounds", and what follows from a row of readings.
#include "core/kinds/sheets/theodolite_setup.h"

#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

namespace covaria::sheets {

namespace {

using std::numbers::pi;

const Unit circle_deg = Unit::of("deg"), circle_arcsec = Unit::of("arcsec");
constexpr std::size_t most_readings = 1000;
constexpr double most_between_faces = 10.0 * pi / 180.0;  ///< beyond it a face or a target was confused

Columns<FaceReadings> face_columns() {
    const Further angle{.unit = circle_deg, .optional = true, .observed = true};
    return Columns<FaceReadings>()
        .add(&FaceReadings::series, "series", "series",
             "Number of the series; within one the instrument stands unchanged. Empty: 1.",
             {.optional = true})
        .add(&FaceReadings::set, "set", "set", "Number of the set (round) within its series.")
        .add(&FaceReadings::target, "target", "target", "Name of the target.")
        .add(&FaceReadings::direction_1, "Hz_I", "Hz I", "Horizontal circle in face I.", angle)
        .add(&FaceReadings::direction_2, "Hz_II", "Hz II", "Horizontal circle in face II.", angle)
        .add(&FaceReadings::zenith_1, "V_I", "V I", "Zenith angle in face I: 90° on the horizon.", angle)
        .add(&FaceReadings::zenith_2, "V_II", "V II", "Zenith angle in face II: 270° on the horizon.", angle);
}

Fields<DeviationTests> test_fields(const std::string& key, const std::string& of, double usual) {
    const Further angle{.unit = circle_arcsec, .range = {.low = 0.0, .low_open = true}, .optional = true};
    return Fields<DeviationTests>()
        .section("Tests")
        .add(&DeviationTests::stated, "stated_" + key, "σ of " + of + ", stated or wanted",
             "Standard deviation, measured once in both faces, that test a holds s against: of the maker, or "
             "what a job needs. Empty: no test a.",
             angle)
        .add(&DeviationTests::other, "other_" + key, "s of " + of + ", another campaign",
             "Experimental standard deviation that test b compares s with: of another instrument, observer "
             "or day. Empty: no test b.",
             angle)
        .add(&DeviationTests::other_degrees_of_freedom, "other_degrees_of_freedom_" + key,
             "Degrees of freedom of that s",
             "Of the s of the other campaign; the default is that of four series of three sets of five "
             "targets.",
             {.range = {.low = 1.0, .high = 1e6}, .default_value = Quantity{usual, Unit{}}});
}

struct CheckedRow {
    const FaceReadings& readings;
    std::size_t row;
    Problems& problems;

    void check_faces(std::optional<double> first, std::optional<double> second,
                     std::optional<double> FaceReadings::*place, double apart) const {
        const std::string where = theodolite_fields().place(&TheodoliteSetup::readings, row, place);
        if (first.has_value() != second.has_value())
            problems.error(where, tell<"'%1' in set %2 is read in one face only: a reading needs both">(
                                      readings.target, readings.set));
        else if (first && !(std::abs(apart) <= most_between_faces))
            problems.error(
                where,
                tell<"the faces of '%1' in set %2 differ by more than 10° from half a circle: check "
                     "the faces, the target and that V is a zenith angle">(readings.target, readings.set));
    }

    void check() const {
        const FaceReadings& r = readings;
        check_faces(
            r.direction_1, r.direction_2, &FaceReadings::direction_2,
            r.has_directions() ? std::remainder(*r.direction_2 - *r.direction_1 - pi, 2.0 * pi) : 0.0);
        check_faces(r.zenith_1, r.zenith_2, &FaceReadings::zenith_2, r.has_zeniths() ? 2.0 * r.index() : 0.0);
        if (r.has_zeniths() && !(*r.zenith_1 >= 0.0 && *r.zenith_1 <= pi))
            problems.error(
                theodolite_fields().place(&TheodoliteSetup::readings, row, &FaceReadings::zenith_1),
                tell<"the zenith angle of '%1' in set %2 in face I is not between 0° and 180°">(r.target,
                                                                                                r.set));
        if (!r.direction_1 && !r.direction_2 && !r.zenith_1 && !r.zenith_2)
            problems.error(theodolite_fields().place(&TheodoliteSetup::readings, row, &FaceReadings::target),
                           tell<"'%1' in set %2 has no reading">(r.target, r.set));
    }
};

void check_face_readings(const TheodoliteSetup& setup, Problems& problems) {
    std::set<std::tuple<std::string, std::string, std::string>> known;
    for (std::size_t row = 0; row < setup.readings.size(); ++row) {
        const FaceReadings& r = setup.readings[row];
        CheckedRow{r, row, problems}.check();
        if (!known.emplace(r.series, r.set, r.target).second)
            problems.error(theodolite_fields().place(&TheodoliteSetup::readings, row, &FaceReadings::target),
                           tell<"'%1' is there twice in set %2 of series %3">(r.target, r.set, r.series));
    }
    if (setup.readings.size() > most_readings)
        problems.error(
            theodolite_fields().place(&TheodoliteSetup::readings),
            tell<"%1 rows of readings are more than the most, %2">(setup.readings.size(), most_readings));
}

}  // namespace

double FaceReadings::direction() const {
    return *direction_1 + 0.5 * std::remainder(*direction_2 - *direction_1 - pi, 2.0 * pi);
}

double FaceReadings::zenith() const {
    return *zenith_1 - index();
}

double FaceReadings::index() const {
    return 0.5 * std::remainder(*zenith_1 + *zenith_2, 2.0 * pi);
}

const Fields<TheodoliteSetup>& theodolite_fields() {
    static const Fields<TheodoliteSetup> fields = [] {
        Fields<TheodoliteSetup> made;
        made.section("Readings")
            .table(&TheodoliteSetup::readings, "readings", "Readings",
                   "A row for each target of each set, with the readings in both faces: directions, zenith "
                   "angles, or both. Typed, pasted or from a CSV file.",
                   face_columns(), {.min_rows = 2, .measured = true})
            .part(&TheodoliteSetup::direction_tests, test_fields("direction", "a direction", 32.0))
            .part(&TheodoliteSetup::zenith_tests, test_fields("zenith", "a zenith angle", 40.0))
            .section("Tests")
            .add(&TheodoliteSetup::probability, "probability", "Probability of the tests",
                 "1 − α: an instrument that is as good as stated passes a test with this probability.",
                 {.range = {.low = 0.5, .high = 0.9999}, .default_value = Quantity{0.95, Unit{}}});
        return made;
    }();
    return fields;
}

std::optional<TheodoliteSetup> read_theodolite_setup(const SetupReader& reader, const AssetLibrary& assets,
                                                     Problems& problems) {
    TheodoliteSetup setup = theodolite_fields().read(reader, assets, problems);
    check_face_readings(setup, problems);
    if (problems.has_errors()) return std::nullopt;
    return setup;
}

}  // namespace covaria::sheets
