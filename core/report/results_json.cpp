// results.json: the contract of the command line for scripts (DESIGN 9). No clock, no host: equal runs, equal
// bytes.
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/project/project_file.h"
#include "core/report/number_format.h"
#include "core/report/report.h"
#include "core/report/study_json.h"

namespace covaria {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t line_width = 110;

std::string number_text(const Json& value) {
    const double number = value.get<double>();
    return std::isfinite(number) ? format_exact(number) : "null";
}

std::string compact(const Json& value);

template <class Items>
std::string joined(const Items& items, bool keys) {
    std::string out;
    for (const auto& [key, item] : items)
        out += (out.empty() ? "" : ", ") + (keys ? Json(key).dump() + ": " : "") + compact(item);
    return out;
}

std::string compact(const Json& value) {
    if (value.is_number_float()) return number_text(value);
    if (value.is_object()) return "{" + joined(value.items(), true) + "}";
    if (value.is_array()) return "[" + joined(value.items(), false) + "]";
    return value.dump();
}

bool is_row_of_numbers(const Json& value) {
    return value.is_array() && !value.empty() && (value[0].is_number() || value[0].is_null());
}

/// Small values and rows of numbers on one line, everything else one entry a line.
std::string pretty(const Json& value, const std::string& indent) {
    const std::string line = compact(value);
    if (!value.is_structured() || value.empty() || is_row_of_numbers(value)) return line;
    if (line.size() + indent.size() <= line_width) return line;
    const std::string inner = indent + "  ";
    std::string out;
    for (const auto& [key, item] : value.items()) {
        out += (out.empty() ? "\n" : ",\n") + inner;
        if (value.is_object()) out += Json(key).dump() + ": ";
        out += pretty(item, inner);
    }
    return (value.is_object() ? "{" : "[") + out + "\n" + indent + (value.is_object() ? "}" : "]");
}

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json interval_json(const OutputResult& output, double probability) {
    const Unit& unit = output.quantity.unit;
    double low = output.estimate - output.expanded_uncertainty;
    double high = output.estimate + output.expanded_uncertainty;
    if (output.monte_carlo) {
        low = output.monte_carlo->symmetric.low;
        high = output.monte_carlo->symmetric.high;
    }
    return {{"kind", output.monte_carlo ? "symmetric" : "first-order"},
            {"probability", probability},
            {"low", number(unit.from_si(low))},
            {"high", number(unit.from_si(high))}};
}

Json first_order_json(const OutputResult& output) {
    const FirstOrderOutput& first = output.first_order;
    const Unit& unit = output.quantity.unit;
    return {{"standardUncertainty", number(unit.interval_from_si(first.standard_uncertainty))},
            {"effectiveDegreesOfFreedom", number(first.effective_degrees_of_freedom)},
            {"coverageFactor", number(first.coverage_factor)},
            {"validated", first.validation ? Json(first.validation->validated) : Json(nullptr)}};
}

Json shortest_json(const OutputResult& output) {
    if (!output.monte_carlo) return nullptr;
    const Unit& unit = output.quantity.unit;
    return {{"low", number(unit.from_si(output.monte_carlo->shortest.low))},
            {"high", number(unit.from_si(output.monte_carlo->shortest.high))}};
}

Json output_json(const OutputResult& output, double probability) {
    const OutputQuantity& quantity = output.quantity;
    const Unit& unit = quantity.unit;
    const auto& trials = output.monte_carlo;
    return {{"symbol", quantity.symbol},
            {"group", quantity.group},
            {"unit", unit.text()},
            {"role", quantity.role == OutputRole::measurand ? "measurand" : "intermediate"},
            {"estimate", number(unit.from_si(output.estimate))},
            {"mean", trials ? number(unit.from_si(trials->mean)) : Json(nullptr)},
            {"standardUncertainty", number(unit.interval_from_si(output.standard_uncertainty))},
            {"expandedUncertainty", number(unit.interval_from_si(output.expanded_uncertainty))},
            {"coverageFactor", number(output.coverage_factor)},
            {"interval", interval_json(output, probability)},
            {"shortestInterval", shortest_json(output)},
            {"skewness", trials ? number(trials->skewness) : Json(nullptr)},
            {"kurtosis", trials ? number(trials->kurtosis) : Json(nullptr)},
            {"firstOrder", first_order_json(output)}};
}

/// Entry (i, j) in the product of the units of outputs i and j.
Json covariance_json(const UncertaintyResult& result) {
    Json rows = Json::array();
    for (Eigen::Index i = 0; i < result.covariance.rows(); ++i) {
        Json row = Json::array();
        const Unit& unit_i = result.outputs[static_cast<std::size_t>(i)].quantity.unit;
        for (Eigen::Index j = 0; j < result.covariance.cols(); ++j) {
            const Unit& unit_j = result.outputs[static_cast<std::size_t>(j)].quantity.unit;
            row.push_back(number(unit_j.interval_from_si(unit_i.interval_from_si(result.covariance(i, j)))));
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Standard uncertainties in the units of the outputs.
Json uncertainties_json(const UncertaintyResult& result, const ContributorResult::Uncertainties& part) {
    const auto list = [&](const std::vector<double>& u) -> Json {
        if (u.empty()) return nullptr;
        Json values = Json::array();
        for (std::size_t j = 0; j < u.size(); ++j)
            values.push_back(number(result.outputs[j].quantity.unit.interval_from_si(u[j])));
        return values;
    };
    return {{"firstOrder", list(part.first_order)},
            {"monteCarlo", list(part.monte_carlo)},
            {"failedTrials", part.failed_trials}};
}

/// Per contributor, in the order of the outputs: u with everything of it held, and of it alone.
Json contributors_json(const UncertaintyResult& result) {
    Json list = Json::array();
    for (const ContributorResult& c : result.contributors)
        list.push_back({{"contributor", c.contributor},
                        {"trials", result.contributor_trials},
                        {"held", uncertainties_json(result, c.without)},
                        {"alone", uncertainties_json(result, c.alone)}});
    return list;
}

/// Per output: indices by falling total.
Json sobol_json(const UncertaintyResult& result) {
    Json list = Json::array();
    for (std::size_t j = 0; j < result.sobol.size(); ++j) {
        Json indices = Json::array();
        for (const SobolIndex& s : result.sobol[j])
            indices.push_back({{"component", s.name},
                               {"first", number(s.first)},
                               {"firstStandardError", number(s.first_standard_error)},
                               {"total", number(s.total)},
                               {"totalStandardError", number(s.total_standard_error)}});
        list.push_back({{"symbol", result.outputs[j].quantity.symbol},
                        {"group", result.outputs[j].quantity.group},
                        {"trials", result.sobol_trials},
                        {"indices", std::move(indices)}});
    }
    return list;
}

Json requirement_json(const UncertaintyResult& result, const RequirementResult& r) {
    const OutputQuantity& q = result.outputs[r.output].quantity;
    Json json = {{"symbol", q.symbol}, {"group", q.group}, {"unit", q.unit.text()}};
    if (r.target_uncertainty) {
        json["targetUncertainty"] = number(q.unit.interval_from_si(*r.target_uncertainty));
        json["targetMet"] = r.meets_target;
        for (const RequirementResult::Reduction& reduction : r.reductions) {
            const BudgetComponent& c = result.budget.components[reduction.component];
            json["reductions"].push_back(
                {{"component", c.id},
                 {"unit", c.unit.text()},
                 {"now", number(c.unit.interval_from_si(reduction.now))},
                 {"needed",
                  reduction.needed ? number(c.unit.interval_from_si(*reduction.needed)) : Json(nullptr)}});
        }
    }
    if (!r.lower_limit && !r.upper_limit) return json;
    json["decision"] = r.decision == RequirementResult::Decision::accept ? "accept" : "reject";
    json["guardBand"] = number(q.unit.interval_from_si(r.guard_band));
    json["conformance"] = {
        {"normal", number(r.conformance_normal)},
        {"monteCarlo", r.conformance_monte_carlo ? number(*r.conformance_monte_carlo) : Json(nullptr)}};
    if (r.global_risks)
        json["globalRisks"] = {{"consumer", number(r.global_risks->consumer)},
                               {"producer", number(r.global_risks->producer)}};
    return json;
}

Json analysis_json(const EvaluatedAnalysis& evaluated) {
    const UncertaintyResult& result = *evaluated.result;
    Json outputs = Json::array();
    for (const OutputResult& output : result.outputs)
        outputs.push_back(output_json(output, result.coverage_probability));
    Json json = {{"id", evaluated.analysis->id},
                 {"model", evaluated.analysis->descriptor ? evaluated.analysis->descriptor->id : ""},
                 {"trials", result.trials},
                 {"failedTrials", result.failed_trials},
                 {"stabilised", result.stabilised},
                 {"seed", std::to_string(result.provenance.seed)},
                 {"outputs", std::move(outputs)},
                 {"covariance", covariance_json(result)}};
    if (!result.contributors.empty()) json["contributors"] = contributors_json(result);
    if (!result.sobol.empty()) json["sobol"] = sobol_json(result);
    for (const RequirementResult& r : result.requirements)
        json["requirements"].push_back(requirement_json(result, r));
    for (const auto& study : evaluated.studies) json["studies"].push_back(study_json(*study));
    return json;
}

}  // namespace

std::string results_json(const Project& project, const std::vector<EvaluatedAnalysis>& analyses) {
    Json list = Json::array();
    for (const EvaluatedAnalysis& evaluated : analyses) list.push_back(analysis_json(evaluated));
    const Json document = {{"format", "covaria-results"},
                           {"schemaVersion", 1},
                           {"project",
                            {{"title", project.title},
                             {"fingerprint", fingerprint(project)},
                             {"covariaVersion", COVARIA_VERSION}}},
                           {"analyses", std::move(list)}};
    return pretty(document, "") + "\n";
}

}  // namespace covaria
