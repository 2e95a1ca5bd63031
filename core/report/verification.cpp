// Figures of results, and whether they are what they should be.
#include "core/report/verification.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace covaria {
namespace {

constexpr double reference_trials = 1e6;

/// What a figure is taken from.
struct Subject {
    const UncertaintyResult& result;
    const OutputResult& output;
    std::size_t index;
    std::size_t other;
};

enum class Conversion { value, interval, number };

struct Figure {
    Conversion conversion;
    bool by_monte_carlo;
    std::function<double(const Subject&)> take;
};

double correlation(const Eigen::MatrixXd& covariance, const Subject& s) {
    return correlation_of(covariance)(static_cast<Eigen::Index>(s.index), static_cast<Eigen::Index>(s.other));
}

const CoverageRegion& region_of(const Subject& s) {
    static const CoverageRegion none;
    for (const CoverageRegion& region : s.result.regions)
        if (std::find(region.outputs.begin(), region.outputs.end(), s.index) != region.outputs.end())
            return region;
    return none;
}

double first_order_expanded(const Subject& s) {
    return s.output.first_order.coverage_factor * s.output.first_order.standard_uncertainty;
}

std::map<std::string, Figure> first_order_figures() {
    constexpr auto value = Conversion::value, interval = Conversion::interval, number = Conversion::number;
    return {
        {"estimate", {value, false, [](const Subject& s) { return s.output.first_order.estimate; }}},
        {"u", {interval, false, [](const Subject& s) { return s.output.first_order.standard_uncertainty; }}},
        {"u-second-order",
         {interval, false,
          [](const Subject& s) {
              return s.output.first_order.second_order_standard_uncertainty.value_or(std::nan(""));
          }}},
        {"degrees-of-freedom",
         {number, false, [](const Subject& s) { return s.output.first_order.effective_degrees_of_freedom; }}},
        {"k", {number, false, [](const Subject& s) { return s.output.first_order.coverage_factor; }}},
        {"U", {interval, false, first_order_expanded}},
        {"low",
         {value, false,
          [](const Subject& s) { return s.output.first_order.estimate - first_order_expanded(s); }}},
        {"high",
         {value, false,
          [](const Subject& s) { return s.output.first_order.estimate + first_order_expanded(s); }}},
        {"correlation",
         {number, false, [](const Subject& s) { return correlation(s.result.covariance_first_order, s); }}},
        {"ellipsoid", {number, false, [](const Subject& s) { return region_of(s).ellipsoid_first_order; }}},
        {"rectangle", {number, false, [](const Subject& s) { return region_of(s).rectangle_first_order; }}},
        {"validated",
         {number, false,
          [](const Subject& s) {
              return s.output.first_order.validation ? s.output.first_order.validation->validated
                                                     : std::nan("");
          }}},
    };
}

std::map<std::string, Figure> monte_carlo_figures() {
    constexpr auto value = Conversion::value, interval = Conversion::interval, number = Conversion::number;
    const auto of = [](auto member) {
        return [member](const Subject& s) {
            return s.output.monte_carlo ? member(*s.output.monte_carlo) : std::nan("");
        };
    };
    return {
        {"mc-mean", {value, true, of([](const MonteCarloOutput& m) { return m.mean; })}},
        {"mc-u", {interval, true, of([](const MonteCarloOutput& m) { return m.standard_uncertainty; })}},
        {"mc-low", {value, true, of([](const MonteCarloOutput& m) { return m.symmetric.low; })}},
        {"mc-high", {value, true, of([](const MonteCarloOutput& m) { return m.symmetric.high; })}},
        {"mc-short-low", {value, true, of([](const MonteCarloOutput& m) { return m.shortest.low; })}},
        {"mc-short-high", {value, true, of([](const MonteCarloOutput& m) { return m.shortest.high; })}},
        {"mc-correlation",
         {number, true, [](const Subject& s) { return correlation(s.result.covariance, s); }}},
        {"mc-ellipsoid",
         {number, true,
          [](const Subject& s) { return region_of(s).ellipsoid_monte_carlo.value_or(std::nan("")); }}},
        {"mc-rectangle",
         {number, true,
          [](const Subject& s) { return region_of(s).rectangle_monte_carlo.value_or(std::nan("")); }}},
    };
}

const std::map<std::string, Figure>& figures() {
    static const std::map<std::string, Figure> all = [] {
        std::map<std::string, Figure> made = first_order_figures();
        made.merge(monte_carlo_figures());
        return made;
    }();
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
    const double stated = std::max(check.absolute, check.relative * std::abs(check.reference.value_or(0.0)));
    if (!figure.by_monte_carlo) return stated;
    return std::max(stated,
                    4.0 * std::hypot(check.standard_error,
                                     check.scatter * std::sqrt(reference_trials / std::max(trials, 1.0))));
}

Result<CheckedFigure> checked(const VerificationCheck& check, const std::vector<EvaluatedAnalysis>& results) {
    const auto refused = [&](const std::string& what) {
        return fail(ErrorCode::not_found, "verification \"" + check.what + "\": " + what);
    };
    const EvaluatedAnalysis* evaluated = find(results, check.analysis);
    if (!evaluated) return refused("there is no analysis \"" + check.analysis + "\"");
    const auto figure = figures().find(check.figure);
    if (figure == figures().end()) return refused("there is no figure \"" + check.figure + "\"");
    const UncertaintyResult& result = *evaluated->result;
    const std::size_t index = find_output(result, check.output, check.group);
    const std::size_t other = check.with.empty() ? index : find_output(result, check.with, check.group);
    if (index >= result.outputs.size() || other >= result.outputs.size())
        return refused("there is no result \"" + check.output + " " + check.with + "\"");
    CheckedFigure made{check};
    const Subject subject{result, result.outputs[index], index, other};
    made.value = converted(check.unit, figure->second.conversion, figure->second.take(subject));
    const bool of_region = check.figure == "mc-ellipsoid" || check.figure == "mc-rectangle";
    const double trials = static_cast<double>(of_region ? region_of(subject).trials : result.trials);
    made.tolerance = tolerance_of(check, figure->second, trials);
    made.agrees_with_reference =
        !check.reference || std::abs(made.value - *check.reference) <= made.tolerance;
    const double own_scatter = figure->second.by_monte_carlo
                                   ? 4.0 * check.scatter * std::sqrt(reference_trials / std::max(trials, 1.0))
                                   : 0.0;
    made.reproduces_published = !check.published || std::abs(made.value - *check.published) <=
                                                        check.half_digit * (1 + 1e-9) + own_scatter;
    if (std::isnan(made.value)) made.agrees_with_reference = made.reproduces_published = false;
    return made;
}

}  // namespace

bool CheckedCase::passed() const {
    return std::all_of(figures.begin(), figures.end(), [](const CheckedFigure& f) { return f.passed(); });
}

Result<CheckedCase> check_case(const VerificationCase& verification,
                               const std::vector<EvaluatedAnalysis>& results) {
    CheckedCase made{verification, {}};
    for (const VerificationCheck& check : verification.checks) {
        auto one = checked(check, results);
        if (!one) return fail(one.error());
        made.figures.push_back(std::move(*one));
    }
    return made;
}

}  // namespace covaria
