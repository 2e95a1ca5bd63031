// The model "measurement equation": statements about quantities, places of mistakes, names without rows.
#include <gtest/gtest.h>

#include <cmath>

#include "core/kinds/registries.h"
#include "core/model/asset.h"
#include "core/propagation/engine.h"
#include "core/quantity/statement.h"

namespace covaria::equation_model_text_test {
namespace {

const ModelDescriptor& descriptor() {
    return *find_model("measurement-equation");
}

using Row = std::vector<SetupCell>;  // symbol, name, value, unit, statement, a, b, stated_unit, nu, r_u
const SetupCell none{};

SetupTable table(const std::string& field, std::vector<Row> rows) {
    SetupTable made;
    const FieldSpec& spec = *descriptor().schema.find(field);
    for (const ColumnSpec& column : spec.columns) made.units.push_back(column.unit);
    for (Row& row : rows) {
        row.resize(spec.columns.size());
        made.rows.push_back(std::move(row));
    }
    return made;
}

Row quantity(const char* symbol, const SetupCell& value, const char* unit, const char* statement = "constant",
             const SetupCell& a = {}, const SetupCell& b = {}, const SetupCell& nu = {},
             const SetupCell& stated_unit = {}) {
    return {std::string(symbol), none, value, std::string(unit), std::string(statement), a, b,
            stated_unit,         nu};
}

covaria::Setup setup_of(const std::string& equations, std::vector<Row> quantities,
                        std::vector<Row> observations = {}) {
    covaria::Setup setup;
    setup.values["equations"] = equations;
    setup.values["quantities"] = table("quantities", std::move(quantities));
    if (!observations.empty()) setup.values["observations"] = table("observations", std::move(observations));
    return setup;
}

std::unique_ptr<MeasurementModel> model_of(const covaria::Setup& setup, Problems& problems) {
    check_setup(descriptor().schema, setup, problems);
    if (problems.has_errors()) return nullptr;
    return descriptor().create(SetupReader(descriptor().schema, setup), AssetLibrary{}, problems);
}

UncertaintyResult first_order(const covaria::Setup& setup) {
    Problems problems;
    const auto model = model_of(setup, problems);
    for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << ": " << p.message.english();
    return evaluate_first_order(*model, model->inputs(), {}).value();
}

TEST(EquationModel, StatementsGiveTheirStandardUncertainties) {
    struct Case {
        const char* statement;
        SetupCell value, a, b, nu;
        double u, degrees_of_freedom;
        const char* distribution;
    };
    const double inf = infinity;
    for (const Case& c : std::vector<Case>{
             {"standard", 1.0, 0.2, none, none, 0.2, inf, "normal"},
             {"standard", 1.0, 0.2, none, 8.0, 0.2, 8, "student-t"},
             {"standard-deviation", 1.0, 0.3, 9.0, 24.0, 0.1, 24, "normal"},
             {"standard-deviation", 1.0, 0.3, none, none, 0.3, inf, "normal"},
             {"certificate-k", 1.0, 0.3, 3.0, none, 0.1, inf, "normal"},
             {"certificate-p", 1.0, 0.3, 95.0, none, 0.3 / 1.959963985, inf, "normal"},
             {"certificate-p", 1.0, 0.3, 99.0, 5.0, 0.3 / 4.032142984, 5, "student-t"},
             {"rectangular", 1.0, 0.3, none, none, 0.3 / std::sqrt(3.0), inf, "rectangular"},
             {"limits", none, 1.0, 1.6, none, 0.3 / std::sqrt(3.0), inf, "rectangular"},
             {"triangular", 1.0, 0.3, none, none, 0.3 / std::sqrt(6.0), inf, "triangular"},
             {"arcsine", 1.0, 0.3, none, none, 0.3 / std::sqrt(2.0), inf, "arcsine"},
             {"trapezoidal", 1.0, 0.3, 0.5, none, 0.3 * std::sqrt(1.25 / 6.0), inf, "trapezoidal"},
             {"curvilinear-trapezoid", 1.0, 0.3, 0.1, none, std::sqrt(0.03 + 0.01 / 9.0), inf,
              "curvilinear-trapezoid"},
             {"resolution", 1.0, 0.1, none, none, 0.1 / std::sqrt(12.0), inf, "rectangular"},
             {"mpe", 10.0, 0.1, 2.0, none, 0.3 / std::sqrt(3.0), inf, "rectangular"},
             {"exponential", 2.0, none, none, none, 2.0, inf, "exponential"},
             {"counts", none, 15.0, none, none, 4.0, inf, "gamma"},
             {"laplace", 1.0, 0.3, none, none, 0.3, inf, "laplace"},
             {"laplace-scale", 1.0, 0.3, none, none, 0.3 * std::sqrt(2.0), inf, "laplace"},
             {"weibull", none, 2.0, 3.0, none,
              2.0 * std::sqrt(std::tgamma(5.0 / 3.0) - std::pow(std::tgamma(4.0 / 3.0), 2.0)), inf,
              "weibull"},
             {"weibull-deviation", 1.8, 0.65, none, none, 0.65, inf, "weibull"},
             {"poisson", none, 9.0, none, none, 3.0, inf, "poisson"},
             {"poisson", 9.0, none, none, none, 3.0, inf, "poisson"},
             {"binomial", none, 50.0, 2.0, none, std::sqrt(0.98), inf, "binomial"},
             {"binomial", 1.0, 50.0, none, none, std::sqrt(0.98), inf, "binomial"}}) {
        const auto result =
            first_order(setup_of("y = x", {quantity("x", c.value, "1", c.statement, c.a, c.b, c.nu)}));
        EXPECT_NEAR(result.outputs[0].standard_uncertainty, c.u, 1e-8 * c.u) << c.statement;
        EXPECT_EQ(result.outputs[0].first_order.effective_degrees_of_freedom, c.degrees_of_freedom)
            << c.statement;
        EXPECT_EQ(result.inputs->components[0].distribution.kind(), c.distribution) << c.statement;
        EXPECT_EQ(result.inputs->components[0].type == EvaluationType::type_a,
                  c.statement == std::string("standard-deviation"));
        EXPECT_NEAR(result.inputs->components[0].distribution.mean(), 0.0, 1e-12) << c.statement;
    }
}

/// Each statement in its own unit is the same as in the row's; % and ppm are parts of the value.
TEST(EquationModel, AStatementMayHaveAUnitOfItsOwn) {
    const SetupCell um = std::string("um"), percent = std::string("%");
    const auto u = [](const Row& row) {
        return first_order(setup_of("y = x", {row})).outputs[0].standard_uncertainty;
    };
    for (const StatementKind& kind : statement_kinds()) {
        if (kind.a.empty() || !kind.a_has_unit) continue;
        const std::string key(kind.key);
        const bool limits = key == "limits", gives_value = limits || key == "weibull";
        const SetupCell value = gives_value ? none : SetupCell(2.0);
        const double a = 0.012, b = key == "certificate-p" ? 95.0
                                    : limits               ? 0.019
                                    : key == "trapezoidal" ? 0.5
                                    : key == "weibull"     ? 1.5
                                                           : 0.004;
        const double factor = kind.b_has_unit ? 1000.0 : 1.0;
        const bool counts = key == "certificate-k" || key == "standard-deviation";
        const double second = counts ? 2.0 : b;
        const SetupCell b_mm = kind.b.empty() ? none : SetupCell(second);
        const SetupCell b_um = kind.b.empty() ? none : SetupCell(factor * second);
        const double in_mm = u(quantity("x", value, "mm", key.c_str(), a, b_mm));
        EXPECT_GT(in_mm, 0.0) << key;
        EXPECT_NEAR(u(quantity("x", value, "mm", key.c_str(), 1000.0 * a, b_um, none, um)), in_mm,
                    1e-12 * in_mm)
            << key;
    }
    EXPECT_NEAR(u(quantity("x", -50.0, "mm", "standard", 2.0, none, none, std::string("ppm"))), 1e-7, 1e-20);
    EXPECT_NEAR(u(quantity("x", 0.5, "1", "standard", 1.0, none, none, percent)), 0.01, 1e-15)
        << "of a number a part is a number";
}

SetupTable weighted(const std::vector<std::pair<double, SetupCell>>& rows) {
    std::vector<Row> made;
    for (const auto& [value, weight] : rows) made.push_back({std::string("x"), none, none, value, weight});
    return table("observations", made);
}

UncertaintyResult of_list(const char* statement, const std::vector<std::pair<double, SetupCell>>& rows,
                          const char* unit = "mm") {
    covaria::Setup setup = setup_of("y = x", {quantity("x", none, unit, statement)});
    setup.values["observations"] = weighted(rows);
    return first_order(setup);
}

TEST(EquationModel, ASampleIsDrawnAsItIsListed) {
    const auto alike = of_list("sample", {{1.0, none}, {2.0, none}, {6.0, none}});
    EXPECT_NEAR(alike.outputs[0].estimate, 3e-3, 1e-15);
    EXPECT_NEAR(alike.outputs[0].standard_uncertainty, std::sqrt(14.0 / 3.0) * 1e-3, 1e-15);
    EXPECT_EQ(alike.inputs->components[0].distribution.kind(), "discrete");
    const auto weights = of_list("sample", {{1.0, 3.0}, {2.0, 1.0}});
    EXPECT_NEAR(weights.outputs[0].estimate, 1.25e-3, 1e-15);
    EXPECT_NEAR(weights.outputs[0].standard_uncertainty, std::sqrt(3.0) / 4.0 * 1e-3, 1e-15);
    const auto histogram = of_list("histogram", {{0.0, 1.0}, {1.0, 3.0}, {3.0, none}});
    EXPECT_NEAR(histogram.outputs[0].estimate, (0.25 * 0.5 + 0.75 * 2.0) * 1e-3, 1e-15);
    const double middle = 1.625, variance = 0.25 * (0.5 - middle) * (0.5 - middle) + 0.25 / 12.0 +
                                            0.75 * (2.0 - middle) * (2.0 - middle) + 0.75 * 4.0 / 12.0;
    EXPECT_NEAR(histogram.outputs[0].standard_uncertainty, std::sqrt(variance) * 1e-3, 1e-15);
    const auto celsius = of_list("sample", {{20.0, none}, {22.0, none}}, "degC");
    EXPECT_NEAR(celsius.outputs[0].estimate, 294.15, 1e-12);
    EXPECT_NEAR(celsius.outputs[0].standard_uncertainty, 1.0, 1e-12);
}

/// Quantities of one evaluation: u, r and a common nu are a multivariate t distribution, whose product moment
/// of squares is not that of independent ones (JCGM 102 5.3.2).
TEST(EquationModel, AnEnsembleRestsOnOneEstimateOfVariance) {
    const std::size_t at = SetupSchema::column(*descriptor().schema.find("quantities"), "ensemble");
    const auto member = [&](const char* symbol, double u, double nu) {
        Row row = quantity(symbol, 0.0, "mm", "standard", u, none, nu);
        row.resize(at + 1);
        row[at] = std::string("fit");
        return row;
    };
    const auto result = first_order(setup_of("y = a + b", {member("a", 3.0, 9.0), member("b", 4.0, 9.0)}));
    EXPECT_NEAR(result.outputs[0].standard_uncertainty, 5e-3, 1e-15);
    EXPECT_NEAR(result.outputs[0].first_order.effective_degrees_of_freedom, 9.0, 1e-9)
        << "they count once, not as two sources";
    ASSERT_EQ(result.inputs->variance_estimates.size(), 1u);
    EXPECT_EQ(result.inputs->variance_estimates[0].components.size(), 2u);
    Problems problems;
    model_of(setup_of("y = a + b", {member("a", 3.0, 9.0), member("b", 4.0, 8.0)}), problems);
    EXPECT_TRUE(problems.has_errors()) << "another nu";
}

TEST(EquationModel, SeveralComponentsOfOneQuantityAddUp) {
    auto rows = std::vector<Row>{quantity("x", 5.0, "mm", "standard", 0.003),
                                 quantity("x", none, "um", "standard", 4.0)};
    const auto result = first_order(setup_of("y = 2*x", rows));
    EXPECT_NEAR(result.outputs[0].standard_uncertainty, 2 * 5e-6, 1e-15);
    EXPECT_EQ(result.outputs[0].quantity.unit.text(), "mm");
    EXPECT_EQ(result.inputs->components.size(), 2u);
    EXPECT_EQ(result.inputs->components[1].id, "x.2");
}

TEST(EquationModel, AResultIsInTheUnitOfTheFirstQuantityOfItsDimension) {
    const auto rows = std::vector<Row>{
        quantity("t", 20.0, "degC", "standard", 0.1), quantity("t_0", 68.0, "degC", "standard", 0.1),
        quantity("a", 0.5, "mrad", "standard", 0.01), quantity("d", 215.0, "nm", "standard", 3.0),
        quantity("L", 50.0, "mm", "standard", 0.003)};
    const auto unit = [&](const std::string& equation) {
        return first_order(setup_of(equation, rows)).outputs[0].quantity.unit.text();
    };
    EXPECT_EQ(unit("y = L + d + 0*(t - t_0)/1[K]*L*a"), "nm");
    EXPECT_EQ(unit("y = L*d + 0*(t - t_0)/1[K]*L^2*a"), "m^2");
    EXPECT_EQ(unit("y = L/d + 0*(t - t_0)/1[K]*a"), "1");
    EXPECT_EQ(unit("y = t - t_0 + 0[K]*a*L/d"), "K");
}

TEST(EquationModel, RelativeUncertaintyOfUGivesDegreesOfFreedom) {
    Row row = quantity("x", 5.0, "1", "standard", 1.0);
    row.resize(10);
    row[9] = 25.0;
    EXPECT_NEAR(first_order(setup_of("y = x", {row})).outputs[0].first_order.effective_degrees_of_freedom,
                8.0, 1e-12);
}

// JCGM 100 4.2 and 5.2.3; the pooled standard deviation of 4.2.4.
TEST(EquationModel, ObservationsGiveMeansAndCovariances) {
    const std::vector<double> a{1.0, 1.2, 1.1, 0.9}, b{2.0, 2.3, 2.1, 2.2};
    std::vector<Row> observed;
    for (std::size_t k = 0; k < 4; ++k) {
        observed.push_back({std::string("a"), double(k + 1), none, a[k]});
        observed.push_back({std::string("b"), double(k + 1), none, b[k]});
    }
    const auto result = first_order(setup_of(
        "y = a + b", {quantity("a", none, "1", "observations"), quantity("b", none, "1", "observations")},
        observed));
    double s_aa = 0, s_bb = 0, s_ab = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        s_aa += std::pow(a[k] - 1.05, 2);
        s_bb += std::pow(b[k] - 2.15, 2);
        s_ab += (a[k] - 1.05) * (b[k] - 2.15);
    }
    EXPECT_NEAR(result.outputs[0].estimate, 3.2, 1e-12);
    EXPECT_NEAR(result.outputs[0].standard_uncertainty, std::sqrt((s_aa + s_bb + 2 * s_ab) / 12.0), 1e-12);
    EXPECT_NEAR(result.outputs[0].first_order.effective_degrees_of_freedom, 3.0, 1e-9);

