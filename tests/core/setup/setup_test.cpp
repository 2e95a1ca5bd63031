// Poses as SI, checking set-ups against hand-made schemas, and the words for it.
#include "core/setup/setup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/setup/message_text.h"
#include "core/setup/setup_schema.h"
#include "core/setup/shared_decimals.h"

namespace covaria::setup_test {

namespace {

SetupSchema schema() {
    FieldSpec thickness{"thickness",  "plate thickness", FieldKind::number,
                        "How thick.", Unit::of("mm"),    {0.0, 0.05}};
    FieldSpec temperature{"temperature", "temperature", FieldKind::number, "Of the plate.", Unit::of("degC")};
    temperature.default_value = Quantity{20.0, Unit::of("degC")};
    FieldSpec count{"count", "count", FieldKind::integer, "How many."};
    count.default_value = Quantity{3.0};
    FieldSpec mode{"mode", "mode", FieldKind::choice, "Which."};
    mode.default_value = std::string("typed");
    mode.choices = {{"typed", "typed"}, {"asset", "from an asset"}};
    FieldSpec source{"source", "source", FieldKind::reference, "From where."};
    source.shown_if = Condition{"mode", {"asset"}};
    FieldSpec pose{"pose", "pose", FieldKind::pose, "Where."};
    pose.optional = true;
    FieldSpec points{"points", "points", FieldKind::table, "Points."};
    points.columns = {{"name", "name", FieldKind::text},
                      {"x", "x", FieldKind::number, Unit::of("mm")},
                      {"y", "y", FieldKind::number, Unit::of("mm")},
                      {"z", "z", FieldKind::number, Unit::of("mm"), {}, true},
                      {"fixed", "fixed", FieldKind::flag, {}, {}, true}};
    points.min_rows = 1;
    return SetupSchema({thickness, temperature, count, mode, source, pose, points});
}

Setup valid() {
    const Unit mm = Unit::of("mm");
    Setup setup;
    setup.values["thickness"] = Quantity{12.0, mm};
    setup.values["points"] =
        SetupTable{{{}, mm, Unit::of("um"), mm, {}},
                   {{std::string("p1"), 1.0, 2.0, 3.0, true}, {std::string("p2"), 4.0, 5.0}}};
    return setup;
}

std::string problems_of(const Setup& setup) {
    Problems problems;
    check_setup(schema(), setup, problems);
    std::string all;
    for (const Problem& problem : problems.items())
        all += problem.path + ": " + problem.message.english() + "\n";
    return all;
}

Setup with(const std::string& key, SetupValue value) {
    Setup setup = valid();
    setup.values[key] = std::move(value);
    return setup;
}

}  // namespace

TEST(Pose, AnglesTurnAboutZyx) {
    PoseValue pose;
    pose.position = {1.0, 2.0, 3.0};
    pose.angles = {10.0, 20.0, 30.0};
    const double alpha = std::numbers::pi / 18, beta = 2 * alpha, gamma = 3 * alpha;
    const Eigen::Isometry3d X = pose.si();
    EXPECT_TRUE(X.translation().isApprox(Eigen::Vector3d(1e-3, 2e-3, 3e-3)));
    // R = Rz(gamma) Ry(beta) Rx(alpha), element by element
    EXPECT_NEAR(X.linear()(2, 0), -std::sin(beta), 1e-15);
    EXPECT_NEAR(X.linear()(2, 1), std::cos(beta) * std::sin(alpha), 1e-15);
    EXPECT_NEAR(X.linear()(1, 0), std::sin(gamma) * std::cos(beta), 1e-15);
    EXPECT_NEAR(X.linear().determinant(), 1.0, 1e-15);
}

TEST(CheckSetup, ValidHasNoProblem) {
    EXPECT_EQ(problems_of(valid()), "");
}

TEST(CheckSetup, NumbersAndUnits) {
    EXPECT_EQ(problems_of(with("thickness", Quantity{3.0, Unit::of("N")})),
              "/thickness: 'plate thickness' is a length; '3 N' is a force\n");
    EXPECT_EQ(problems_of(with("thickness", Quantity{3.0})),
              "/thickness: 'plate thickness' is a length; '3' has no unit\n");
    EXPECT_EQ(problems_of(with("thickness", Quantity{6.0, Unit::of("cm")})),
              "/thickness: 'plate thickness' must be between 0 mm and 50 mm; it is 6 cm\n");
    EXPECT_EQ(problems_of(with("thickness", Quantity{std::nan(""), Unit::of("mm")})),
              "/thickness: 'plate thickness' must be a finite number; it is not a number\n");
    EXPECT_EQ(problems_of(with("thickness", Quantity{INFINITY, Unit::of("mm")})),
              "/thickness: 'plate thickness' must be a finite number; it is infinity\n");
    EXPECT_EQ(problems_of(with("temperature", Quantity{293.15, Unit::of("K")})), "");
    EXPECT_EQ(problems_of(with("count", Quantity{1.5})),
              "/count: 'count' must be a whole number; it is 1.5\n");
    EXPECT_EQ(problems_of(with("count", Quantity{1e12})), "/count: 'count' is too large a number: 1e+12\n");
    EXPECT_EQ(problems_of(with("count", std::string("3"))), "/count: 'count' must be a whole number\n");
    EXPECT_EQ(problems_of(with("thickness", true)), "/thickness: 'plate thickness' must be a number\n");
}

TEST(CheckSetup, RequiredOnlyWhereShown) {
    covaria::Setup setup = with("mode", std::string("asset"));
    EXPECT_EQ(problems_of(setup), "/source: 'source' must be given ('source' is missing)\n");
    setup.values["source"] = std::string();
    EXPECT_EQ(problems_of(setup), "/source: 'source' must not be empty\n");
    setup.values["source"] = std::string("plate");
    EXPECT_EQ(problems_of(setup), "");
    setup.values.erase("thickness");
    EXPECT_EQ(problems_of(setup), "/thickness: 'plate thickness' must be given ('thickness' is missing)\n");
}

TEST(CheckSetup, UnknownKeysAndChoices) {
    EXPECT_EQ(problems_of(with("thicknes", true)),
              "/thicknes: there is no field 'thicknes' here (did you mean 'thickness'?)\n");
    EXPECT_EQ(problems_of(with("mode", std::string("typd"))),
              "/mode: 'mode' must be one of 'typed' and 'asset'; it is 'typd' (did you mean 'typed'?)\n");
}

TEST(CheckSetup, Poses) {
    PoseValue pose;
    pose.angle_unit = Unit::of("mm");
    EXPECT_EQ(problems_of(with("pose", pose)), "/pose: 'pose' is an angle; '0 mm' is a length\n");
    pose.angle_unit = Unit::of("deg");
    pose.position[2] = INFINITY;
    EXPECT_EQ(problems_of(with("pose", pose)), "/pose: 'pose' must be a finite number; it is infinity\n");
}

TEST(CheckSetup, Tables) {
    SetupTable table = std::get<SetupTable>(valid().values["points"]);
    table.rows[1][1] = std::monostate{};
    table.rows.push_back({1.0, std::string("x"), NAN, true, std::string("yes")});
    EXPECT_EQ(problems_of(with("points", table)),
              "/points/rows/1/x: 'x in row 2 of points' is empty\n"
              "/points/rows/2/name: 'name in row 3 of points' must be a text\n"
              "/points/rows/2/x: 'x in row 3 of points' must be a number\n"
              "/points/rows/2/y: 'y in row 3 of points' must be a finite number; it is not a number\n"
              "/points/rows/2/z: 'z in row 3 of points' must be a number\n"
              "/points/rows/2/fixed: 'fixed in row 3 of points' must be true or false\n");
    table = std::get<SetupTable>(valid().values["points"]);
    table.rows.clear();
    EXPECT_EQ(problems_of(with("points", table)), "/points: 'points' needs at least 1 row; it has 0\n");
    table = std::get<SetupTable>(valid().values["points"]);
    table.units[1] = Unit::of("deg");
    EXPECT_EQ(problems_of(with("points", table)),
              "/points/columns: column 'x' of 'points' is a length; 'deg' is the unit of an angle\n");
    table = std::get<SetupTable>(valid().values["points"]);
    table.units.pop_back();
    EXPECT_EQ(problems_of(with("points", table)), "/points/columns: 'points' has 5 columns, but 4 units\n");
    table = std::get<SetupTable>(valid().values["points"]);
    table.rows[0].push_back(1.0);
    EXPECT_EQ(problems_of(with("points", table)),
              "/points/rows/0: row 1 of 'points' has 6 cells; there are 5 columns\n");
}

TEST(Words, NearestName) {
    const std::vector<std::string> names{"position", "angles", "unit"};
    EXPECT_EQ(nearest_name("positoin", names), "position");
    EXPECT_EQ(nearest_name("Unit", names), "unit");
    EXPECT_EQ(nearest_name("wholly_different", names), "");
    EXPECT_EQ(nearest_name("x", {"y"}), "");
    EXPECT_EQ(did_you_mean("angels", names), " (did you mean 'angles'?)");
    EXPECT_EQ(listed({"a"}), "'a'");
    EXPECT_EQ(listed({"a", "b", "c"}), "'a', 'b' and 'c'");
}

TEST(SharedDecimals, OfObservationsAreThoseOfTheSeries) {
    FieldSpec field{"observations", "Observations", FieldKind::table, "As read."};
    field.columns = {{"quantity", "quantity", FieldKind::text}, {"value", "value"}};
    const auto row = [](const char* quantity, double value) {
        return std::vector<SetupCell>{std::string(quantity), value};
    };
    SetupTable table;
    table.rows = {row("V", 4.99), row("V", 5.012), row("I", 0.5), row("I", 2.0)};
    EXPECT_TRUE(shared_decimals(field, table, 1).empty()) << "figures of different kinds";
    field.columns[1].observed = true;
    EXPECT_EQ(shared_decimals(field, table, 1), (std::vector<int>{3, 3, 1, 1}));
    EXPECT_TRUE(shared_decimals(field, table, 0).empty());
}

TEST(SharedDecimals, OfAMeasuredColumnAreOneForAll) {
    FieldSpec field{"points", "Points", FieldKind::table, "Measured points."};
    field.columns = {{"x", "x", FieldKind::number, Unit::of("mm")}, {"n", "n", FieldKind::integer}};
    SetupTable table;
    for (const double x : {25.503, 26.01, -3.0}) table.rows.push_back({x, x});
    EXPECT_TRUE(shared_decimals(field, table, 0).empty()) << "nominal points are as they were typed";
    field.measured = true;
    EXPECT_EQ(shared_decimals(field, table, 0), (std::vector<int>{3, 3, 3}));
    EXPECT_TRUE(shared_decimals(field, table, 1).empty());
    table.rows.push_back({1.23456789, 1.0});
    EXPECT_EQ(shared_decimals(field, table, 0), (std::vector<int>{-1, -1, -1, -1}))
        << "too many for the others";
}

TEST(Words, Numbers) {
    EXPECT_EQ(shortest_number(688), "688");
    EXPECT_EQ(shortest_number(0.066), "0.066");
    EXPECT_EQ(shortest_number(-0.0), "0");
    EXPECT_EQ(shortest_number(100000), "100000");
    EXPECT_EQ(shortest_number(11.5e-6), "0.0000115");
    EXPECT_EQ(shortest_number(9.5e-6), "9.5e-06");
    EXPECT_EQ(shortest_number(1.0 / 3), "0.3333333333333333");
    EXPECT_EQ(readable_number(49.999999999999996), "50");
    EXPECT_EQ(readable_number(-INFINITY), "minus infinity");
    EXPECT_EQ(quantity_words(3, Unit::of("N")), "3 N");
}

TEST(Words, Dimensions) {
    EXPECT_EQ(dimension_words(Unit::of("mm")), "a length");
    EXPECT_EQ(dimension_words(Unit::of("N*m")), "a moment");
    EXPECT_EQ(dimension_words(Unit::of("um/m")), "a pure number");
    EXPECT_EQ(dimension_words(Unit::of("1/K")), "an expansion coefficient");
    EXPECT_EQ(dimension_words(Unit::of("arcsec")), "an angle");
    EXPECT_EQ(dimension_words(Unit::of("kg*m")).english().substr(0, 12), "measured in ");
}

TEST(SetupSchemas, ATableIsFoundByWhatItSaysOfItsRows) {
    const SetupSchema schema(
        {{.key = "first", .title = "First", .help = "A number."},
         {.key = "budget", .title = "Budget", .help = "Rows.", .states_quantities = true},
         {.key = "other", .title = "Other", .help = "Rows.", .states_quantities = true}});
    ASSERT_NE(schema.find(&FieldSpec::states_quantities), nullptr);
    EXPECT_EQ(schema.find(&FieldSpec::states_quantities)->key, "budget");
    EXPECT_EQ(schema.find(&FieldSpec::observes_quantities), nullptr);
}

}  // namespace covaria::setup_test
