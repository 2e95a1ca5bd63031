// Every place where a unit may be typed, with a unit of temperature in it: what is read as a temperature is
// one, what is a difference is one, and what may be either is refused. One rule, core/base/temperature.h.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "core/base/temperature.h"
#include "core/kinds/registries.h"
#include "core/project/csv_table.h"
#include "core/project/remedies.h"
#include "core/project/set_values.h"
#include "core/quantity/statement.h"
#include "tests/core/made.h"

namespace covaria::temperature_doors_test {
namespace {

constexpr double refused = std::numeric_limits<double>::quiet_NaN();

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}

std::string in_quotation(const std::string& text) {
    return '"' + text + '"';
}

/// A row: symbol, value, unit, statement, a, b, unit of a and b; as JSON.
std::string row(const std::string& symbol, const std::string& value, const std::string& unit,
                const std::string& statement = "constant", const std::string& a = "null",
                const std::string& b = "null", const std::string& stated_unit = "") {
    return "[" + in_quotation(symbol) + ", " + value + ", " + in_quotation(unit) + ", " +
           in_quotation(statement) + ", " + a + ", " + b + ", " +
           (stated_unit.empty() ? "null" : in_quotation(stated_unit)) + "]";
}

std::string analysis(const std::string& id, const std::string& equation, const std::string& rows,
                     const std::string& output_unit = "", const std::string& further = "") {
    return R"({"id": ")" + id + R"(", "model": "measurement-equation", "setup": {"equations": [")" +
           equation +
           R"("], "quantities": {"columns": ["symbol", "value", "unit", "statement", "a", "b", "stated_unit"], "rows": [)" +
           rows + R"(]}, "outputs": {"columns": ["symbol", "unit"], "rows": [["y", )" +
           (output_unit.empty() ? "null" : in_quotation(output_unit)) +
           R"(]]}}, "options": {"method": "first-order"})" + (further.empty() ? "" : ", ") + further + "}";
}

LoadedProject project_of(const std::string& analyses) {
    return parse_project(
        R"({"format": "covaria", "schemaVersion": 2, "title": "", "assets": [], "analyses": [)" + analyses +
            "]}",
        {}, "doors");
}

struct Found {
    std::string objection;  ///< empty: none
    double estimate = refused, u = refused;
};

/// The output y of the analysis a, or the first objection.
Found found_in(const LoadedProject& loaded) {
    Found found;
    for (const Problem& problem : loaded.problems.items())
        if (problem.severity == Severity::error && found.objection.empty())
            found.objection = problem.path + ": " + problem.message.english();
    Problems problems;
    const auto made = found.objection.empty() ? made_analysis(loaded.project, "a", problems) : nullptr;
    if (!made || !made->propagated->propagation()) return found;
    found.estimate = made->propagated->propagation()->law.estimate(0);
    found.u = made->propagated->propagation()->law.uncertainty(0);
    return found;
}

/// "@" stands for the unit that is typed; `in_celsius` and `in_kelvin` for what comes out, SI.
struct Door {
    const char* name;
    std::string analyses;
    double in_celsius, in_kelvin;
    bool of_u = false;
};

