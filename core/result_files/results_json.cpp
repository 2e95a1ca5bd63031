// results.json: the contract of the command line for scripts (DESIGN 9). No clock, no host: equal runs, equal
// bytes.
#include "core/result_files/results_json.h"

#include "core/base/printable.h"
#include "core/base/version.h"
#include "core/made/applicability.h"
#include "core/project/project_file.h"
#include "core/project/stated_requirements.h"
#include "core/propagation/reverse_budget.h"
#include "core/result/representation.h"
#include "core/result/result_line.h"
#include "core/result_files/json_values.h"
#include "core/result_files/seen_json.h"
#include "core/result_files/study_results_json.h"
#include "core/text/cell.h"
#include "core/text/numbers.h"
#include "core/views/decisions.h"
#include "core/views/result_columns.h"

namespace covaria {
namespace {

constexpr std::size_t line_width = 110;

std::string number_text(const OrderedJson& value) {
    const double number = value.get<double>();
    return std::isfinite(number) ? format_exact(number) : "null";
}

/// JSON as text, also of a file name that is no UTF-8; control characters as their numbers.
std::string text_of(const OrderedJson& value) {
    const std::string text = value.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
    if (printable(text) == text) return text;
    return value.dump(-1, ' ', true, OrderedJson::error_handler_t::replace);
}

std::string compact(const OrderedJson& value);

template <class Items>
std::string joined(const Items& items, bool keys) {
    std::string out;
    for (const auto& [key, item] : items)
        out += (out.empty() ? "" : ", ") + (keys ? text_of(OrderedJson(key)) + ": " : "") + compact(item);
    return out;
}

std::string compact(const OrderedJson& value) {
    if (value.is_number_float()) return number_text(value);
    if (value.is_object()) return "{" + joined(value.items(), true) + "}";
    if (value.is_array()) return "[" + joined(value.items(), false) + "]";
    return text_of(value);
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
        if (value.is_object()) out += text_of(OrderedJson(key)) + ": ";
        out += pretty(item, inner);
    }
    return (value.is_object() ? "{" : "[") + out + "\n" + indent + (value.is_object() ? "}" : "]");
}

OrderedJson json_of(const Cell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell)) return *text;
    if (const auto* message = std::get_if<Message>(&cell)) return message->english();
    if (const auto* symbols = std::get_if<Symbols>(&cell)) return symbols->front();
    if (const auto* unit = std::get_if<Unit>(&cell)) return unit->text();
    if (const auto* answer = std::get_if<Answer>(&cell)) return answer->is;
    if (const auto number = number_in(cell)) return json_number(*number);
    return nullptr;
}

/// A member of an output: a column of the table of results.
struct Member {
    const char* path;
    const char* column;
    enum { null, left_out, without_parent } when_empty = null;
};

constexpr Member members[] = {
    {"/symbol", "symbol"},
    {"/group", "group"},
    {"/unit", "unit"},
    {"/role", "role"},
    {"/estimate", "estimate"},
    {"/mean", "mean"},
    {"/standardUncertainty", "u"},
    {"/expandedUncertainty", "U"},
    {"/coverageFactor", "k"},
    {"/expandedUncertaintyBy", "U by"},
    {"/interval/kind", "stated interval"},
    {"/interval/probability", "coverage probability"},
    {"/interval/low", "stated low"},
    {"/interval/high", "stated high"},
    {"/shortestInterval/low", "shortest low", Member::without_parent},
    {"/shortestInterval/high", "shortest high", Member::left_out},
    {"/skewness", "skewness"},
    {"/kurtosis", "kurtosis"},
    {"/excessKurtosis", "excess kurtosis"},
    {"/firstOrder/estimate", "estimate first order"},
    {"/firstOrder/standardUncertainty", "u first order"},
    {"/firstOrder/effectiveDegreesOfFreedom", "nu_eff"},
    {"/firstOrder/coverageFactor", "k first order"},
    {"/firstOrder/expandedUncertainty", "U first order"},
    {"/firstOrder/validated", "clause 8"},
    {"/firstOrder/secondOrder/standardUncertainty", "u second order", Member::left_out},
    {"/firstOrder/secondOrder/estimateShift", "shift second order", Member::left_out}};

