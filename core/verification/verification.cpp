// Figures of results, and whether they are what they should be.
#include "core/verification/verification.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/propagation/requirements.h"
#include "core/views/result_columns.h"

namespace covaria {
namespace {

constexpr double reference_trials = 1e6;

/// The result, output and indices that a figure is taken from.
struct Subject {
    const UncertaintyResult& result;
    const OutputResult& output;
    std::size_t index;
    std::size_t other;
    RequirementResult verdict = {};  ///< by the requirement of the check
};

enum class Conversion { value, interval, number };

struct Figure {
    Conversion conversion = Conversion::number;
    bool by_monte_carlo = false;
    std::function<double(const Subject&)> take;
};

double correlation(const OutputCovariance& covariance, const Subject& s) {
    return correlation_of(covariance.among({s.index, s.other}))(0, 1);
}

const CoverageRegion& region_of(const Subject& s) {
    static const CoverageRegion none;
    for (const CoverageRegion& region : s.result.regions)
        if (std::find(region.outputs.begin(), region.outputs.end(), s.index) != region.outputs.end())
            return region;
    return none;
}

/// A column of the table of results; NaN where it has nothing.
std::function<double(const Subject&)> column(const char* key) {
    return [key](const Subject& s) {
        const Cell cell = results_table(s.result, {s.index}).cell(0, key);
        if (const auto* answer = std::get_if<Answer>(&cell)) return answer->is ? 1.0 : 0.0;
        const auto* number = std::get_if<Measured>(&cell);
        return number ? number->si : std::nan("");
    };
}

/// An end of y -+ U by the law of propagation.
std::function<double(const Subject&)> first_order_end(double sign) {
    return [sign](const Subject& s) {
        return s.output.first_order.estimate + sign * s.output.first_order.expanded_uncertainty;
    };
}

std::map<std::string, Figure> all_figures() {
    constexpr auto value = Conversion::value, interval = Conversion::interval, number = Conversion::number;
    const auto region = [](auto factor) {
        return [factor](const Subject& s) { return factor(region_of(s)); };
    };
    const auto verdict = [](auto figure) { return [figure](const Subject& s) { return figure(s.verdict); }; };
    const auto normality = [](auto figure) {
        return [figure](const Subject& s) {
            const auto& m = s.output.monte_carlo;
            return m ? figure(m->normality, *m, static_cast<double>(s.result.trials)) : std::nan("");
        };
    };
    using N = const NormalityVerdict&;
    using M = const MonteCarloOutput&;
    using R = const CoverageRegion&;
    using V = const RequirementResult&;
    return {
        {"estimate", {value, false, column("estimate first order")}},
        {"u", {interval, false, column("u first order")}},
        {"u-second-order", {interval, false, column("u second order")}},
        {"degrees-of-freedom", {number, false, column("nu_eff")}},
        {"k", {number, false, column("k first order")}},
        {"U", {interval, false, column("U first order")}},
        {"low", {value, false, first_order_end(-1.0)}},
        {"high", {value, false, first_order_end(1.0)}},
        {"correlation",
         {number, false, [](const Subject& s) { return correlation(first_order_covariance(s.result), s); }}},
        {"ellipsoid", {number, false, region([](R r) { return r.ellipsoid_first_order; })}},
        {"rectangle", {number, false, region([](R r) { return r.rectangle_first_order; })}},
        {"validated", {number, false, column("clause 8")}},
        {"mc-mean", {value, true, column("mean")}},
        {"mc-u", {interval, true, column("u Monte Carlo")}},
        {"mc-low", {value, true, column("interval low")}},
        {"mc-high", {value, true, column("interval high")}},
        {"mc-skewness", {number, true, column("skewness")}},
        {"mc-kurtosis", {number, true, column("excess kurtosis")}},
        {"mc-coverage-ratio", {number, true, column("coverage ratio")}},
        {"mc-normal", {number, true, normality([](N n, M, double) { return n.acceptable ? 1.0 : 0.0; })}},
        // Standard errors of the two under normality, times the root of the number of trials.
        {"mc-skewness-error", {number, true, normality([](N n, M m, double t) {
                                   return m.skewness / n.skewness_z * std::sqrt(t);
                               })}},
        {"mc-kurtosis-error", {number, true, normality([](N n, M m, double t) {
                                   return m.kurtosis / n.kurtosis_z * std::sqrt(t);
                               })}},
        {"mc-short-low", {value, true, column("shortest low")}},
        {"mc-short-high", {value, true, column("shortest high")}},
        {"mc-correlation",
         {number, true, [](const Subject& s) { return correlation(s.result.covariance, s); }}},
        {"mc-ellipsoid",
         {number, true, region([](R r) { return r.ellipsoid_monte_carlo.value_or(std::nan("")); })}},
        {"mc-rectangle",
         {number, true, region([](R r) { return r.rectangle_monte_carlo.value_or(std::nan("")); })}},
        {"conformance", {number, false, verdict([](V v) { return v.conformance; })}},
        {"guard-band", {interval, false, verdict([](V v) { return v.guard_band; })}},
        {"accepted", {number, false, verdict([](V v) {
                          return v.decision == RequirementResult::Decision::accept ? 1.0 : 0.0;
                      })}},
        {"capability-index",
         {number, false, verdict([](V v) { return v.capability_index.value_or(std::nan("")); })}},
        {"consumer-risk", {number, false, verdict([](V v) {
                               return v.global_risks ? v.global_risks->consumer : std::nan("");
                           })}},
        {"producer-risk", {number, false, verdict([](V v) {
                               return v.global_risks ? v.global_risks->producer : std::nan("");
                           })}},
        // The figures of the result line, of whichever method.
        {"result-estimate", {value, true, column("estimate")}},
        {"result-u", {interval, true, column("u")}},
        {"result-k", {number, true, column("k")}},
        {"result-U", {interval, true, column("U")}},
    };
}

const std::map<std::string, Figure>& figures() {
    static const std::map<std::string, Figure> all = all_figures();
    return all;
}

double converted(const Unit& unit, Conversion conversion, double si) {
    if (conversion == Conversion::number) return si;
    return conversion == Conversion::value ? unit.from_si(si) : unit.interval_from_si(si);
}

const EvaluatedAnalysis* find(const std::vector<EvaluatedAnalysis>& results, const std::string& id) {
    for (const EvaluatedAnalysis& evaluated : results)
        if (evaluated.analysis->id == id) return &evaluated;
    return nullptr;
}

std::size_t find_output(const UncertaintyResult& result, const std::string& symbol,
                        const std::string& group) {
    std::size_t j = 0;
    while (j < result.outputs.size() && !(result.outputs[j].quantity.symbol == symbol &&
                                          (group.empty() || result.outputs[j].quantity.group == group)))
        ++j;
    return j;
}

double tolerance_of(const VerificationCheck& check, const Figure& figure, double trials) {
    if (check.reference && !std::isfinite(*check.reference)) return 0.0;
    if (check.condition > 0.0)
        return 10.0 * check.condition * std::numeric_limits<double>::epsilon() *
               (check.scale > 0.0 ? check.scale : std::abs(check.reference.value_or(0.0)));
    const double stated = std::max(check.absolute, check.relative * std::abs(check.reference.value_or(0.0)));
    if (!figure.by_monte_carlo) return stated;
    return std::max(stated,
                    4.0 * std::hypot(check.standard_error,
                                     check.scatter * std::sqrt(reference_trials / std::max(trials, 1.0))));
}

double scatter_of(const VerificationCheck& check, const Figure& figure, double trials) {
    return figure.by_monte_carlo ? 4.0 * check.scatter * std::sqrt(reference_trials / std::max(trials, 1.0))
                                 : 0.0;
}

CheckedFigure judged(const VerificationCheck& check, double value, double tolerance, double scatter) {
    CheckedFigure made{check, value, tolerance};
    const auto agree = [value](double other, double within) {
        return value == other || std::abs(value - other) <= within;
    };
    made.agrees_with_reference = !check.reference || agree(*check.reference, tolerance);
    made.reproduces_published =
        !check.published || agree(*check.published, check.half_digit * (1 + 1e-9) + scatter);
    made.differs_from_naive = !check.naive || !agree(check.naive->value, tolerance + check.half_digit);
    if (std::isnan(value)) made.agrees_with_reference = made.reproduces_published = false;
    return made;
}

/// Number as the table shows it, in the unit of its column or of its own.
std::optional<double> number_in(const Table& table, const VerificationCell& cell) {
    const Column* column = table.find(cell.column);
    for (std::size_t row = 0; column && row < table.rows; ++row)
        if (english_of(table.columns.front().cell(row)) == cell.row)
            if (const auto number = number_in(column->cell(row))) return number;
    return std::nullopt;
}

std::optional<double> number_in(const EvaluatedAnalysis& evaluated, const VerificationCell& cell) {
    for (const Table& table : evaluated.analysis->model->evaluation())
        if (table.id == cell.table) return number_in(table, cell);
    return std::nullopt;
}

RequirementResult verdict_of(const VerificationCheck& check, const UncertaintyResult& result,
                             std::size_t index) {
    if (!check.requirement) return {};
    OutputRequirement requirement = *check.requirement;
    requirement.output = index;
    for (auto* limit : {&requirement.lower_limit, &requirement.upper_limit, &requirement.prior_mean})
        if (*limit) **limit = check.unit.to_si(**limit);
    if (auto& deviation = requirement.prior_standard_deviation)
        deviation = check.unit.interval_to_si(*deviation);
    return judge(result, requirement);
}

Result<CheckedFigure> checked(const VerificationCheck& check, const std::vector<EvaluatedAnalysis>& results) {
    const auto refused = [&](const std::string& what) {
        return fail(ErrorCode::not_found, "verification \"" + check.what + "\": " + what);
    };
    const EvaluatedAnalysis* evaluated = find(results, check.analysis);
    if (!evaluated) return refused("there is no analysis \"" + check.analysis + "\"");
    if (check.cell) {
        const auto value = number_in(*evaluated, *check.cell);
        if (!value) return refused("there is no number in table \"" + check.cell->table + "\"");
        return judged(check, *value, tolerance_of(check, {}, 0.0), 0.0);
    }
    const auto figure = figures().find(check.figure);
    if (figure == figures().end()) return refused("there is no figure \"" + check.figure + "\"");
    const UncertaintyResult& result = *evaluated->result;
    const std::size_t index = find_output(result, check.output, check.group);
    const std::size_t other = check.with.empty() ? index : find_output(result, check.with, check.group);
    if (index >= result.outputs.size() || other >= result.outputs.size())
        return refused("there is no result \"" + check.output + " " + check.with + "\"");
    const Subject subject{result, result.outputs[index], index, other, verdict_of(check, result, index)};
    const bool of_region = check.figure == "mc-ellipsoid" || check.figure == "mc-rectangle";
    const auto trials = static_cast<double>(of_region ? region_of(subject).trials : result.trials);
    return judged(check, converted(check.unit, figure->second.conversion, figure->second.take(subject)),
                  tolerance_of(check, figure->second, trials), scatter_of(check, figure->second, trials));
}

}  // namespace

const std::vector<std::string>& first_order_line() {
    static const std::vector<std::string> names{"estimate", "u",   "degrees-of-freedom", "k", "U",
                                                "low",      "high"};
    return names;
}

const std::vector<std::string>& monte_carlo_line() {
    static const std::vector<std::string> names{"mc-mean", "mc-u",     "mc-low",
                                                "mc-high", "result-k", "result-U"};
    return names;
}

bool CheckedCase::passed() const {
    return not_evaluated.empty() &&
           std::all_of(figures.begin(), figures.end(), [](const CheckedFigure& f) { return f.passed(); });
}

bool needs_trials(const VerificationCheck& check) {
    return check.figure.starts_with("mc-") || check.figure.starts_with("result-") ||
           check.figure == "validated";
}

Result<CheckedCase> check_case(const VerificationCase& verification,
                               const std::vector<EvaluatedAnalysis>& results) {
    CheckedCase made{verification, {}};
    for (const VerificationCheck& check : verification.checks) {
        auto one = checked(check, results);
        if (!one) return fail(one.error());
        one->model = find(results, check.analysis)->analysis->descriptor->id;
        made.figures.push_back(std::move(*one));
    }
    return made;
}

std::string pass_rule(const CheckedFigure& figure) {
    const VerificationCheck& check = figure.check;
    if (check.condition > 0.0 && figure.tolerance > 0.0) return "10κε";
    if (check.scatter > 0.0 || check.standard_error > 0.0) return "4 standard errors";
    if (check.reference && figure.tolerance > 0.0) return "digits of the reference";
    return check.published ? "printed digits" : "equal";
}

}  // namespace covaria
