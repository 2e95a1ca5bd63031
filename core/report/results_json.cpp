// results.json: the contract of the command line for scripts (DESIGN 9). No clock, no host: equal runs, equal
// bytes.
#include "core/project/project_file.h"
#include "core/project/stated_requirements.h"
#include "core/propagation/reverse_budget.h"
#include "core/report/json_values.h"
#include "core/report/number_format.h"
#include "core/report/report.h"
#include "core/report/study_results_json.h"
#include "core/result/representation.h"
#include "core/result/result_line.h"

namespace covaria {
namespace {

constexpr std::size_t line_width = 110;

std::string number_text(const OrderedJson& value) {
    const double number = value.get<double>();
    return std::isfinite(number) ? format_exact(number) : "null";
}

std::string compact(const OrderedJson& value);

template <class Items>
std::string joined(const Items& items, bool keys) {
    std::string out;
    for (const auto& [key, item] : items)
        out += (out.empty() ? "" : ", ") + (keys ? OrderedJson(key).dump() + ": " : "") + compact(item);
    return out;
}

std::string compact(const OrderedJson& value) {
    if (value.is_number_float()) return number_text(value);
    if (value.is_object()) return "{" + joined(value.items(), true) + "}";
    if (value.is_array()) return "[" + joined(value.items(), false) + "]";
    return value.dump();
}

bool is_row_of_numbers(const OrderedJson& value) {
    return value.is_array() && !value.empty() && (value[0].is_number() || value[0].is_null());
}

/// Small values and rows of numbers on one line, everything else one entry a line.
std::string pretty(const OrderedJson& value, const std::string& indent) {
    const std::string line = compact(value);
    if (!value.is_structured() || value.empty() || is_row_of_numbers(value)) return line;
    if (line.size() + indent.size() <= line_width) return line;
    const std::string inner = indent + "  ";
    std::string out;
    for (const auto& [key, item] : value.items()) {
        out += (out.empty() ? "\n" : ",\n") + inner;
        if (value.is_object()) out += OrderedJson(key).dump() + ": ";
        out += pretty(item, inner);
    }
    return (value.is_object() ? "{" : "[") + out + "\n" + indent + (value.is_object() ? "}" : "]");
}

OrderedJson interval_json(const OutputResult& output, const UncertaintyResult& result) {
    const Unit& unit = output.quantity.unit;
    const CoverageInterval interval = coverage_interval_of(output, result);
    return {{"kind", output.monte_carlo ? "symmetric" : "first-order"},
            {"probability", result.coverage_probability},
            {"low", json_number(unit.from_si(interval.low))},
            {"high", json_number(unit.from_si(interval.high))}};
}

OrderedJson first_order_json(const OutputResult& output) {
    const FirstOrderOutput& first = output.first_order;
    const Unit& unit = output.quantity.unit;
    OrderedJson json = {
        {"estimate", json_number(unit.from_si(first.estimate))},
        {"standardUncertainty", json_number(unit.interval_from_si(first.standard_uncertainty))},
        {"effectiveDegreesOfFreedom", json_number(first.effective_degrees_of_freedom)},
        {"coverageFactor", json_number(first.coverage_factor)},
        {"expandedUncertainty", json_number(unit.interval_from_si(first.expanded_uncertainty))},
        {"validated", first.validation ? OrderedJson(first.validation->validated) : OrderedJson(nullptr)}};
    if (first.second_order_standard_uncertainty)
        json["secondOrder"] = {
            {"standardUncertainty",
             json_number(unit.interval_from_si(*first.second_order_standard_uncertainty))},
            {"estimateShift", json_number(unit.interval_from_si(*first.second_order_estimate_shift))}};
    return json;
}

OrderedJson shortest_json(const OutputResult& output) {
    if (!output.monte_carlo) return nullptr;
    const Unit& unit = output.quantity.unit;
    return {{"low", json_number(unit.from_si(output.monte_carlo->shortest.low))},
            {"high", json_number(unit.from_si(output.monte_carlo->shortest.high))}};
}

/// Standard errors and gains of the figures; nulls with too few batches.
OrderedJson variance_reduction_json(const ReducedVariance& reduced, const Unit& unit) {
    const OutputFigures &e = reduced.standard_errors, &g = reduced.gains;
    OrderedJson json = {{"standardErrors",
                         {{"mean", json_number(unit.interval_from_si(e.mean))},
                          {"standardUncertainty", json_number(unit.interval_from_si(e.standard_uncertainty))},
                          {"low", json_number(unit.interval_from_si(e.low))},
                          {"high", json_number(unit.interval_from_si(e.high))}}},
                        {"gains",
                         {{"mean", json_number(g.mean)},
                          {"standardUncertainty", json_number(g.standard_uncertainty)},
                          {"low", json_number(g.low)},
                          {"high", json_number(g.high)}}}};
    if (!reduced.plain_because.empty()) json["plainBecause"] = reduced.plain_because;
    return json;
}

OrderedJson output_json(const OutputResult& output, const UncertaintyResult& result) {
    const OutputQuantity& quantity = output.quantity;
    const Unit& unit = quantity.unit;
    const auto& trials = output.monte_carlo;
    OrderedJson json = {
        {"symbol", quantity.symbol},
        {"group", quantity.group},
        {"unit", unit.text()},
        {"role", quantity.role == OutputRole::measurand ? "measurand" : "intermediate"},
        {"estimate", json_number(unit.from_si(output.estimate))},
        {"mean", trials ? json_number(unit.from_si(trials->mean)) : OrderedJson(nullptr)},
        {"standardUncertainty", json_number(unit.interval_from_si(output.standard_uncertainty))},
        {"expandedUncertainty", json_number(unit.interval_from_si(output.expanded_uncertainty))},
        {"coverageFactor", json_number(output.coverage_factor)},
        {"expandedUncertaintyBy", expanded_key(result)},
        {"interval", interval_json(output, result)},
        {"shortestInterval", shortest_json(output)},
        {"skewness", trials ? json_number(trials->skewness) : OrderedJson(nullptr)},
        {"kurtosis", trials ? json_number(3.0 + trials->kurtosis) : OrderedJson(nullptr)},
        {"excessKurtosis", trials ? json_number(trials->kurtosis) : OrderedJson(nullptr)},
        {"firstOrder", first_order_json(output)}};
    if (trials && trials->reduced)
        json["varianceReduction"] = variance_reduction_json(*trials->reduced, unit);
    return json;
}

/// Entry (i, j) in the product of the units of outputs i and j.
OrderedJson covariance_json(const UncertaintyResult& result) {
    OrderedJson rows = OrderedJson::array();
    for (Eigen::Index i = 0; i < result.covariance.rows(); ++i) {
        OrderedJson row = OrderedJson::array();
        const Unit& unit_i = result.outputs[static_cast<std::size_t>(i)].quantity.unit;
        for (Eigen::Index j = 0; j < result.covariance.cols(); ++j) {
            const Unit& unit_j = result.outputs[static_cast<std::size_t>(j)].quantity.unit;
            row.push_back(
                json_number(unit_j.interval_from_si(unit_i.interval_from_si(result.covariance(i, j)))));
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Standard uncertainties in the units of the outputs.
OrderedJson uncertainties_json(const UncertaintyResult& result,
                               const ContributorResult::Uncertainties& part) {
    const auto list = [&](const std::vector<double>& u) -> OrderedJson {
        if (u.empty()) return nullptr;
        OrderedJson values = OrderedJson::array();
        for (std::size_t j = 0; j < u.size(); ++j)
            values.push_back(json_number(result.outputs[j].quantity.unit.interval_from_si(u[j])));
        return values;
    };
    return {{"firstOrder", list(part.first_order)},
            {"monteCarlo", list(part.monte_carlo)},
            {"failedTrials", part.failed_trials}};
}

/// Per contributor, in the order of the outputs: u with everything of it held, and of it alone.
OrderedJson contributors_json(const UncertaintyResult& result) {
    OrderedJson list = OrderedJson::array();
    for (const ContributorResult& c : result.contributors)
        list.push_back({{"contributor", c.contributor},
                        {"trials", result.contributor_trials},
                        {"held", uncertainties_json(result, c.without)},
                        {"alone", uncertainties_json(result, c.alone)}});
    return list;
}

/// Per output: indices by falling total.
OrderedJson sobol_json(const UncertaintyResult& result) {
    OrderedJson list = OrderedJson::array();
    for (std::size_t j = 0; j < result.sobol.size(); ++j) {
        OrderedJson indices = OrderedJson::array();
        for (const SobolIndex& s : result.sobol[j])
            indices.push_back({{"component", s.name},
                               {"first", json_number(s.first)},
                               {"firstStandardError", json_number(s.first_standard_error)},
                               {"total", json_number(s.total)},
                               {"totalStandardError", json_number(s.total_standard_error)}});
        list.push_back({{"symbol", result.outputs[j].quantity.symbol},
                        {"group", result.outputs[j].quantity.group},
                        {"trials", result.sobol_trials},
                        {"indices", std::move(indices)}});
    }
    return list;
}

/// What it takes to meet a target; nothing where that cannot be said.
void add_reductions(const EvaluatedAnalysis& evaluated, const RequirementResult& r, OrderedJson& json) {
    const UncertaintyResult& result = *evaluated.result;
    const auto budget =
        reverse_budget(evaluated.analysis->model.get(), result, r.output, *r.target_uncertainty);
    if (!budget) return;
    for (const ReverseBudget::Reduction& reduction : budget->reductions) {
        const BudgetComponent& c = result.budget.components[reduction.component];
        json["reductions"].push_back(
            {{"component", c.id},
             {"unit", c.unit.text()},
             {"now", json_number(c.unit.interval_from_si(reduction.now))},
             {"needed", reduction.needed ? json_number(c.unit.interval_from_si(*reduction.needed))
                                         : OrderedJson(nullptr)}});
    }
    if (budget->common_factor) json["commonFactor"] = json_number(*budget->common_factor);
}

OrderedJson requirement_json(const EvaluatedAnalysis& evaluated, const RequirementResult& r) {
    const OutputQuantity& q = evaluated.result->outputs[r.output].quantity;
    OrderedJson json = {{"symbol", q.symbol}, {"group", q.group}, {"unit", q.unit.text()}};
    if (r.target_uncertainty) {
        json["targetUncertainty"] = json_number(q.unit.interval_from_si(*r.target_uncertainty));
        json["targetMet"] = r.meets_target;
        if (!r.meets_target) add_reductions(evaluated, r, json);
    }
    if (!r.lower_limit && !r.upper_limit) return json;
    json["decision"] = r.decision == RequirementResult::Decision::accept ? "accept" : "reject";
    json["guardBand"] = json_number(q.unit.interval_from_si(r.guard_band));
    json["conformance"] = {{"probability", json_number(r.conformance)},
                           {"distribution", distribution_key(r.conformance_by)}};
    if (r.global_risks)
        json["globalRisks"] = {{"consumer", json_number(r.global_risks->consumer)},
                               {"producer", json_number(r.global_risks->producer)}};
    return json;
}

OrderedJson analysis_json(const Project& project, const EvaluatedAnalysis& evaluated) {
    const UncertaintyResult& result = *evaluated.result;
    OrderedJson outputs = OrderedJson::array();
    for (const OutputResult& output : result.outputs) outputs.push_back(output_json(output, result));
    OrderedJson json = {{"id", evaluated.analysis->id},
                        {"model", evaluated.analysis->descriptor ? evaluated.analysis->descriptor->id : ""},
                        {"trials", result.trials},
                        {"failedTrials", result.failed_trials},
                        {"representsMeasurand", represents_measurand(result)},
                        {"stabilised", result.stabilised},
                        {"seed", std::to_string(result.provenance.seed)},
                        {"outputs", std::move(outputs)},
                        {"covariance", covariance_json(result)}};
    std::vector<std::string> warnings = evaluated.warnings;
    warnings.insert(warnings.end(), result.warnings.begin(), result.warnings.end());
    if (!warnings.empty()) json["warnings"] = warnings;
    if (result.variance_reduction != VarianceReduction::none) {
        const auto gain = least_gain(result);
        json["varianceReduction"] = {{"kind", key_of(result.variance_reduction)},
                                     {"leastGain", gain ? json_number(*gain) : OrderedJson(nullptr)}};
    }
    if (!result.contributors.empty()) json["contributors"] = contributors_json(result);
    if (!result.sobol.empty()) json["sobol"] = sobol_json(result);
    if (const AnalysisEntry* entry = project.find_analysis(evaluated.analysis->id))
        for (const RequirementResult& r : judge(result, *entry))
            json["requirements"].push_back(requirement_json(evaluated, r));
    for (const auto& study : evaluated.studies) json["studies"].push_back(study_json(*study));
    return json;
}

OrderedJson failed_json(const FailedAnalysis& failed) {
    OrderedJson json = {{"analysis", failed.id}, {"name", failed.name}};
    if (!failed.study.empty()) json["study"] = failed.study;
    json["cause"] = failed.cause;
    return json;
}

OrderedJson file_json(const ResultFile& file) {
    OrderedJson json = {{"file", file.name}};
    for (const auto& [key, value] : file.of) json[key] = value;
    return json;
}

}  // namespace

std::string results_json(const Project& project, const std::vector<EvaluatedAnalysis>& analyses,
                         const ResultListing& listing) {
    OrderedJson list = OrderedJson::array();
    for (const EvaluatedAnalysis& evaluated : analyses) list.push_back(analysis_json(project, evaluated));
    OrderedJson document = {{"format", "covaria-results"},
                            {"schemaVersion", 1},
                            {"project",
                             {{"title", project.title},
                              {"fingerprint", fingerprint(project)},
                              {"covariaVersion", COVARIA_VERSION}}},
                            {"analyses", std::move(list)}};
    for (const FailedAnalysis& failed : listing.failed) document["failed"].push_back(failed_json(failed));
    for (const ResultFile& file : listing.files) document["files"].push_back(file_json(file));
    return pretty(document, "") + "\n";
}

}  // namespace covaria