OrderedJson output_json(const Table& results, std::size_t row) {
    OrderedJson json;
    for (const Member& member : members) {
        const Cell cell = results.cell(row, member.column);
        OrderedJson::json_pointer path(member.path);
        const bool empty = std::holds_alternative<std::monostate>(cell);
        if (empty && member.when_empty == Member::left_out) continue;
        json[empty && member.when_empty == Member::without_parent ? path.parent_pointer() : path] =
            json_of(cell);
    }
    return json;
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

/// Entry (i, j) in the product of the units of outputs i and j of a block.
OrderedJson block_json(const UncertaintyResult& result, const Eigen::MatrixXd& covariance,
                       Eigen::Index first) {
    const auto unit_of = [&](Eigen::Index i) -> const Unit& {
        return result.outputs[static_cast<std::size_t>(first + i)].quantity.unit;
    };
    OrderedJson rows = OrderedJson::array();
    for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
        OrderedJson row = OrderedJson::array();
        for (Eigen::Index j = 0; j < covariance.cols(); ++j)
            row.push_back(
                json_number(unit_of(j).interval_from_si(unit_of(i).interval_from_si(covariance(i, j)))));
        rows.push_back(std::move(row));
    }
    return rows;
}

/// "covariance": the matrix of all outputs; of thousands of outputs "covarianceBlocks", one for each group.
void add_covariance(const UncertaintyResult& result, OrderedJson& json) {
    const OutputCovariance covariance = existing_covariance(result);
    if (covariance.is_whole()) {
        json["covariance"] = block_json(result, covariance.whole(), 0);
        return;
    }
    OrderedJson blocks = OrderedJson::array();
    for (std::size_t k = 0; k < covariance.blocks().list().size(); ++k) {
        const Eigen::Index first = covariance.blocks().list()[k].first;
        blocks.push_back({{"group", result.outputs[static_cast<std::size_t>(first)].quantity.group},
                          {"firstOutput", first},
                          {"covariance", block_json(result, covariance.block(k), first)}});
    }
    json["covarianceBlocks"] = std::move(blocks);
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

/// Adds the reductions that meet a target; nothing where that cannot be said.
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
        if (reduction.rises_again) json["reductions"].back()["risesAgain"] = true;
    }
    if (budget->common_factor) json["commonFactor"] = json_number(*budget->common_factor);
}

/// Without a verdict: nulls where it would stand, and why.
OrderedJson not_judged_json(const RequirementResult& r, OrderedJson json) {
    if (r.target_uncertainty) json["targetMet"] = nullptr;
    if (r.lower_limit || r.upper_limit) json["decision"] = nullptr;
    json["notJudged"] = r.not_judged.english();
    return json;
}

OrderedJson requirement_json(const EvaluatedAnalysis& evaluated, const RequirementResult& r) {
    const OutputQuantity& q = evaluated.result->outputs[r.output].quantity;
    OrderedJson json = {{"symbol", q.symbol}, {"group", q.group}, {"unit", q.unit.text()}};
    if (r.target_uncertainty)
        json["targetUncertainty"] = json_number(q.unit.interval_from_si(*r.target_uncertainty));
    if (!r.not_judged.empty()) return not_judged_json(r, std::move(json));
    if (r.target_uncertainty) {
        json["targetMet"] = r.meets_target;
        if (!r.meets_target) add_reductions(evaluated, r, json);
    }
    if (!r.lower_limit && !r.upper_limit) return json;
    json["decision"] = r.decision == RequirementResult::Decision::accept ? "accept" : "reject";
    json["guardBand"] = json_number(q.unit.interval_from_si(r.guard_band));
    json["conformance"] = {{"probability", json_number(r.conformance)},
                           {"distribution", distribution_key(r.conformance_by)}};
    if (r.capability_index) json["capabilityIndex"] = json_number(*r.capability_index);
    if (r.uncertainty_ratio) json["testUncertaintyRatio"] = json_number(*r.uncertainty_ratio);
    if (r.global_risks)
        json["globalRisks"] = {{"consumer", json_number(r.global_risks->consumer)},
                               {"producer", json_number(r.global_risks->producer)},
                               {"consumerIfAccepted", json_number(r.global_risks->consumer_if_accepted)},
                               {"producerIfRejected", json_number(r.global_risks->producer_if_rejected)}};
    return json;
}