std::vector<Door> doors_of_equations() {
    const std::string gain = row("x", "0.1", "1", "standard", "0.001");
    const std::string t = row("t", "20", "@", "standard", "0.1", "null", "K");
    const std::string t0 = row("t_0", "15", "@");
    return {
        {"factor", analysis("a", "y = 2 + 0.01 [1/K]*t", t), refused, 2.2},
        {"square", analysis("a", "y = 1 + 0.01 [1/K^2]*t^2", t), refused, 5.0},
        {"gain", analysis("a", "y = t*(1 + x)", t + ", " + gain), refused, 22.0},
        {"exact gain", analysis("a", "y = t*1.1", t), refused, 22.0},
        {"shift", analysis("a", "y = t + 3 [K]", t), 296.15, 23.0},
        {"difference", analysis("a", "y = x*(t - t_0)", t + ", " + t0 + ", " + gain), 0.5, 0.5},
        {"ratio", analysis("a", "y = t/t_0", t + ", " + t0), 293.15 / 288.15, 20.0 / 15.0},
        {"ratio to the other", analysis("a", "y = t/t_0", t + ", " + row("t_0", "15", "K")), refused,
         20.0 / 15.0},
        {"reading in degC", analysis("a", "y = x*(t - 0 [degC])", t + ", " + gain), 2.0, refused},
        {"constant", analysis("a", "y = x*20 [@]", gain), refused, 2.0},
        {"constant taken away", analysis("a", "y = x*(t - 15 [@])", replaced(t, "@", "degC") + ", " + gain),
         0.5, refused},
        {"unit of a difference", analysis("a", "y = t - t_0", replaced(t + ", " + t0, "@", "degC"), "@"),
         refused, 5.0},
        {"unit of a temperature", analysis("a", "y = t", replaced(t, "@", "degC"), "@"), 293.15, 293.15},
        {"unit of a multiple", analysis("a", "y = t*(1 + x)", replaced(t, "@", "degC") + ", " + gain, "@"),
         refused, refused},
        {"comparison", analysis("a", "y = if(t > 20.5 [@], 1, 2)", replaced(t, "@", "degC")), 2.0, 1.0},
    };
}

std::vector<Door> doors_of_statements() {
    const auto stated = [](const char* name, const std::string& rows, double in_celsius, double in_kelvin,
                           bool of_u) {
        return Door{name, analysis("a", "y = t", rows), in_celsius, in_kelvin, of_u};
    };
    return {
        stated("u of a temperature", row("t", "20", "degC", "standard", "0.1", "null", "@"), 0.1, 0.1, true),
        stated("u of a difference", row("t", "20", "K", "standard", "0.1", "null", "@"), 0.1, 0.1, true),
        stated("half-width", row("t", "20", "degC", "rectangular", "0.3", "null", "@"), std::sqrt(0.03),
               std::sqrt(0.03), true),
        stated("limits of a temperature", row("t", "null", "degC", "limits", "19", "21", "@"), 293.15, 20.0,
               false),
        stated("limits of a difference", row("t", "null", "K", "limits", "19", "21", "@"), refused, 20.0,
               false),
        stated("MPE", row("t", "20", "@", "mpe", "0.3", "null", "K"), std::sqrt(0.03), std::sqrt(0.03), true),
        stated("MPE with a part of the value", row("t", "20", "@", "mpe", "0.3", "0.5", "K"), refused,
               0.4 / std::sqrt(3.0), true),
        stated("exponential", row("t", "20", "@", "exponential"), refused, 20.0, true),
        stated("further row with a part of the value",
               row("t", "20", "@", "standard", "0.1", "null", "K") + ", " +
                   row("t", "null", "K", "standard", "1", "null", "%"),
               refused, std::hypot(0.1, 0.2), true),
    };
}

/// Output of an analysis "up" in a unit, taken for the quantity t of a.
std::vector<Door> doors_of_links() {
    std::vector<Door> doors;
    const std::string link = R"("links": [{"input": "t", "analysis": "up", "output": "y"}])";
    const auto link_from = [&](const char* name, const std::string& upstream, const std::string& equation,
                               double in_celsius, double in_kelvin) {
        doors.push_back(
            {name,
             upstream + ", " +
                 analysis("a", equation, row("t", "20", "@", "standard", "0.1", "null", "K"), "", link),
             in_celsius, in_kelvin});
    };
    const std::string t = row("s", "23", "degC", "standard", "0.1", "null", "K");
    const std::string difference = analysis("up", "y = s - 20 [degC]", t, "K");
    const std::string in_celsius = analysis("up", "y = s", t, "degC"),
                      in_kelvin = analysis("up", "y = s", t, "K");
    const std::string unknown = analysis("up", "y = s", row("s", "3", "K", "standard", "0.1"), "K");
    link_from("difference", difference, "y = t", refused, 3.0);
    link_from("temperature in degC", in_celsius, "y = t", 296.15, refused);
    link_from("temperature in K", in_kelvin, "y = t", 296.15, 296.15);
    link_from("what may be either", unknown, "y = t", refused, 3.0);
    return doors;
}

