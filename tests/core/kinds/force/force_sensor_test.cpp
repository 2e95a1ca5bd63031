// The evaluation of Kim's six-axis force/moment sensor: Tables 1 to 4 from raw readings, what the printed
// tables give, the GUM beside it, and calibrations with something wrong. Published values, mV/V unless said.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "core/base/resource_path.h"
#include "core/project/project_file.h"
#include "tests/core/kinds/force/force_project.h"
#include "tests/core/table_rows.h"

namespace covaria::force_sensor_test {
namespace {

using Row = std::vector<double>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Equal to `published` when rounded to its last digit.
void expect_rounds_to(const Row& found, const Row& published, double digit, const std::string& what) {
    ASSERT_EQ(found.size(), published.size()) << what;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (std::isnan(published[i])) continue;
        EXPECT_NEAR(std::round(found[i] / digit) * digit, published[i], 1e-6 * digit)
            << what << " " << i << ": " << found[i];
    }
}

Row magnitudes(Row row) {
    for (double& value : row) value = std::abs(value);
    return row;
}

const Row table_2[] = {
    {nan, .00310, .00335, .00159, .00261, .00362}, {.00468, nan, .00207, .00287, .00032, .00021},
    {.00426, .00102, nan, .00712, .00100, .00263}, {.00516, .00100, .00606, nan, .00854, .00896},
    {.01621, .00116, .00114, .00414, nan, .00148}, {.00521, .00406, .00057, .00166, .00231, nan}};

TEST(ForceSensor, ReadingsReproduceTable1) {
    const Table table = table_with(ForceProject().asset_tables("sensor"), "table-1");
    expect_rounds_to(numbers(table, 1), {100, 100, 100, 1, 1, 1}, 1.0, "rated load");
    expect_rounds_to(numbers(table, 2), {.52782, .47948, .48070, .64724, .65273, .60874}, 1e-5,
                     "rated output");
    expect_rounds_to(numbers(table, 3), {.00051, .00078, .00096, .00102, .00099, .00121}, 1e-5, "non-zero");
}

TEST(ForceSensor, ReadingsReproduceTable2) {
    const Table table = table_with(ForceProject().asset_tables("sensor"), "table-2");
    for (std::size_t c = 0; c < 6; ++c) {
        Row published;
        for (const Row& row : table_2) published.push_back(row[c]);
        expect_rounds_to(magnitudes(numbers(table, c + 1)), published, 1e-5,
                         "under load " + std::to_string(c));
    }
    expect_rounds_to(numbers(table, 7), {.00362, .00468, .00712, .00896, .01621, .00521}, 1e-5, "largest");
}

TEST(ForceSensor, ReadingsReproduceTable3) {
    const Table table = table_with(ForceProject().asset_tables("sensor"), "table-3");
    expect_rounds_to(numbers(table, 1), {.00021, .00018, .00012, .00031, .00029, .00024}, 1e-5, "u_A");
    expect_rounds_to(numbers(table, 2), {.00027, .00031, .00028, .00041, .00040, .00062}, 1e-5, "u_B");
    expect_rounds_to(numbers(table, 3), {.00051, .00046, .00029, .00089, .00094, .00078}, 1e-5, "hysteresis");
    expect_rounds_to(numbers(table, 4), {.00362, .00468, .00712, .00896, .01621, .00521}, 1e-5,
                     "interference");
    expect_rounds_to(numbers(table, 5), {.00034, .00035, .00030, .00051, .00050, .00067}, 1e-5, "u_c");
    expect_rounds_to(numbers(table, 6), {.00481, .00585, .00801, .01087, .01814, .00733}, 1e-5, "U");
    expect_rounds_to(numbers(table, 7), {.91, 1.22, 1.67, 1.68, 2.78, 1.20}, 1e-2, "U in %");
    expect_rounds_to(numbers(table, 8), {.9122, 1.2198, 1.6671, .0168, .0278, .0120}, 1e-4, "U in N and N m");
}

TEST(ForceSensor, Table4IsTable2ByTheRatedOutput) {
    const Table table = table_with(ForceProject().asset_tables("sensor"), "table-4");
    const Row printed[] = {{nan, .98, .89, .80, 2.48, .86}, {.59, nan, .21, nan, .18, .67},
                           {nan, .43, nan, .94, .17, .09},  {.30, .60, 1.48, nan, .63, .27},
                           {.49, .07, .21, 1.32, nan, .38}, {.69, .04, .55, 1.38, .23, nan}};
    for (std::size_t c = 0; c < 6; ++c)
        expect_rounds_to(magnitudes(numbers(table, c + 1)), printed[c], 1e-2,
                         "under load " + std::to_string(c));
    // Printed 0.64 from the rounded 0.00335; printed 1.55 for Mx under Fy, a mistake, as is its maximum.
    EXPECT_NEAR(magnitudes(numbers(table, 3))[0], 0.635, 0.001);
    EXPECT_NEAR(magnitudes(numbers(table, 2))[3], 0.1545, 0.001);
    expect_rounds_to(numbers(table, 7), {.69, .98, 1.48, 1.38, 2.48, .86}, 1e-2, "largest");
}

TEST(ForceSensor, StatesWhatOfThePrintedTablesReproduces) {
    const Table table = table_with(ForceProject().asset_tables("sensor-printed"), "stated");
    std::map<std::string, std::string> summary, cells;
    std::string quantity;
    for (const auto& row : test::rows_of(table)) {
        const std::string name = english_of(row[0]), sensor = english_of(row[1]);
        if (!name.empty())
            summary[quantity = name] = sensor;
        else
            cells[quantity + ":" + sensor] = english_of(row[4]);
    }
    // Type B does not follow from the stated uncertainty of the machine, but for Fz.
    EXPECT_EQ(summary.at("u_B"), "1 out of 6");
    for (const char* const sensor : {"Fx", "Fy", "Mx", "My", "Mz"})
        EXPECT_EQ(cells.at(std::string("u_B:") + sensor), "differs");
    EXPECT_EQ(summary.at("U, relative"), "6 out of 6");
    for (const char* const sensor : {"Fy", "Fz", "Mx", "Mz"})
        EXPECT_EQ(cells.at(std::string("U:") + sensor), "inside rounding");
    EXPECT_EQ(summary.at("u_c"), "3 out of 6");
    EXPECT_EQ(summary.at("interference, percent"), "28 out of 30");
    EXPECT_EQ(cells.at("interference, percent:Fx, Fz"), "inside rounding");
    EXPECT_EQ(cells.at("interference, percent:Mx, Fy"), "differs");
    EXPECT_EQ(summary.at("largest interference, percent"), "5 out of 6");
    EXPECT_EQ(cells.at("largest interference, percent:Mx"), "differs");
    for (const auto& [cell, status] : cells)
        EXPECT_TRUE(status == "inside rounding" || cell.starts_with("u_B:") || cell.ends_with("Mx, Fy") ||
                    cell == "largest interference, percent:Mx")
            << cell << " " << status;
}

TEST(ForceSensor, TheQuotedMachineGivesTheseTypeBUncertainties) {
    const Table table = table_with(ForceProject().asset_tables("sensor-printed"), "type-b");
    expect_rounds_to(numbers(table, 4), {.000157, .000229, .000277, .000311, .000301, .000357}, 1e-6, "u_B");
    EXPECT_NEAR(numbers(table, 2)[0], 2.887e-6, 0.5e-6);
}

TEST(ForceSensor, WhichIndexIsTheLoadIsAChoice) {
    ForceProject project;
    project.asset("sensor-printed").values["interference_rows"] = std::string("load");
    const std::vector<Table> tables = project.asset_tables("sensor-printed");
    const Table& table = table_with(tables, "table-3");
    expect_rounds_to(numbers(table, 4), {.01621, .00406, .00606, .00712, .00854, .00896}, 1e-5,
                     "interference");
    const Row reference = {3.30, 1.09, 1.45, 1.40, 1.61, 1.82}, found = numbers(table, 7);
    for (std::size_t i = 0; i < 6; ++i)  // it starts from u_c as printed: half of 1e-5 mV/V, times k
        EXPECT_NEAR(found[i], reference[i], 0.005 + 100.0 * 2.0 * 0.5e-5 / 0.47948) << i;
    // The table stays as it was typed.
    expect_rounds_to(numbers(table_with(tables, "table-2"), 2),
                     {.00310, nan, .00102, .00100, .00116, .00406, .00406}, 1e-5, "under Fy");
}

TEST(ForceSensor, GumBesideThePaper) {
    const Table table = table_with(ForceProject().model_tables("combined"), "paper-and-gum");
    expect_rounds_to(numbers(table, 1), {.912, 1.220, 1.667, 1.680, 2.780, 1.204}, 1e-3, "paper");
    expect_rounds_to(numbers(table, 2), {1.446, 1.425, 2.123, 2.637, 2.990, 1.388}, 1e-3, "all");
    expect_rounds_to(numbers(table, 3), {.804, 1.138, 1.715, 1.608, 2.873, 1.015}, 1e-3, "largest only");
    expect_rounds_to(numbers(table, 4), {.147, .159, .129, .183, .178, .230}, 1e-3, "alone");
    expect_rounds_to(numbers(table, 7), {2.704, 2.117, 3.335, 4.592, 3.697, 2.269}, 1e-3, "worst case");
    for (const auto& row : test::rows_of(table)) EXPECT_EQ(english_of(row[8]), "yes");
}

/// k u of the relative loads, in %.
Row relative_expanded(const UncertaintyResult& r, double k) {
    Row row;
    for (const OutputResult& y : r.outputs)
        if (y.quantity.symbol == "r") row.push_back(100.0 * k * y.first_order.standard_uncertainty);
    return row;
}

TEST(ForceSensor, TheModelIsTheGumColumn) {
    ForceProject project;
    expect_rounds_to(relative_expanded(project.first_order("combined"), 2.0),
                     {1.446, 1.425, 2.123, 2.637, 2.990, 1.388}, 1e-3, "combined");
    expect_rounds_to(relative_expanded(project.first_order("one-other"), 2.0),
                     {.804, 1.138, 1.715, 1.608, 2.873, 1.015}, 1e-3, "largest");
    const UncertaintyResult alone = project.first_order("alone");
    Row found;
    for (const OutputResult& y : alone.outputs)
        if (y.quantity.symbol == "r") {
            found.push_back(100.0 * y.first_order.coverage_factor * y.first_order.standard_uncertainty);
            EXPECT_GT(y.first_order.effective_degrees_of_freedom, 19.0);
            EXPECT_LT(y.first_order.effective_degrees_of_freedom, 142.0);
        }
    expect_rounds_to(found, {.147, .159, .129, .183, .178, .230}, 1e-3, "alone");
}

TEST(ForceSensor, MonteCarloIntervals) {
    const UncertaintyResult r = ForceProject().monte_carlo("combined", 200'000);
    const Row reference = {1.416, 1.359, 2.002, 2.558, 2.609, 1.341};
    std::size_t i = 0;
    for (const OutputResult& y : r.outputs) {
        if (y.quantity.symbol != "r") continue;
        const double half = 50.0 * (y.monte_carlo->symmetric.high - y.monte_carlo->symmetric.low);
        // Standard error of an end at p = 0.975: sqrt(p (1 - p)/M)/density, density of a normal there; twice
        // for the reference, four of both.
        const double u = 100.0 * y.monte_carlo->standard_uncertainty;
        const double error = std::sqrt(0.975 * 0.025 / 2e5) / 0.0585 * u;
        EXPECT_NEAR(half, reference[i], 4.0 * error + 5e-4) << i;
        ++i;
    }
    EXPECT_EQ(i, 6u);
}

TEST(ForceSensor, PooledRepeatabilityHasMoreDegreesOfFreedom) {
    ForceProject project;
    project.analysis("alone").setup.values["repeatability"] = std::string("pooled");
    const auto prepared = project.prepare("alone");
    ASSERT_TRUE(prepared) << project.words();
    for (const UncertaintyComponent& c : prepared->inputs.components)
        if (c.type == EvaluationType::type_a) {
            EXPECT_EQ(c.degrees_of_freedom, 10.0) << c.id;
        }
    for (const double k : numbers(table_with(prepared->model->evaluation(), "paper-and-gum"), 6))
        EXPECT_NEAR(k, 1.965, 0.006);
}

TEST(ForceSensor, ThreeReadingsAsATDistributionHaveNoStandardDeviation) {
    ForceProject project;
    project.analysis("alone").setup.values["type_a"] = std::string("student-t");
    const auto prepared = project.prepare("alone");
    ASSERT_TRUE(prepared) << project.words();
    for (const UncertaintyComponent& c : prepared->inputs.components)
        if (c.type == EvaluationType::type_a) {
            EXPECT_EQ(drawn_distribution(c).degrees_of_freedom(), 2.0);
            EXPECT_TRUE(std::isinf(drawn_distribution(c).standard_deviation()));
        }
}

// --- calibrations with something wrong

TEST(ForceSensor, MissingStepsAndRuns) {
    ForceProject step;
    step.remove_readings({"Mx", "calibration", "increasing", 2, 3});
    EXPECT_TRUE(step.warns("combined", "step 3 of Mx is missing in 1 of 3 runs")) << step.words();
    ForceProject run;
    run.remove_readings({"Fy", "calibration", "", 3});
    EXPECT_TRUE(run.warns("combined", "Fy has 2 runs, 3 are planned: its means have 1 degrees"))
        << run.words();
    run.remove_readings({"Fy", "calibration", "", 2});
    EXPECT_TRUE(run.refuses("combined", "Fy has one run only")) << run.words();
    run.remove_readings({"Fy", "", "", 0});
    EXPECT_TRUE(run.refuses("combined", "Fy was not calibrated")) << run.words();
    ForceProject top;
    top.remove_readings({"Mz", "calibration", "increasing", 0, 5});
    EXPECT_TRUE(top.refuses("combined", "the rated output needs the rated load, 1 N")) << top.words();
    ForceProject zero;
    zero.remove_readings({"Fx", "calibration", "zero_before", 1});
    EXPECT_TRUE(zero.warns("combined", "run 1 of Fx has no unloaded reading before: it is left out"))
        << zero.words();
}

TEST(ForceSensor, WithoutDecreasingLoadsHysteresisIsNotKnown) {
    ForceProject project;
    project.remove_readings({"Fz", "calibration", "decreasing", 0});
    EXPECT_TRUE(project.warns("combined", "Fz has no decreasing loads: its hysteresis is not known"))
        << project.words();
    EXPECT_EQ(numbers(table_with(project.asset_tables("sensor"), "table-3"), 3)[2], 0.0);
}

TEST(ForceSensor, TimesOfThePlanAreChecked) {
    ForceProject project;
    ASSERT_TRUE(project.prepare("combined"));
    EXPECT_TRUE(project.problems.empty()) << project.words();
    project.asset("sensor").values["load_time"] = Quantity{60.0, Unit::of("s")};
    EXPECT_TRUE(project.warns("combined", "run 1 of Fx: only 30 s between steps 1 and 2, 60 s are planned"))
        << project.words();
    project.asset("sensor").values["free_time"] = Quantity{5.0, Unit::of("min")};
    EXPECT_TRUE(
        project.warns("combined", "run 2 of Fx begins 120 s after the one before was unloaded, 300 s"))
        << project.words();
}

TEST(ForceSensor, ExchangedUnitsAreRefused) {
    ForceProject unit;
    unit.change_readings({"Fx", "calibration", "increasing", 1, 1}, [&](std::vector<SetupCell>& row) {
        row[unit.column("load_unit")] = std::string("Nm");
        return true;
    });
    EXPECT_TRUE(unit.refuses("combined", "Fx is a force, but its load is in Nm")) << unit.words();
    ForceProject large;
    large.change_readings({"Mx", "calibration", "increasing", 1, 1}, [&](std::vector<SetupCell>& row) {
        row[large.column("load")] = 200.0;
        return true;
    });
    EXPECT_TRUE(large.refuses("combined", "more than 1.2 times the rated load of Mx")) << large.words();
    ForceProject milli;  // a load in another unit of the same kind is read as it is meant
    milli.change_readings({"Mx", "", "", 0}, [&](std::vector<SetupCell>& row) {
        row[milli.column("load_unit")] = std::string("Nmm");
        row[milli.column("load")] = 1000.0 * std::get<double>(row[milli.column("load")]);
        return true;
    });
    EXPECT_TRUE(milli.prepare("combined")) << milli.words();
    EXPECT_NEAR(numbers(table_with(milli.asset_tables("sensor"), "table-1"), 2)[3], 0.64724, 1e-9);
}

TEST(ForceSensor, AChannelThatDoesNotRespond) {
    ForceProject project;
    project.change_readings({}, [&](std::vector<SetupCell>& row) {
        row[project.column("My")] = -0.02905;
        return true;
    });
    EXPECT_TRUE(project.refuses("combined", "My")) << project.words();
    EXPECT_TRUE(project.words().find("does not respond") != std::string::npos ||
                project.words().find("stuck") != std::string::npos)
        << project.words();
}

TEST(ForceSensor, ExchangedColumnsAreRefused) {
    ForceProject project;
    project.change_readings({}, [&](std::vector<SetupCell>& row) {
        std::swap(row[project.column("Fx")], row[project.column("Fy")]);
        return true;
    });
    EXPECT_TRUE(project.refuses("combined", "more than to its own load: are columns exchanged?"))
        << project.words();
}

TEST(ForceSensor, SaturatedReadingsAreRefused) {
    ForceProject stuck;
    stuck.change_readings({"Fx", "calibration", "", 0}, [&](std::vector<SetupCell>& row) {
        double& reading = std::get<double>(row[stuck.column("Fx")]);
        reading = std::min(reading, 0.4);
        return true;
    });
    EXPECT_TRUE(stuck.refuses("combined", "the indicator is saturated")) << stuck.words();
    ForceProject range;
    range.asset("sensor").values["range"] = Quantity{0.6, Unit::of("mV/V")};
    EXPECT_TRUE(range.refuses("combined", "the end of the indicator's range")) << range.words();
}

TEST(ForceSensor, TheMachineMustLoadEveryAxis) {
    ForceProject project;
    project.table("machine", "loads").rows.pop_back();
    EXPECT_TRUE(project.refuses("combined", "states no uncertainty of its load on Mz")) << project.words();
}

TEST(ForceSensor, FewerChannelsThanSixWork) {
    ForceProject project;
    auto& channels = project.table("sensor", "channels").rows;
    channels.erase(channels.begin() + 3, channels.end());
    for (const char* const axis : {"Mx", "My", "Mz"}) project.remove_readings({axis, "", "", 0});
    project.table("sensor", "stated").rows.clear();
    project.table("sensor", "stated_interference").rows.clear();
    const UncertaintyResult r = project.first_order("combined");
    EXPECT_EQ(r.outputs.size(), 9u);
    expect_rounds_to(numbers(table_with(project.asset_tables("sensor"), "table-3"), 4),
                     {.00335, .00468, .00426}, 1e-5, "interference");
}

}  // namespace
}  // namespace covaria::force_sensor_test