OrderedJson links_json(const PreparedAnalysis& analysis) {
    OrderedJson list = OrderedJson::array();
    for (const LinkedInput& input : analysis.linked)
        list.push_back({{"input", input.symbol},
                        {"analysis", input.analysis},
                        {"group", input.output.group},
                        {"output", input.output.symbol},
                        {"linearised", input.linearised},
                        {"unit", input.unit.text()},
                        {"estimate", json_number(input.unit.from_si(input.estimate))},
                        {"u", json_number(input.unit.interval_from_si(input.standard_uncertainty))}});
    return list;
}

/// Shares of the variance by the analyses of a chain.
OrderedJson shares_json(const UncertaintyResult& result) {
    OrderedJson list = OrderedJson::array();
    for (std::size_t j = 0; j < result.outputs.size(); ++j) {
        const OutputQuantity& q = result.outputs[j].quantity;
        OrderedJson shares = OrderedJson::object();
        for (const GroupContribution& g : contributions_by_group(result.budget, j, "analysis"))
            shares[g.group] = json_number(g.share);
        list.push_back({{"symbol", q.symbol}, {"group", q.group}, {"shares", std::move(shares)}});
    }
    return list;
}

/// The pairs of the table of them, by the ids that budget and inputs have.
OrderedJson input_correlations_json(const InputSet& inputs) {
    OrderedJson list = OrderedJson::array();
    for (const ComponentCorrelation& pair : all_correlations(inputs))
        list.push_back({{"component", inputs.components[pair.first].id},
                        {"with", inputs.components[pair.second].id},
                        {"coefficient", json_number(pair.coefficient)}});
    return list;
}

/// The certificates that a result rests on, each with its verdict, and the assets without one.
OrderedJson figures_json(const FiguresUsed& used) {
    OrderedJson json = OrderedJson::object();
    for (const CertificateUse& use : used.certificates) {
        const AssetCertificate& of = use.certificate;
        OrderedJson one = {{"holder", use.holder}, {"analysis", use.analysis}};
        if (!use.asset.empty()) one["asset"] = use.asset;
        for (const auto& [key, text] :
             {std::pair("number", of.number), std::pair("issuer", of.issuer), std::pair("digest", of.digest)})
            if (!text.empty()) one[key] = text;
        one["verdict"] = words_of(use.verdict.verdict).english();
        for (const Message& reason : use.verdict.reasons) one["reasons"].push_back(reason.english());
        json["certificates"].push_back(std::move(one));
    }
    if (!used.assumed.empty()) json["assumed"] = used.assumed;
    if (!used.assumed_quantities.empty()) json["assumedQuantities"] = used.assumed_quantities;
    return json;
}

const char* word_of(TestVerdict::Is is) {
    return is == TestVerdict::Is::met ? "met" : is == TestVerdict::Is::not_met ? "not met" : "not decided";
}

OrderedJson decisions_json(const MeasurementModel& model) {
    OrderedJson list = OrderedJson::array();
    for (const DecidedRow& row : decisions_in(model.evaluation()))
        list.push_back({{"subject", to_unicode(row.subject)},
                        {"verdict", word_of(row.verdict.is)},
                        {"words", row.verdict.words.english()},
                        {"figures", to_unicode(row.figures)}});
    return list;
}