std::vector<Door> doors_of_analyses() {
    std::vector<Door> doors;
    const auto add = [&](const char* name, const std::string& unit, const std::string& further,
                         double in_celsius, double in_kelvin) {
        doors.push_back(
            {name,
             analysis("a", "y = t", row("t", "20", unit, "standard", "0.1", "null", "K"), unit, further),
             in_celsius, in_kelvin});
    };
    for (const std::string unit : {"degC", "K"}) {
        const bool is_temperature = unit == "degC";
        const double value = is_temperature ? 293.15 : 20.0, none = is_temperature ? value : refused;
        for (const std::string limit : {"lowerLimit", "upperLimit"})
            add("limit", unit,
                R"("requirements": [{"symbol": "y", ")" + limit + R"(": {"value": 20, "unit": "@"}}])", none,
                value);
        add("prior mean", unit,
            R"("requirements": [{"symbol": "y", "lowerLimit": {"value": 20, "unit": ")" + unit +
                R"("}, "priorMean": {"value": 20, "unit": "@"}, "priorStandardDeviation": {"value": 1, "unit": "K"}}])",
            none, value);
        add("estimate", unit, R"("inputs": [{"symbol": "t", "estimate": {"value": 25, "unit": "@"}}])",
            is_temperature ? 298.15 : refused, 25.0);
        add("target uncertainty", unit,
            R"("requirements": [{"symbol": "y", "targetUncertainty": {"value": 1, "unit": "@"}}])", none,
            value);
        const std::string ends = R"("from": 18, "to": 22, "unit": "@")";
        for (const std::string target : {"/inputs/t/estimate"}) {
            add("axis", unit,
                R"("studies": [{"id": "s", "axes": [{"target": ")" + target + "\", " + ends + "}]}]", none,
                value);
            add("axis, added", unit,
                R"("studies": [{"id": "s", "axes": [{"target": ")" + target + R"(", "change": "added", )" +
                    ends + "}]}]",
                refused, value);
            add("design", unit,
                R"("designs": [{"id": "d", "variables": [{"target": ")" + target + "\", " + ends + "}]}]",
                none, value);
        }
    }
    for (const std::string target :
         {"/inputs/t/estimate", "/setup/quantities/rows/0/value", "/setup/quantities/columns/value"}) {
        add("axis, factor", "@",
            R"("studies": [{"id": "s", "axes": [{"target": ")" + target +
                R"(", "change": "factor", "from": 0.9, "to": 1.1}]}])",
            refused, 20.0);
        add("reduction", "@",
            R"("designs": [{"id": "d", "reductions": [{"target": ")" + target + R"(", "price": 1}]}])",
            refused, 20.0);
    }
    return doors;
}

void expect_of(const Door& door, const std::string& unit, double expected) {
    const Found found = found_in(project_of(replaced(door.analyses, "@", unit)));
    const std::string where = std::string(door.name) + " with " + unit + ": " + found.objection;
    if (std::isnan(expected)) {
        EXPECT_FALSE(found.objection.empty()) << where << (door.of_u ? found.u : found.estimate);
        return;
    }
    EXPECT_TRUE(found.objection.empty()) << where;
    EXPECT_NEAR(door.of_u ? found.u : found.estimate, expected, 1e-12 * std::abs(expected)) << where;
}

void expect_taken(const Door& door, const std::string& unit, bool taken) {
    const Found found = found_in(project_of(replaced(door.analyses, "@", unit)));
    EXPECT_EQ(found.objection.empty(), taken) << door.name << " with " << unit << ": " << found.objection;
}

