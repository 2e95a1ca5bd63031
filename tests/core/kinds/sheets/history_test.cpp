// The history of an instrument: drift, component, due day, against figures computed by another program and
// against simulated histories.
#include "core/kinds/sheets/history_fit.h"

#include <cmath>
#include <random>

#include "tests/core/kinds/sheets/made_sheet.h"

namespace covaria::sheets_test {
namespace {

using sheets::DueRule;
using sheets::fit_of;
using sheets::HistoryFit;
using sheets::HistorySetup;

constexpr double nano = 1e-9;

std::vector<SetupCell> calibration(const char* date, double found, SetupCell left = {}, SetupCell u = {}) {
    return {std::string(date), found, std::move(left), std::move(u)};
}

/// The gauge block of projects/gauge-block-history.covaria, nm.
covaria::Setup gauge_history() {
    covaria::Setup setup;
    SetupTable table;
    table.units = {Unit{}, Unit{}, Unit{}, Unit{}};
    table.rows = {calibration("2019-02-04", 12), calibration("2020-02-10", 20), calibration("2021-02-08", 25),
                  calibration("2022-02-07", 38), calibration("2023-02-06", 44), calibration("2024-02-05", 50),
                  calibration("2025-02-03", 63)};
    setup.values["history"] = table;
    setup.values["unit"] = std::string("nm");
    setup.values["common_u"] = Quantity{8.0, Unit{}};
    setup.values["used_on"] = std::string("2025-11-28");
    setup.values["rule"] = std::string("drift");
    setup.values["limit"] = Quantity{30.0, Unit{}};
    return setup;
}

SetupTable& rows_of(covaria::Setup& setup) {
    return std::get<SetupTable>(setup.values["history"]);
}

HistorySetup read(const covaria::Setup& setup) {
    Problems problems;
    const SetupSchema schema = sheets::history_fields().schema();
    const auto made = sheets::read_history_setup(SetupReader(schema, setup), AssetLibrary{}, problems);
    EXPECT_TRUE(made) << (problems.items().empty() ? "" : problems.items().front().message.english());
    return made.value_or(HistorySetup{});
}

std::string complaints(const covaria::Setup& setup) {
    Problems problems;
    made("instrument-history", setup, problems);
    std::string all;
    for (const Problem& problem : problems.items()) all += problem.path + " ";
    return all;
}

Days day(int year, unsigned month, unsigned of_month) {
    return std::chrono::year_month_day{std::chrono::year(year), std::chrono::month(month),
                                       std::chrono::day(of_month)};
}

/// Figures of a least-squares line and of a search day by day, computed in Python.
TEST(History, AgreesWithAnotherProgram) {
    const auto model = made("instrument-history", gauge_history());
    const FirstOrderOutput year = first_order(*model, "D_a");
    EXPECT_NEAR(year.estimate / nano, 8.296425605159214, 1e-9);
    EXPECT_NEAR(year.standard_uncertainty / nano, 0.4146090115030331, 1e-9);
    EXPECT_NEAR(year.effective_degrees_of_freedom, 5.0, 1e-9);
    const FirstOrderOutput d = first_order(*model, "d");
    EXPECT_NEAR(d.estimate / nano, 6.768883861293487, 1e-9);
    EXPECT_NEAR(d.standard_uncertainty / nano, 0.3382710073317012, 1e-9);
    const FirstOrderOutput v = first_order(*model, "V");
    EXPECT_NEAR(v.estimate / nano, 67.5956961444941, 1e-9);
    EXPECT_NEAR(v.standard_uncertainty / nano, 8.484042390921749, 1e-9);
    HistorySetup setup = read(gauge_history());
    const HistoryFit fit = fit_of(setup);
    const auto then = predicted(setup, fit, sheets::years_between(setup.values.back().day, *setup.use));
    EXPECT_NEAR(then.half_width / nano, 7.445425875956889, 1e-9);
    EXPECT_NEAR(then.u_rectangular / nano, 7.445425875956889 / std::sqrt(3.0), 1e-9);
    EXPECT_NEAR(then.u / nano, 8.484042390921749, 1e-9) << "as the model has it";
    EXPECT_EQ(due_day(setup, fit)->day, day(2028, 5, 18));
    setup.rule = DueRule::deviation;
    setup.limit = 120.0;
    EXPECT_EQ(due_day(setup, fit)->day, day(2030, 1, 23));
}

TEST(History, TheLongestIntervalAndALimitThatIsPassedAlreadyAreSaid) {
    HistorySetup setup = read(gauge_history());
    const HistoryFit fit = fit_of(setup);
    setup.longest_years = 1.0;
    auto due = due_day(setup, fit);
    EXPECT_TRUE(due->by_longest);
    EXPECT_EQ(due->day, day(2026, 2, 3));
    setup.rule = DueRule::deviation;
    due = due_day(setup, fit);
    EXPECT_TRUE(due->at_once) << "60 nm are more than 30";
    setup.rule = DueRule::none;
    EXPECT_FALSE(due_day(setup, fit));
}

/// A step of the value by an adjustment is no drift, whatever its size.
TEST(History, AdjustmentsAreTakenOut) {
    const HistoryFit plain = fit_of(read(gauge_history()));
    covaria::Setup adjusted = gauge_history();
    SetupTable& table = rows_of(adjusted);
    table.rows[2][2] = 5.0;  // 25 is made 5
    for (std::size_t row = 3; row < table.rows.size(); ++row)
        table.rows[row][1] = std::get<double>(table.rows[row][1]) - 20.0;
    table.rows[5][2] = 31.0;  // 30 is made 31
    table.rows[6][1] = std::get<double>(table.rows[6][1]) + 1.0;
    const HistorySetup setup = read(adjusted);
    const HistoryFit fit = fit_of(setup);
    EXPECT_NEAR(fit.rate / nano, plain.rate / nano, 1e-9);
    EXPECT_NEAR(fit.u_rate / nano, plain.u_rate / nano, 1e-9);
    EXPECT_NEAR(predicted(setup, fit, 0.0).value / nano,
                predicted(read(gauge_history()), plain, 0.0).value / nano - 19.0, 1e-9);
}

/// By JCGM 100 H.3 with weights: u of the rate is 1/sqrt(sum w (t - t_m)^2).
TEST(History, StatedUncertaintiesWeigh) {
    covaria::Setup setup = gauge_history();
    rows_of(setup).rows = {calibration("2020-01-01", 0.0, {}, 1.0), calibration("2024-01-01", 8.0, {}, 2.0)};
    setup.values["uncertainty"] = std::string("stated");
    setup.values.erase("used_on");
    const auto model = made("instrument-history", setup);
    EXPECT_EQ(model->outputs().size(), 1u);
    const FirstOrderOutput year = first_order(*model, "D_a");
    const double years = 1461.0 / 365.25;  // 2020 and three other years
    EXPECT_NEAR(year.estimate / nano, 8.0 / years, 1e-12);
    EXPECT_NEAR(year.standard_uncertainty / nano, std::hypot(1.0, 2.0) / years, 1e-12);
    EXPECT_EQ(year.effective_degrees_of_freedom, infinity);
}

/// (D_a - true)/u is Student's t with nu = n - 2: its square has the mean nu/(nu - 2) and the variance
/// 2 nu^2 (nu - 1)/((nu - 2)^2 (nu - 4)), for nu = 10.
TEST(History, UncertaintyOfTheDriftIsThatOfSimulatedHistories) {
    std::mt19937_64 random(48);
    std::normal_distribution<double> scatter(0.0, 3.0);
    constexpr int histories = 4000;
    constexpr double nu = 10.0, true_rate = 2.5;
    double sum = 0.0;
    for (int k = 0; k < histories; ++k) {
        HistorySetup setup;
        for (int i = 0; i < 12; ++i) {
            const Days at = day(2010 + i, 1, 1 + unsigned(i));
            const double year = i > 0 ? sheets::years_between(setup.values.front().day, at) : 0.0;
            setup.values.push_back({at, true_rate * year + scatter(random), 0.0});
        }
        const HistoryFit fit = fit_of(setup);
        sum += std::pow((fit.rate - true_rate) / fit.u_rate, 2);
    }
    const double variance = 2.0 * nu * nu * (nu - 1.0) / ((nu - 2.0) * (nu - 2.0) * (nu - 4.0));
    EXPECT_NEAR(sum / histories, nu / (nu - 2.0), 4.0 * std::sqrt(variance / histories));
}

TEST(History, RefusesWhatIsNone) {
    const std::string dates = "/history/rows/1/date ";
    covaria::Setup setup = gauge_history();
    rows_of(setup).rows[1][0] = std::string("10.2.2020");
    EXPECT_EQ(complaints(setup), dates);
    rows_of(setup).rows[1][0] = std::string("2019-02-04");
    EXPECT_EQ(complaints(setup), dates) << "the same day";
    setup = gauge_history();
    rows_of(setup).rows.resize(2);
    EXPECT_EQ(complaints(setup), "/history ") << "two have no scatter";
    setup = gauge_history();
    setup.values["uncertainty"] = std::string("stated");
    EXPECT_NE(complaints(setup).find("/history/rows/6/u"), std::string::npos);
    setup = gauge_history();
    setup.values["used_on"] = std::string("2025-02-02");
    EXPECT_EQ(complaints(setup), "/used_on ") << "before the last calibration";
    setup = gauge_history();
    setup.values.erase("limit");
    EXPECT_EQ(complaints(setup), "/limit ");
    setup = gauge_history();
    setup.values["symbol"] = std::string("d");
    EXPECT_EQ(complaints(setup), "/symbol ");
}

}  // namespace
}  // namespace covaria::sheets_test