OrderedJson analysis_json(const Project& project, const EvaluatedAnalysis& evaluated,
                          const MadeProject* made) {
    const UncertaintyResult& result = *evaluated.result;
    OrderedJson outputs = OrderedJson::array();
    const Table results = results_table(result);
    for (std::size_t row = 0; row < results.rows; ++row) {
        outputs.push_back(output_json(results, row));
        const OutputResult& output = result.outputs[row];
        if (output.monte_carlo && output.monte_carlo->reduced)
            outputs.back()["varianceReduction"] =
                variance_reduction_json(*output.monte_carlo->reduced, output.quantity.unit);
    }
    OrderedJson json = {{"id", evaluated.analysis->id},
                        {"model", evaluated.analysis->descriptor ? evaluated.analysis->descriptor->id : ""},
                        {"trials", result.trials},
                        {"failedTrials", result.failed_trials},
                        {"representsMeasurand", represents_measurand(result)},
                        {"stabilised", result.stabilised},
                        {"seed", std::to_string(result.provenance.seed)},
                        {"outputs", std::move(outputs)}};
    add_covariance(result, json);
    if (auto pairs = input_correlations_json(result.inputs); !pairs.empty())
        json["inputCorrelations"] = std::move(pairs);
    std::vector<std::string> warnings;
    for (const std::vector<Message>* said : {&evaluated.warnings, &result.warnings})
        for (const Message& warning : *said) warnings.push_back(warning.english());
    if (!warnings.empty()) json["warnings"] = warnings;
    if (result.variance_reduction != VarianceReduction::none) {
        const auto gain = least_gain(result);
        json["varianceReduction"] = {{"kind", key_of(result.variance_reduction)},
                                     {"leastGain", gain ? json_number(*gain) : OrderedJson(nullptr)}};
    }
    if (!result.contributors.empty()) json["contributors"] = contributors_json(result);
    if (!result.sobol.empty()) json["sobol"] = sobol_json(result);
    if (!evaluated.analysis->linked.empty()) {
        json["links"] = links_json(*evaluated.analysis);
        json["byAnalysis"] = shares_json(result);
    }
    for (const RequirementResult& r : judge(result, project, evaluated.analysis->id))
        json["requirements"].push_back(requirement_json(evaluated, r));
    if (evaluated.analysis->model && evaluated.analysis->descriptor &&
        evaluated.analysis->descriptor->decides)
        json["decisions"] = decisions_json(*evaluated.analysis->model);
    if (made && made->find_analysis(evaluated.analysis->id))
        if (OrderedJson figures = figures_json(figures_used(*made, evaluated.analysis->id)); !figures.empty())
            json["figures"] = std::move(figures);
    if (const auto readings =
            evaluated.analysis->model ? evaluated.analysis->model->redundant_readings() : nullptr)
        json["seen"] = seen_json(*readings, evidence::seen_of(*readings));
    for (const auto& study : evaluated.studies) json["studies"].push_back(study_json(*study));
    return json;
}

OrderedJson failed_json(const FailedAnalysis& failed) {
    OrderedJson json = {{"analysis", failed.id}, {"name", failed.name}};
    if (!failed.study.empty()) json["study"] = failed.study;
    json["cause"] = failed.cause.english();
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
    for (const EvaluatedAnalysis& evaluated : analyses)
        list.push_back(analysis_json(project, evaluated, listing.made));
    OrderedJson document = {
        {"format", "covaria-results"},
        {"schemaVersion", 1},
        {"project",
         {{"title", project.title}, {"fingerprint", fingerprint(project)}, {"covariaVersion", version()}}},
        {"analyses", std::move(list)}};
    for (const FailedAnalysis& failed : listing.failed) document["failed"].push_back(failed_json(failed));
    for (const ResultFile& file : listing.files) document["files"].push_back(file_json(file));
    return pretty(document, "") + "\n";
}

}  // namespace covaria
