// Two-face and length tests of a tracker: errors, limits and decisions against numbers computed here.
#include <cmath>

#include "core/text/cell.h"
#include "tests/core/kinds/sheets/made_sheet.h"

namespace covaria::sheets_test {
namespace {

SetupTable tests_table(const std::vector<std::vector<SetupCell>>& rows) {
    const Unit mm = Unit::of("mm"), m = Unit::of("m"), deg = Unit::of("deg"), um = Unit::of("um");
    SetupTable table;
    table.units = {Unit{}, Unit{}, mm, mm, m, deg, deg, um, um};
    table.rows = rows;
    return table;
}

covaria::Setup tracker_setup() {
    const SetupCell none;
    covaria::Setup setup;
    setup.values["tests"] = tests_table(
        {{std::string("T1"), std::string("two-face"), 0.050, none, 4.0, 0.0, 0.0, none, none},
         {std::string("T2"), std::string("two-face"), 0.050, none, 1.0, 90.0, 0.0, none, none},
         {std::string("T3"), std::string("two-face"), 0.050, none, 1.0, 90.0, 45.0, none, 51.0},
         {std::string("L1"), std::string("length"), 2300.020, 2300.0, 3.0, 0.0, 0.0, 3.0, none},
         {std::string("L2"), std::string("length"), 1149.970, 1150.0, 3.0, 0.0, 0.0, none, none}});
    setup.values["two_face_constant"] = Quantity{30.0, Unit::of("um")};
    setup.values["two_face_slope"] = Quantity{12.0, Unit::of("um/m")};
    setup.values["length_constant"] = Quantity{10.0, Unit::of("um")};
    setup.values["length_slope"] = Quantity{20.0, Unit::of("um/m")};
    setup.values["u_two_face"] = Quantity{2.0, Unit::of("um")};
    setup.values["u_length"] = Quantity{4.0, Unit::of("um")};
    setup.values["u_reference_scale"] = Quantity{1.0, Unit::of("ppm")};
    return setup;
}

TEST(TrackerTests, DecideWithTheUncertaintyOfTheTest) {
    const auto model = made("tracker-tests", tracker_setup());
    const Table decisions = table_of(model->evaluation(), "decisions");
    const auto number = [&](std::size_t row, std::size_t column) {
        return 1e6 * value(decisions.columns[column].cell(row));
    };
    const double mpe[] = {78.0, 42.0, 51.0, 56.0, 33.0}, error[] = {50.0, 50.0, 50.0, 20.0, -30.0};
    const double u[] = {2.0, 2.0, 2.0, std::hypot(3.0, 2.3), std::hypot(4.0, 1.15)};
    const char* decided[] = {"conforms", "does not conform", "not decided", "conforms", "not decided"};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(number(i, 2), error[i], 1e-6) << i;
        EXPECT_NEAR(number(i, 3), 2.0 * u[i], 1e-9) << i;
        EXPECT_NEAR(number(i, 4), mpe[i], 1e-9) << i;
        EXPECT_EQ(english_of(decisions.columns[6].cell(i)), decided[i]) << i;
        const FirstOrderOutput e = first_order(*model, "E_" + std::to_string(i + 1));
        EXPECT_NEAR(1e6 * e.estimate, error[i], 1e-6);
        EXPECT_NEAR(1e6 * e.standard_uncertainty, u[i], 1e-9);
    }
    const double z = 1.0 / 2.0;  // (51 - 50)/2
    EXPECT_NEAR(value(decisions.columns[5].cell(2)), 0.5 * std::erfc(-z / std::sqrt(2.0)), 1e-12);
}

TEST(TrackerTests, LengthsShareTheScaleOfTheirReferences) {
    const auto model = made("tracker-tests", tracker_setup());
    const auto result = evaluate_first_order(*model, model->inputs(), {});
    ASSERT_TRUE(result);
    EXPECT_NEAR(1e12 * first_order_covariance(*result)(3, 4), 2.3 * 1.15, 1e-9);
    EXPECT_EQ(first_order_covariance(*result)(0, 3), 0.0);
}

TEST(TrackerTests, RefuseAPositionWithoutALimitOrReference) {
    for (const char* without : {"two_face_constant", "length_constant"}) {
        covaria::Setup setup = tracker_setup();
        setup.values.erase(without);
        Problems problems;
        EXPECT_FALSE(made("tracker-tests", setup, problems)) << without;
    }
    covaria::Setup setup = tracker_setup();
    std::get<SetupTable>(setup.values["tests"]).rows[3][3] = SetupCell();
    Problems problems;
    EXPECT_FALSE(made("tracker-tests", setup, problems));
}

}  // namespace
}  // namespace covaria::sheets_test
