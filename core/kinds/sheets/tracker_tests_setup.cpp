// The fields of "two-face and length tests of a tracker", their checks, and the decisions.
#include "core/kinds/sheets/tracker_tests_setup.h"

#include <algorithm>
#include <cmath>

#include "core/kinds/sheets/verdict.h"
#include "core/math/normal_quantile.h"

namespace covaria::sheets {

namespace {

using StatedTests = TrackerTestsSetup;
const Unit tracker_mm = Unit::of("mm"), tracker_m = Unit::of("m"), tracker_um = Unit::of("um"),
           tracker_deg = Unit::of("deg"), per_metre = Unit::of("um/m");

Columns<TrackerTest> test_columns() {
    const Range not_negative{.low = 0.0};
    return Columns<TrackerTest>()
        .add(&TrackerTest::position, "position", "position", "Number or name of the position, unique.")
        .choice(&TrackerTest::kind, "test", "test",
                "Two-face: a fixed target read in both faces. Length: a reference length.",
                {{TrackerTestKind::two_face, "two-face", "two-face"},
                 {TrackerTestKind::length, "length", "length"}})
        .add(&TrackerTest::value, "value", "value",
             "Two-face: distance across the beam between the readings of both faces. Length: as measured.",
             {.unit = tracker_mm, .range = not_negative, .observed = true})
        .add(&TrackerTest::reference, "reference", "reference", "Calibrated length, of a length test.",
             {.unit = tracker_mm, .range = not_negative, .optional = true})
        .add(&TrackerTest::range, "range", "range",
             "Distance of the target, or of the middle of the length, from the tracker.",
             {.unit = tracker_m, .range = not_negative})
        .add(&TrackerTest::azimuth, "azimuth", "azimuth", "Its horizontal angle; empty: 0.",
             {.unit = tracker_deg, .optional = true})
        .add(&TrackerTest::elevation, "elevation", "elevation", "Its angle above the horizon; empty: 0.",
             {.unit = tracker_deg, .optional = true})
        .add(&TrackerTest::u, "u", "u",
             "Standard uncertainty of this test value; empty: that of its kind, as below.",
             {.unit = tracker_um, .range = not_negative, .optional = true})
        .add(&TrackerTest::mpe, "mpe", "MPE",
             "Limit for this position; empty: it follows from constant and slope, as below.",
             {.unit = tracker_um, .range = {.low = 0.0, .low_open = true}, .optional = true});
}

void add_limits(Fields<StatedTests>& fields) {
    const Further limit{.unit = tracker_um, .range = {.low = 0.0, .low_open = true}, .optional = true};
    const Further slope{.unit = per_metre, .range = {.low = 0.0}, .default_value = Quantity{0.0, per_metre}};
    fields.section("Limits")
        .add(&StatedTests::two_face_constant, "two_face_constant", "MPE two-face, constant",
             "As the maker states it for a two-face test; empty: every two-face test has its own MPE.", limit)
        .add(&StatedTests::two_face_slope, "two_face_slope", "MPE two-face, per metre",
             "Times the range of the target.", slope)
        .add(&StatedTests::length_constant, "length_constant", "MPE length, constant",
             "As the maker states it; empty: every length has its own MPE.", limit)
        .add(&StatedTests::length_slope, "length_slope", "MPE length, per metre",
             "Times the reference length.", slope);
}

void add_uncertainties(Fields<StatedTests>& fields) {
    const Further own{.unit = tracker_um, .range = {.low = 0.0}, .default_value = Quantity{0.0, tracker_um}};
    fields.section("Uncertainty of the test values")
        .add(
            &StatedTests::u_two_face, "u_two_face", "u of a two-face value",
            "Standard uncertainty of what the test adds: seat of the reflector, motion of its mount. Not the "
            "scatter of the tracker, which is tested.",
            own)
        .add(&StatedTests::u_length, "u_length", "u of a length",
             "Standard uncertainty of what the test adds to each length: calibration, mounting, temperature. "
             "Not the scatter of the tracker.",
             own)
        .add(
            &StatedTests::u_reference_scale, "u_reference_scale", "u of the scale of the references",
            "Relative standard uncertainty that all reference lengths share.",
            {.unit = Unit::of("ppm"), .range = {.low = 0.0}, .default_value = Quantity{0.0, Unit::of("ppm")}})
        .add(&StatedTests::probability, "probability", "Probability of a decision",
             "A position conforms where this is the probability that its error is within the MPE.",
             {.range = {.low = 0.5, .high = 0.9999}, .default_value = Quantity{0.95, Unit{}}});
}

void check_tests(const StatedTests& setup, Problems& problems) {
    for (std::size_t row = 0; row < setup.tests.size(); ++row) {
        const TrackerTest& t = setup.tests[row];
        const auto& fields = tracker_tests_fields();
        const bool is_length = t.kind == TrackerTestKind::length;
        if (std::ranges::count(setup.tests, t.position, &TrackerTest::position) > 1)
            problems.error(fields.place(&StatedTests::tests, row, &TrackerTest::position),
                           tell<"there are two tests of position '%1'">(t.position));
        if (is_length && !(t.reference > 0.0))
            problems.error(fields.place(&StatedTests::tests, row, &TrackerTest::reference),
                           tell<"the length at position '%1' has no reference">(t.position));
        if (!is_length && t.reference > 0.0)
            problems.error(fields.place(&StatedTests::tests, row, &TrackerTest::reference),
                           tell<"the two-face test of position '%1' has a reference length">(t.position));
        if (!t.mpe && !(is_length ? setup.length_constant : setup.two_face_constant))
            problems.error(fields.place(&StatedTests::tests, row, &TrackerTest::mpe),
                           tell<"nothing says the MPE of position '%1'">(t.position));
    }
}

/// P(|E| <= MPE) for a normal test value (ISO 14253-1, JCGM 106).
double within(double error, double u, double mpe) {
    if (!(u > 0.0)) return std::abs(error) <= mpe ? 1.0 : 0.0;
    return normal_distribution_function((mpe - error) / u) - normal_distribution_function((-mpe - error) / u);
}

}  // namespace

Eigen::Vector3d TrackerTest::place() const {
    return range * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                                   std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
}

double TrackerTestsSetup::mpe(const TrackerTest& test) const {
    if (test.mpe) return *test.mpe;
    return test.kind == TrackerTestKind::two_face ? *two_face_constant + two_face_slope * test.range
                                                  : *length_constant + length_slope * test.reference;
}

double TrackerTestsSetup::u_own(const TrackerTest& test) const {
    return test.u.value_or(test.kind == TrackerTestKind::two_face ? u_two_face : u_length);
}

double TrackerTestsSetup::u(const TrackerTest& test) const {
    const double shared = test.kind == TrackerTestKind::length ? u_reference_scale * test.reference : 0.0;
    return std::hypot(u_own(test), shared);
}

const Fields<TrackerTestsSetup>& tracker_tests_fields() {
    static const Fields<TrackerTestsSetup> fields = [] {
        Fields<TrackerTestsSetup> made;
        made.section("Tests").table(&StatedTests::tests, "tests", "Tests",
                                    "A row for every position, typed, pasted or from a CSV file.",
                                    test_columns(), {.min_rows = 1, .measured = true});
        add_limits(made);
        add_uncertainties(made);
        return made;
    }();
    return fields;
}

std::optional<TrackerTestsSetup> read_tracker_tests_setup(const SetupReader& reader,
                                                          const AssetLibrary& assets, Problems& problems) {
    TrackerTestsSetup setup = tracker_tests_fields().read(reader, assets, problems);
    check_tests(setup, problems);
    if (problems.has_errors()) return std::nullopt;
    return setup;
}

std::vector<Table> tracker_tests_tables(const TrackerTestsSetup& setup) {
    Table table{"decisions", "Decisions after ISO 14253-1"};
    table.add("position");
    table.add("test");
    table.add("E").in(tracker_um).symbol().fixed(1);
    table.add("U").in(tracker_um).symbol().uncertainty();
    table.add("MPE").in(tracker_um).symbol().fixed(1);
    table.add(known_text<"probability of conformity">()).in(Unit::of("%")).figure(3);
    table.add("decision");
    std::size_t conforming = 0, failing = 0;
    for (const TrackerTest& t : setup.tests) {
        const double p = within(t.error(), setup.u(t), setup.mpe(t));
        const Decision decision(p, setup.probability);
        conforming += decision.conforms ? 1u : 0u;
        failing += decision.fails ? 1u : 0u;
        table.row({t.position, t.kind == TrackerTestKind::two_face ? tell<"two-face">() : tell<"length">(),
                   t.error(), 2.0 * setup.u(t), setup.mpe(t), p, decision.verdict()});
    }
    table.notes.push_back(conforming == setup.tests.size() ? tell<"The tracker conforms at every position.">()
                          : failing > 0                    ? tell<"The tracker does not conform.">()
                                        : tell<"Some positions are not decided: the test is not good enough "
                                               "to tell.">());
    return {table};
}

}  // namespace covaria::sheets