TEST(TemperatureDoors, EachTakesATemperatureOrADifferenceForWhatItIs) {
    std::size_t doors = 0;
    for (const auto& some :
         {doors_of_equations(), doors_of_statements(), doors_of_links(), doors_of_analyses()})
        for (const Door& door : some) {
            ++doors;
            for (const char* unit : {"degC", "°C", "℃"}) expect_of(door, unit, door.in_celsius);
            expect_of(door, "K", door.in_kelvin);
            // The other scale, and its interval: taken and refused as these.
            for (const char* unit : {"degF", "°F", "℉"})
                expect_taken(door, unit, !std::isnan(door.in_celsius));
            expect_taken(door, "degR", !std::isnan(door.in_kelvin));
        }
    EXPECT_GT(doors, 40u);
}

const char* const of_the_zero = "where the scale has its zero";

Found stated(const StatementKind& kind, const std::string& value, const char* unit, const char* stated_unit) {
    const std::string a = kind.a.empty() ? "null" : "1";
    const std::string b = kind.b.empty() || kind.b_optional ? "null" : kind.b_has_unit ? "0.1" : "0.5";
    return found_in(
        project_of(analysis("a", "y = t", row("t", value, unit, std::string(kind.key), a, b, stated_unit))));
}

// Every kind of statement whose figures have a unit.
TEST(TemperatureDoors, NoFigureIsAPartOfATemperature) {
    std::size_t accepted = 0;
    for (const StatementKind& kind : statement_kinds()) {
        if (kind.a.empty() || !kind.a_has_unit || kind.key == "limits") continue;
        for (const char* part : {"%", "ppm", "ppb"}) {
            const Found temperature = stated(kind, "20", "degC", part),
                        difference = stated(kind, "20", "K", part);
            EXPECT_NE(temperature.objection.find(of_the_zero), std::string::npos)
                << kind.key << " in " << part << ": " << temperature.objection;
            EXPECT_EQ(difference.objection.find(of_the_zero), std::string::npos)
                << kind.key << " in " << part;
            accepted += difference.objection.empty();
        }
    }
    EXPECT_GT(accepted, 25u);
}

// Distributions that begin at zero have their mean and their standard deviation from there.
TEST(TemperatureDoors, NoDistributionBeginsAtTheZeroOfTheScale) {
    std::set<std::string> refused_kinds;
    for (const StatementKind& kind : statement_kinds())
        for (const char* value : {"20", "null"})
            if (stated(kind, value, "degC", "K").objection.find(of_the_zero) != std::string::npos)
                refused_kinds.insert(std::string(kind.key));
    EXPECT_EQ(refused_kinds, (std::set<std::string>{"exponential", "weibull", "weibull-deviation", "poisson",
                                                    "binomial", "counts"}));
}

/// A value of a field or column with the dimension of temperature.
void expect_of_field(const std::string& where, const Unit& unit, const FieldSpec& field, const Setup& setup) {
    Problems problems;
    check_setup(SetupSchema({field}), setup, problems);
    if (unit.has_offset())
        EXPECT_FALSE(problems.has_errors()) << where << ": " << problems.items().front().message.english();
    else
        EXPECT_TRUE(problems.has_errors()) << where << " takes a temperature for a difference";
}

// All models and assets: what is a difference there is never given in degC.
TEST(TemperatureDoors, FieldsOfAllKindsTakeNoTemperatureForADifference) {
    const Dimension temperature = Unit::of("K").dimension();
    const Unit celsius = Unit::of("degC");
    std::size_t fields = 0;
    const auto check = [&](const std::string& kind, const SetupSchema& schema) {
        for (FieldSpec field : schema.fields()) {
            field.shown_if.reset();
            field.range = {};
            if (field.kind == FieldKind::number && field.unit.dimension() == temperature) {
                covaria::Setup setup;
                setup.values[field.key] = Quantity{20.0, celsius};
                expect_of_field(kind + ", " + field.key, field.unit, field, setup);
                ++fields;
            }
            for (const ColumnSpec& column : field.columns) {
                if (column.unit.dimension() != temperature) continue;
                EXPECT_EQ(column_unit_objection(field, column, celsius).empty(), column.unit.has_offset())
                    << kind << ", " << field.key << ", " << column.key;
                ++fields;
            }
        }
    };
    for (const auto& asset : asset_registry()) check(asset.kind, asset.schema);
    for (const auto& model : model_registry()) check(model.id, model.schema);
    EXPECT_GT(fields, 3u);
}

