// Evaluation of artefacts and instruments: Eqs 1-6 of Porath et al. with their options, Tables 1 and 2.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/kinds/instruments/sensor.h"
#include "core/kinds/points/error_budget.h"
#include "core/kinds/points/point_uncertainty.h"
#include "core/kinds/registries.h"
#include "tests/core/table_rows.h"

namespace covaria::asset_evaluation_test {
namespace {

Quantity mm(double value) {
    return {value, Unit::of("mm")};
}

SetupTable table_of(const AssetDescriptor& d, const std::string& key,
                    std::vector<std::vector<SetupCell>> rows) {
    SetupTable table;
    for (const ColumnSpec& column : d.schema.find(key)->columns) table.units.push_back(column.unit);
    table.rows = std::move(rows);
    return table;
}

std::unique_ptr<Asset> make(const AssetDescriptor& d, const Setup& s, Problems& problems) {
    check_setup(d.schema, s, problems);
    if (problems.has_errors()) return nullptr;
    return d.create(SetupReader(d.schema, s), {}, problems);
}

std::unique_ptr<Asset> make(const AssetDescriptor& d, const Setup& s) {
    Problems problems;
    auto asset = make(d, s, problems);
    for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << ": " << p.message.english();
    return asset;
}

const AssetDescriptor& artefact() {
    return *find_asset_kind("artefact-points");
}

const AssetDescriptor& length_standard() {
    return *find_asset_kind("length-standard");
}

// Table 1 as printed.
covaria::Setup table_1() {
    covaria::Setup s;
    s.values["evaluation"] = std::string("components");
    s.values["components"] = table_of(artefact(), "components",
                                      {{std::string("x"), .005, .006, .066, .002, {}},
                                       {std::string("y"), .005, .006, .088, .134, {}},
                                       {std::string("z"), .005, .006, .047, -.093, {}}});
    return s;
}

covaria::Setup table_2() {
    covaria::Setup s;
    s.values["length"] = mm(1120);
    s.values["evaluation"] = std::string("components");
    s.values["components"] = table_of(length_standard(), "components", {{.005, .008, .148, .184, {}}});
    return s;
}

double u_of(const Asset& asset, std::size_t coordinate) {
    return offers<PointUncertaintySource>(&asset)
        ->deviations({0, 0, 0})
        .at(coordinate)
        .component.distribution.standard_uncertainty();
}

// u_c(x) and u_c(z) *reproduce* within the rounding of the components; u_c(y) *differs, because* the
// published 0.110 does not follow from its own row.
TEST(Tables1And2, CombinedUncertainties) {
    const auto plate = make(artefact(), table_1());
    EXPECT_NEAR(u_of(*plate, 0), .0665e-3, .00005e-3);
    EXPECT_NEAR(u_of(*plate, 1), .1605e-3, .00005e-3);
    EXPECT_NEAR(u_of(*plate, 2), .1045e-3, .00005e-3);
    EXPECT_GT(std::abs(u_of(*plate, 1) - .110e-3), .0500e-3);
    const auto bar = make(length_standard(), table_2());
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(u_of(*bar, i), .2363e-3, .00005e-3);
}

TEST(Tables1And2, TreatmentsOfTheBias) {
    covaria::Setup s = table_1();
    s.values["bias"] = std::string("ignored");
    EXPECT_NEAR(u_of(*make(artefact(), s), 1), std::sqrt(25 + 36 + 88 * 88) * 1e-6, 1e-12);
    s.values["bias"] = std::string("corrected");
    Problems problems;
    EXPECT_EQ(make(artefact(), s, problems), nullptr);  // n is not known
    EXPECT_NE(problems.items().front().message.english().find("number of observations"), std::string::npos);
    for (auto& row : std::get<SetupTable>(s.values["components"]).rows) row[5] = 16.0;
    EXPECT_NEAR(u_of(*make(artefact(), s), 1), std::sqrt(25 + 36 + 88 * 88 * (1 + 1 / 16.0)) * 1e-6, 1e-12);
}

TEST(Tables1And2, DegreesOfFreedomComeFromTheVariability) {
    covaria::Setup s = table_1();
    for (auto& row : std::get<SetupTable>(s.values["components"]).rows) row[5] = 12.0;
    const auto d = offers<PointUncertaintySource>(make(artefact(), s))->deviations({0, 0, 0});
    EXPECT_NEAR(d[1].component.degrees_of_freedom, 11 * std::pow(25761.0 / 7744.0, 2), 1e-9);
    const auto few = offers<PointUncertaintySource>(make(artefact(), table_1()))->deviations({0, 0, 0});
    EXPECT_TRUE(std::isinf(few[0].component.degrees_of_freedom));
}

TEST(Tables1And2, ALengthIsADifferenceOfTwoPoints) {
    covaria::Setup s = table_2();
    s.values["coordinate_uncertainty"] = std::string("divided-by-sqrt2");
    EXPECT_NEAR(u_of(*make(length_standard(), s), 0), .2363e-3 / std::numbers::sqrt2, .00005e-3);
}

TEST(Tables1And2, SystematicPartsInCommonKeepTheCombinedUncertainty) {
    covaria::Setup s = table_1();
    s.values["systematic_common"] = true;
    const auto deviations = offers<PointUncertaintySource>(make(artefact(), s))->deviations({0, 0, 0});
    ASSERT_EQ(deviations.size(), 12u);
    double u2 = 0.0;
    int common = 0;
    for (const PointDeviation& d : deviations)
        if (d.direction == Eigen::Vector3d::UnitY()) {
            u2 += std::pow(d.component.distribution.standard_uncertainty(), 2);
            common += d.common ? 1 : 0;
        }
    EXPECT_EQ(common, 3);
    EXPECT_NEAR(std::sqrt(u2), u_of(*make(artefact(), table_1()), 1), 1e-15);
}

// Three points on a plane; errors that are easily added by hand.
covaria::Setup small_artefact() {
    covaria::Setup s;
    s.values["points"] = table_of(artefact(), "points",
                                  {{std::string("1"), 0.0, 0.0, 0.0, {}},
                                   {std::string("2"), 300.0, 0.0, 0.0, {}},
                                   {std::string("3"), 0.0, 400.0, 0.0, {}},
                                   {std::string("4"), 300.0, 400.0, 0.0, {}}});
    s.values["observations"] = table_of(artefact(), "observations",
                                        {{std::string("1"), 1.0, 9.0, 9.0, 9.0},
                                         {std::string("2"), 1.0, 300.1, 9.0, 9.0},
                                         {std::string("3"), 1.0, 0.2, 400.5, 9.0},
                                         {std::string("4"), 1.0, 300.3, 400.7, 0.01},
                                         {std::string("4"), 2.0, 300.3, 400.9, 0.03}});
    s.values["u_cal"] = mm(0.005);
    s.values["expansion"] = Quantity{23e-6, Unit::of("1/K")};
    s.values["temperature_deviation"] = Quantity{0.7, Unit::of("K")};
    return s;
}

double cell(const Asset& asset, std::size_t row, std::size_t column) {
    return test::si_of(test::rows_of(asset.evaluation().front()).at(row).at(column));
}

TEST(ArtefactPoints, EvaluatesObservationsWithoutTheDefiningCoordinates) {
    const auto asset = make(artefact(), small_artefact());
    EXPECT_EQ(cell(*asset, 0, 5), 4.0);  // n of x: points 2, 3, 4, 4
    EXPECT_EQ(cell(*asset, 1, 5), 3.0);
    EXPECT_EQ(cell(*asset, 2, 5), 2.0);
    EXPECT_NEAR(cell(*asset, 0, 4), .225e-3, 1e-12);
    EXPECT_NEAR(cell(*asset, 1, 4), .7e-3, 1e-12);
    EXPECT_NEAR(cell(*asset, 1, 3), .2e-3, 1e-12);
    EXPECT_NEAR(cell(*asset, 2, 3), .02e-3 / std::numbers::sqrt2, 1e-12);
    const double u_T = 0.5 * 23e-6 * 0.7 / std::numbers::sqrt3;  // largest distance 500 mm
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(cell(*asset, i, 2), u_T, 1e-15);
    EXPECT_EQ(asset->evaluation().size(), 2u);
    EXPECT_EQ(asset->layout().points.size(), 4u);
}

TEST(ArtefactPoints, TheLetterOfEq3TakesTheCoordinate) {
    covaria::Setup s = small_artefact();
    s.values["l_max"] = std::string("largest-coordinate");
    const auto asset = make(artefact(), s);
    EXPECT_NEAR(cell(*asset, 1, 2), 0.4 * 23e-6 * 0.7 / std::numbers::sqrt3, 1e-15);
    EXPECT_EQ(cell(*asset, 2, 2), 0.0);
}

TEST(ArtefactPoints, ExclusionsByPointOrNone) {
    covaria::Setup s = small_artefact();
    s.values["excluded"] = std::string("none");
    EXPECT_EQ(cell(*make(artefact(), s), 2, 5), 5.0);
    s.values["excluded"] = std::string("by-point");
    std::get<SetupTable>(s.values["points"]).rows[3][4] = std::string("xz");
    EXPECT_EQ(cell(*make(artefact(), s), 0, 5), 3.0);
    EXPECT_EQ(cell(*make(artefact(), s), 1, 5), 5.0);
    std::get<SetupTable>(s.values["points"]).rows[3][4] = std::string("xq");
    Problems problems;
    EXPECT_EQ(make(artefact(), s, problems), nullptr);
    EXPECT_EQ(problems.items().front().path, "/points/rows/3/defines");
}

TEST(ArtefactPoints, TemperatureIsCorrected) {
    covaria::Setup s = small_artefact();
    s.values["temperature"] = std::string("corrected");
    s.values["measured_temperature"] = Quantity{30.0, Unit::of("degC")};
    const double stretch = 1.0 + 23e-6 * 10.0;
    const double bias = ((300.1 + .2 + 300.3 + 300.3) / stretch - 900.0) / 4.0;
    EXPECT_NEAR(cell(*make(artefact(), s), 0, 4), bias * 1e-3, 1e-12);
}

TEST(ArtefactPoints, ProblemsNameTheRow) {
    covaria::Setup s = small_artefact();
    std::get<SetupTable>(s.values["observations"]).rows[2][0] = std::string("7");
    Problems problems;
    EXPECT_EQ(make(artefact(), s, problems), nullptr);
    EXPECT_EQ(problems.items().front().path, "/observations/rows/2/point");
    s = small_artefact();
    std::get<SetupTable>(s.values["points"]).rows[1][0] = std::string("1");
    Problems twice;
    EXPECT_EQ(make(artefact(), s, twice), nullptr);
    EXPECT_EQ(twice.items().front().path, "/points/rows/1");
    Problems nothing;
    EXPECT_EQ(make(artefact(), covaria::Setup{}, nothing), nullptr);  // no observations
    covaria::Setup negative = small_artefact();
    negative.values["u_cal"] = mm(-0.005);
    Problems refused;
    EXPECT_EQ(make(artefact(), negative, refused), nullptr);
    EXPECT_EQ(refused.items().front().path, "/u_cal");
}

TEST(LengthStandard, EvaluatesObservations) {
    covaria::Setup s;
    s.values["length"] = mm(1000);
    s.values["observations"] = table_of(length_standard(), "observations",
                                        {{std::string("X1"), 1.0, 1000.1}, {std::string("X1"), 2.0, 1000.3}});
    s.values["expansion"] = Quantity{23e-6, Unit::of("1/K")};
    s.values["temperature_deviation"] = Quantity{0.5, Unit::of("K")};
    const auto asset = make(length_standard(), s);
    EXPECT_NEAR(cell(*asset, 0, 4), .2e-3, 1e-12);
    EXPECT_NEAR(cell(*asset, 0, 3), .2e-3 / std::numbers::sqrt2, 1e-12);
    EXPECT_NEAR(cell(*asset, 0, 2), 23e-6 * .5 / std::numbers::sqrt3, 1e-15);
    Problems problems;
    s.values.erase("observations");
    EXPECT_EQ(make(length_standard(), s, problems), nullptr);
    EXPECT_EQ(problems.items().front().path, "/observations");
}

TEST(PointSpecification, DivisorsOfTheData) {
    const AssetDescriptor& d = *find_asset_kind("point-specification");
    const auto u = [&](const char* meaning, const char* applies_to) {
        const covaria::Setup s{{{"figure", mm(1.0)},
                                {"meaning", std::string(meaning)},
                                {"applies_to", std::string(applies_to)}}};
        return u_of(*make(d, s), 2) * 1e3;
    };
    EXPECT_NEAR(u("standard", "coordinate"), 1.0, 1e-15);
    EXPECT_NEAR(u("expanded-k2", "coordinate"), 0.5, 1e-15);
    EXPECT_NEAR(u("limit-rectangular", "coordinate"), 1 / std::sqrt(3.0), 1e-14);
    EXPECT_NEAR(u("limit-triangular", "coordinate"), 1 / std::sqrt(6.0), 1e-14);
    EXPECT_NEAR(u("limit-rectangular", "length"), 1 / std::sqrt(6.0), 1e-14);
}

TEST(SphericalInstrument, DeviationsLieAlongAndAcrossTheLineOfSight) {
    const AssetDescriptor& d = *find_asset_kind("spherical-instrument");
    PoseValue station;
    station.position = {1000, 0, 0};
    station.angles = {0, 0, 90};
    const covaria::Setup s{{{"station", station},
                            {"distance_constant", mm(1.0)},
                            {"distance_scale", Quantity{10, Unit::of("ppm")}},
                            {"angle_azimuth", Quantity{1, Unit::of("mrad")}},
                            {"angle_elevation", Quantity{2, Unit::of("mrad")}}}};
    const auto asset = make(d, s);
    const auto at = offers<PointUncertaintySource>(asset)->deviations({4.0, 0.0, 4.0});
    ASSERT_EQ(at.size(), 3u);
    const double length = 5.0;
    EXPECT_LT((at[0].direction - Eigen::Vector3d(.6, 0, .8)).norm(), 1e-15);
    EXPECT_LT((at[1].direction - Eigen::Vector3d(0, 3.0, 0)).norm(), 1e-14);
    EXPECT_LT((at[2].direction - length * Eigen::Vector3d(-.8, 0, .6)).norm(), 1e-14);
    EXPECT_NEAR(at[0].component.distribution.standard_uncertainty(), 1e-3 + 10e-6 * length, 1e-15);
    EXPECT_NEAR(at[1].component.distribution.standard_uncertainty(), 1e-3, 1e-15);
    EXPECT_NEAR(at[2].component.distribution.standard_uncertainty(), 2e-3, 1e-15);
    const auto above = offers<PointUncertaintySource>(asset)->deviations({1.0, 0.0, 3.0});
    EXPECT_NEAR(above[1].direction.norm(), near_zenith * 3.0, 1e-15);  // the constant part across stays
    EXPECT_NEAR(above[2].direction.norm(), 3.0, 1e-14);
    EXPECT_EQ(asset->layout().bodies.front().glyph, "total-station");
}

Eigen::Matrix3d covariance_of(const std::vector<PointDeviation>& deviations, bool common) {
    Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
    for (const PointDeviation& d : deviations)
        if (d.common == common)
            C += std::pow(d.component.distribution.standard_uncertainty(), 2) * d.direction *
                 d.direction.transpose();
    return C;
}

covaria::Setup tracker_at_origin() {
    return {{{"kind", std::string("tracker")},
             {"u_scale", Quantity{2, Unit::of("ppm")}},
             {"u_zero", Quantity{0.01, Unit::of("mm")}},
             {"u_station_y", Quantity{0.1, Unit::of("mm")}},
             {"u_station_kappa", Quantity{0.02, Unit::of("mrad")}}}};
}

TEST(SphericalInstrument, ScaleZeroAndStationAreCommonToAllPoints) {
    const AssetDescriptor& d = *find_asset_kind("spherical-instrument");
    const auto asset = make(d, tracker_at_origin());
    const auto at = offers<PointUncertaintySource>(asset)->deviations({10.0, 0.0, 0.0});
    const Eigen::Matrix3d C = covariance_of(at, true);
    EXPECT_NEAR(C(0, 0), std::pow(20e-6, 2) + std::pow(10e-6, 2), 1e-18);  // scale over 10 m, zero
    EXPECT_NEAR(C(1, 1), std::pow(0.1e-3, 2) + std::pow(0.2e-3, 2),
                1e-15);  // station, its rotation over 10 m
    EXPECT_NEAR(C(2, 2), 0.0, 1e-20);
    EXPECT_EQ(covariance_of(at, false).norm(), 0.0);
}

TEST(SphericalInstrument, CorrelatedCoordinatesOfTheStation) {
    const AssetDescriptor& d = *find_asset_kind("spherical-instrument");
    for (const auto& [r, u_mm] : {std::pair{1.0, 0.3}, std::pair{-1.0, 0.1}}) {
        covaria::Setup s = tracker_at_origin();
        s.values["station_correlation"] =
            table_of(d, "station_correlation", {{std::string("y_0"), std::string("kappa"), r}});
        const auto asset = make(d, s);
        const Eigen::Matrix3d C =
            covariance_of(offers<PointUncertaintySource>(asset)->deviations({10.0, 0.0, 0.0}), true);
        EXPECT_NEAR(std::sqrt(C(1, 1)), 1e-3 * u_mm, 1e-9) << r;
    }
    covaria::Setup impossible = tracker_at_origin();
    impossible.values["station_correlation"] = table_of(d, "station_correlation",
                                                        {{std::string("x_0"), std::string("y_0"), 0.9},
                                                         {std::string("y_0"), std::string("z_0"), 0.9},
                                                         {std::string("x_0"), std::string("z_0"), -0.9}});
    Problems problems;
    EXPECT_EQ(make(d, impossible, problems) != nullptr && !problems.has_errors(), false);
    EXPECT_NE(problems.items().front().message.english().find("not possible together"), std::string::npos);
}

TEST(SphericalInstrument, WhatASensorReads) {
    const AssetDescriptor& d = *find_asset_kind("spherical-instrument");
    const auto camera = make(d, {{{"kind", std::string("camera")}}});
    EXPECT_FALSE(offers<SensorSource>(camera)->reads(Observable::distance));
    EXPECT_TRUE(offers<SensorSource>(camera)->reads(Observable::azimuth));
    EXPECT_EQ(offers<PointUncertaintySource>(camera), nullptr);  // a direction is no point
    const auto meter = make(d, {{{"kind", std::string("distance-meter")}}});
    EXPECT_TRUE(offers<SensorSource>(meter)->reads(Observable::distance));
    EXPECT_FALSE(offers<SensorSource>(meter)->reads(Observable::elevation));
    Problems problems;
    make(d,
         {{{"kind", std::string("generic")},
           {"reads_distance", false},
           {"reads_azimuth", false},
           {"reads_elevation", false}}},
         problems);
    EXPECT_TRUE(problems.has_errors());
}

TEST(AssetRegistry, EveryFieldIsExplained) {
    for (const AssetDescriptor& d : asset_registry()) {
        EXPECT_FALSE(d.title.empty() || d.summary.empty() || d.references.empty() || d.notes.empty())
            << d.kind;
        for (const FieldSpec& field : d.schema.fields()) {
            EXPECT_FALSE(field.help.empty() || field.title.empty()) << d.kind << " " << field.key;
            for (const ColumnSpec& column : field.columns) EXPECT_FALSE(column.help.empty()) << column.key;
        }
    }
    EXPECT_EQ(find_asset_kind("no-such-kind"), nullptr);
}

}  // namespace
}  // namespace covaria::asset_evaluation_test
