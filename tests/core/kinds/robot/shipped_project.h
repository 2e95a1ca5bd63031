// A shipped project with changes, for tests: its analyses made and evaluated, and the words of its problems.
#pragma once

#include <map>
#include <stdexcept>

#include "core/base/resource_path.h"
#include "tests/core/made.h"
#include "tests/core/table_rows.h"

namespace covaria::robot_test {

struct ShippedProject {
    explicit ShippedProject(const char* file)
        : project(load_project(data_directory() / "projects" / file).project) {}
    ShippedProject(const ShippedProject&) = default;
    ShippedProject& operator=(const ShippedProject&) = default;
    virtual ~ShippedProject() = default;

    AnalysisEntry& find(const std::string& id) {
        for (AnalysisEntry& analysis : project.analyses)
            if (analysis.id == id) return analysis;
        throw std::out_of_range(id);
    }
    covaria::Setup& setup(const std::string& id) { return find(id).setup; }
    SetupTable& table(const std::string& id, const std::string& key) {
        return std::get<SetupTable>(setup(id).values.at(key));
    }
    virtual std::shared_ptr<const PreparedAnalysis> prepare(const std::string& id) {
        problems = {};
        return made_analysis(project, id, problems);
    }
    /// 0 trials: the law of propagation alone.
    UncertaintyResult run(const std::string& id, std::uint64_t trials) {
        find(id).options.method = trials == 0 ? Method::first_order : Method::monte_carlo;
        if (trials > 0) find(id).options.trials = trials;
        const auto prepared = prepare(id);
        if (!prepared) throw std::runtime_error(words());
        return run_analysis(*prepared).value();
    }
    std::string words() const {
        std::string text;
        for (const Problem& p : problems.items()) text += p.path + ": " + p.message.english() + "\n";
        return text;
    }
    bool says(const std::string& sentence) const { return words().find(sentence) != std::string::npos; }

    Project project;
    Problems problems;
};

struct Found {
    double value, u;
};

/// Measurands by symbol, in their units, law of propagation.
inline std::map<std::string, Found> parameters(const UncertaintyResult& r) {
    std::map<std::string, Found> found;
    for (const OutputResult& y : r.outputs)
        if (y.quantity.role == OutputRole::measurand)
            found[y.quantity.symbol] = {y.quantity.unit.interval_from_si(y.first_order.estimate),
                                        y.quantity.unit.interval_from_si(y.first_order.standard_uncertainty)};
    return found;
}

inline Table table_called(const PreparedAnalysis& analysis, const std::string& id) {
    for (const Table& table : analysis.model->evaluation())
        if (table.id == id) return table;
    throw std::out_of_range(id);
}

/// What an identification cannot tell, with its reason.
inline std::map<std::string, std::string> held_in(const PreparedAnalysis& analysis) {
    std::map<std::string, std::string> held;
    for (const auto& row : test::rows_of(table_called(analysis, "not-identified")))
        held[english_of(row[0])] = english_of(row[1]);
    return held;
}

/// The calibrated arm of er10l-c10.covaria, with which the readings of both projects are simulated; mm and
/// degrees.
inline const std::map<std::string, double> calibrated{
    {"a_1", 166.5975},   {"alpha_1", -90.0003}, {"theta_2", -90.062}, {"a_2", 780.26},
    {"alpha_2", -.0261}, {"beta_2", .0234},     {"theta_3", -.1825},  {"d_3", .7937},
    {"a_3", 140.3917},   {"alpha_3", -89.981},  {"theta_4", -.3125},  {"d_4", 1059.7833},
    {"a_4", .1621},      {"alpha_4", 90.0605},  {"theta_5", -.5217},  {"d_5", .7176},
    {"a_5", .1015},      {"alpha_5", -90.015}};

}  // namespace covaria::robot_test