    const std::vector<Row> pooled{{std::string("a"), none, std::string("earlier"), 5.0},
                                  {std::string("a"), none, std::string("earlier"), 5.4},
                                  {std::string("a"), none, none, 1.0},
                                  {std::string("a"), none, none, 1.2},
                                  {std::string("a"), none, none, 1.1}};
    const auto of_pool = first_order(setup_of("y = a", {quantity("a", none, "1", "pooled")}, pooled));
    EXPECT_NEAR(of_pool.outputs[0].estimate, 1.1, 1e-12);
    EXPECT_NEAR(of_pool.outputs[0].standard_uncertainty, std::sqrt((0.08 + 0.02) / 3.0) / std::sqrt(3.0),
                1e-12);
    EXPECT_EQ(of_pool.outputs[0].first_order.effective_degrees_of_freedom, 3.0);
}

struct Refusal {
    const char* name;
    covaria::Setup setup;
    std::string path, words;
};

TEST(EquationModel, ProblemsHaveTheirPlace) {
    const Row x = quantity("x", 1.0, "mm", "standard", 0.1);
    const std::vector<Refusal> refusals{
        {"dimension", setup_of("y = 2*x\nz = x + 20 [degC]", {x}), "/equations/1/7-7", "cannot be added"},
        {"unknown", setup_of("y = x + q", {x}), "/equations/0/9-9", "'q' is neither"},
        {"empty", setup_of("# nothing", {x}), "/equations/0/1-1", "there is no equation"},
        {"zero at the estimate", setup_of("y = x/(x - 1 [mm])", {x}), "/equations/0/5-18", "no value"},
        {"no solution", setup_of("solve y = 1 [mm]: y^2 = -x*x", {x}), "/equations/0/23-23", "no solution"},
        {"reserved", setup_of("y = x", {x, quantity("sin", 1.0, "1")}), "/quantities/rows/1/symbol",
         "function"},
        {"defined", setup_of("y = x", {x, quantity("y", 1.0, "1")}), "/quantities/rows/1/symbol",
         "defined by an equation"},
        {"unit", setup_of("y = x", {quantity("x", 1.0, "parsec")}), "/quantities/rows/0/unit", "not known"},
        {"unit of the statement",
         setup_of("y = x", {quantity("x", 1.0, "mm", "standard", 0.1, none, none, std::string("kg"))}),
         "/quantities/rows/0/statement", "no unit for a quantity"},
        {"part of no value",
         setup_of("y = x", {quantity("x", none, "mm", "standard", 0.1, none, none, std::string("ppm"))}),
         "/quantities/rows/0/statement", "needs the value"},
        {"no unit of the statement",
         setup_of("y = x", {quantity("x", 1.0, "mm", "standard", 0.1, none, none, std::string("parsec"))}),
         "/quantities/rows/0/stated_unit", "not known"},
        {"no value", setup_of("y = x", {quantity("x", none, "mm", "standard", 0.1)}),
         "/quantities/rows/0/value", "missing"},
        {"no figure", setup_of("y = x", {quantity("x", 1.0, "mm", "certificate-k", 0.1)}),
         "/quantities/rows/0/statement", "coverage factor"},
        {"two values", setup_of("y = x", {x, x}), "/quantities/rows/1/value", "only the first row"},
        {"no observations", setup_of("y = x", {quantity("x", none, "mm", "observations")}),
         "/quantities/rows/0/statement", "no rows"},
        {"no instrument", setup_of("y = x", {quantity("x", 1.0, "mm", "instrument")}),
         "/quantities/rows/0/instrument", "missing"},
    };
    for (const Refusal& r : refusals) {
        Problems problems;
        EXPECT_EQ(model_of(r.setup, problems), nullptr) << r.name;
        const bool found =
            std::any_of(problems.items().begin(), problems.items().end(), [&](const Problem& p) {
                return p.path == r.path && p.message.english().find(r.words) != std::string::npos;
            });
        EXPECT_TRUE(found) << r.name << " -> "
                           << (problems.empty()
                                   ? ""
                                   : problems.items()[0].path + ": " + problems.items()[0].message.english());
    }
}

TEST(EquationModel, AddsRowsForNames) {
    covaria::Setup setup;
    setup.values["equations"] = std::string("y = a*b\nz = y + c");
    const covaria::Setup completed = descriptor().completed(setup);
    const auto& quantities = std::get<SetupTable>(completed.values.at("quantities"));
    ASSERT_EQ(quantities.rows.size(), 3u);
    EXPECT_EQ(quantities.rows[2][0], SetupCell(std::string("c")));
    const auto& outputs = std::get<SetupTable>(completed.values.at("outputs"));
    ASSERT_EQ(outputs.rows.size(), 1u);
    EXPECT_EQ(outputs.rows[0][0], SetupCell(std::string("z")));
    EXPECT_EQ(descriptor().completed(completed), completed);
}

// A trial that has no value is counted, and the others are right.
TEST(EquationModel, TrialsWithoutAValueAreCounted) {
    Problems problems;
    const auto model =
        model_of(setup_of("solve y = 1: y^2 = x", {quantity("x", 0.1, "1", "standard", 0.1)}), problems);
    ASSERT_TRUE(model);
    EvaluationOptions options;
    options.trials = 20'000;
    const auto result = evaluate(*model, model->inputs(), options).value();
    EXPECT_NEAR(double(result.failed_trials) / 20'000, 0.158655, 4 * std::sqrt(0.1587 * 0.8413 / 20'000));
}

}  // namespace
}  // namespace covaria::equation_model_text_test