const Problem& first_error_of(const LoadedProject& loaded) {
    for (const Problem& problem : loaded.problems.items())
        if (problem.severity == Severity::error) return problem;
    static const Problem none;
    return none;
}

/// The same after the remedy number `index` of the first problem was taken.
Found mended_by(const std::string& analyses, std::size_t index) {
    const LoadedProject loaded = project_of(analyses);
    const Problem& problem = first_error_of(loaded);
    if (index >= problem.remedies.size()) {
        ADD_FAILURE() << analyses << ": " << problem.remedies.size() << " ways out";
        return {};
    }
    const Result<Project> project = mended(loaded.project, problem.remedies[index]);
    if (!project) {
        ADD_FAILURE() << project.error().message.english();
        return {};
    }
    return found_in(parse_project(project_text(*project), {}, "mended"));
}

TEST(TemperatureDoors, OneClickLeadsOut) {
    const std::string t = row("t", "20", "degC", "standard", "0.1", "null", "K");
    // R0 (1 + A t + B t²) of a platinum thermometer (IEC 60751) at 20 °C: 107.7935 ohm.
    const std::string pt100 = analysis("a", "y = 100*(1 + 0.0039083 [1/K]*t - 5.775e-7 [1/K^2]*t^2)", t);
    const double right = 100.0 * (1.0 + 0.0039083 * 20.0 - 5.775e-7 * 400.0);
    for (const std::size_t way : {0u, 1u}) EXPECT_NEAR(mended_by(pt100, way).estimate, right, 1e-10) << way;
    EXPECT_NEAR(mended_by(pt100, 2).estimate, 100.0 * (1.0 + 0.0039083 * 293.15 - 5.775e-7 * 293.15 * 293.15),
                1e-10);
    EXPECT_NEAR(mended_by(analysis("a", "y = 3 [1/K]*20 [degC]", t), 0).estimate, 60.0, 1e-12);
    // IEC 60751, class B: 0.3 °C + 0.5 % of the reading.
    EXPECT_NEAR(mended_by(analysis("a", "y = t", row("t", "-20", "degC", "mpe", "0.3", "0.5", "K")), 0).u,
                0.4 / std::sqrt(3.0), 1e-12);
    const Found part =
        mended_by(analysis("a", "y = t", row("t", "20", "degC", "rectangular", "1", "null", "%")), 0);
    EXPECT_NEAR(part.u, 0.2 / std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(part.estimate, 293.15, 1e-12);
    // Limits in degC of what is given in K: a difference, or a temperature.
    const std::string limits = analysis("a", "y = t", row("t", "null", "K", "limits", "19", "21", "degC"));
    EXPECT_NEAR(mended_by(limits, 0).estimate, 20.0, 1e-12);
    EXPECT_NEAR(mended_by(limits, 1).estimate, 293.15, 1e-12);
    const std::string difference = row("t", "20", "K", "standard", "0.1", "null", "K");
    for (
        const char* place :
        {R"("requirements": [{"symbol": "y", "lowerLimit": {"value": 20, "unit": "degC"}}])",
         R"("requirements": [{"symbol": "y", "lowerLimit": {"value": 1, "unit": "K"}, "priorMean": {"value": 20, "unit": "degC"}, "priorStandardDeviation": {"value": 1, "unit": "K"}}])",
         R"("inputs": [{"symbol": "t", "estimate": {"value": 20, "unit": "degC"}}])",
         R"("studies": [{"id": "s", "axes": [{"target": "/inputs/t/estimate", "from": 18, "to": 22, "unit": "degC"}]}])",
         R"("studies": [{"id": "s", "axes": [{"target": "/inputs/t/estimate", "change": "added", "from": 1, "to": 2, "unit": "degC"}]}])",
         R"("designs": [{"id": "d", "variables": [{"target": "/inputs/t/estimate", "from": 18, "to": 22, "unit": "degC"}]}])"}) {
        const Found mended = mended_by(analysis("a", "y = t", difference, "K", place), 0);
        EXPECT_EQ(mended.objection, "") << place;
        EXPECT_NEAR(mended.estimate, 20.0, 1e-12) << place;
    }
    // A temperature in Fahrenheit stays on its scale, with Rankine for differences.
    const std::string gain = analysis("a", "y = 0.01 [1/degR]*t", row("t", "68", "degF", "standard", "0.9"));
    for (const std::size_t way : {0u, 1u}) EXPECT_NEAR(mended_by(gain, way).estimate, 0.68, 1e-12) << way;
    EXPECT_NEAR(mended_by(gain, 2).estimate, 0.01 * (68.0 + 459.67), 1e-12);
    for (const std::size_t way : {0u, 1u, 2u}) EXPECT_NEAR(mended_by(gain, way).u, 0.009, 1e-15) << way;
    for (const char* unit : {"K", "degR"}) {
        const double in_kelvin = 5.0 / 9.0, size = unit == std::string("K") ? 1.0 : in_kelvin;
        EXPECT_NEAR(mended_by(analysis("a", "y = t", row("t", "68", "degF", "mpe", "0.3", "0.5", unit)), 0).u,
                    (0.3 * size + 0.34 * in_kelvin) / std::sqrt(3.0), 1e-12)
            << unit;
    }
    const std::string upstream = analysis("up", "y = t - 15 [degC]", t, "K");
    const std::string link = R"("links": [{"input": "t", "analysis": "up", "output": "y"}])";
    EXPECT_NEAR(mended_by(upstream + ", " + analysis("a", "y = t", t, "", link), 0).estimate, 5.0, 1e-12);
}

// A column in the project has its head mended; a file has it in itself, and is refused.
TEST(TemperatureDoors, ColumnsOfDifferencesTakeNoTemperature) {
    ColumnSpec rise;
    rise.key = "rise";
    rise.title = "temperature rise";
    rise.unit = Unit::of("K");
    FieldSpec films;
    films.key = "films";
    films.title = "films";
    films.kind = FieldKind::table;
    films.columns = {rise};
    for (const auto& [given, mended] : {std::pair("degC", "K"), {"degF", "degR"}}) {
        covaria::Setup setup;
        setup.values["films"] = SetupTable{{Unit::of(given)}, {{20.0}}, {}, {}};
        Problems problems;
        check_setup(SetupSchema({films}), setup, problems);
        ASSERT_EQ(problems.items().size(), 1u);
        const Problem& problem = problems.items().front();
        EXPECT_NE(problem.message.english().find("'temperature rise' of 'films'"), std::string::npos);
        ASSERT_EQ(problem.remedies.size(), 1u) << problem.message.english();
        ASSERT_EQ(problem.remedies[0].values.size(), 1u);
        const Remedy::Value& value = problem.remedies[0].values[0];
        const std::string head = std::get<std::string>(value.value),
                          file = std::string("rise [") + given + "]";
        const auto text = with_values(R"({"films": {"columns": [")" + file + R"("], "rows": [[20]]}})",
                                      {{value.place, in_quotation(head)}});
        ASSERT_TRUE(text) << text.error().message.english();
        EXPECT_NE(text->find(std::string("rise [") + mended + "]"), std::string::npos) << *text;
        const auto csv = read_csv(file + "\n20\n");
        ASSERT_TRUE(csv);
        EXPECT_TRUE(table_from_csv(*csv, films).problems.has_errors());
        EXPECT_FALSE(table_from_csv(*csv, films, {{file, head}}).problems.has_errors()) << "read as K";
    }
}

}  // namespace
}  // namespace covaria::temperature_doors_test
