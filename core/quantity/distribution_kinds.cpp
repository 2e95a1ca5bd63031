// The table of the kinds of distribution and their parameters, for files and forms. A new kind is a struct in
// DistributionParameters, a row here and in `with_values`, a check, moments, a density and a quantile
// function.
#include <algorithm>
#include <array>
#include <string>
#include <type_traits>
#include <utility>

#include "core/quantity/distribution.h"

namespace covaria {

namespace {

constexpr DistributionParameterInfo mean_value{"mean", "mean value", true, false};
constexpr DistributionParameterInfo deviation{"standard_deviation", "standard deviation", true, true};
constexpr DistributionParameterInfo low_limit{"low", "lower limit", true, false};
constexpr DistributionParameterInfo high_limit{"high", "upper limit", true, false};
constexpr DistributionParameterInfo scale_factor{"scale", "scale", true, true};

constexpr DistributionParameterInfo event_step{"step", "step of one event", true, true};
constexpr DistributionParameterInfo without_events{"zero", "value without an event", true, false};

template <class T>
constexpr bool has_lists = std::is_same_v<T, Discrete> || std::is_same_v<T, StatedHistogram>;

/// Pointers to the parameters of a kind in the order of the table.
template <class T>
auto members(T& p) {
    using Kind = std::remove_const_t<T>;
    if constexpr (std::is_same_v<Kind, Normal>)
        return std::array{&p.mean, &p.standard_deviation};
    else if constexpr (std::is_same_v<Kind, StudentT>)
        return std::array{&p.mean, &p.scale, &p.degrees_of_freedom};
    else if constexpr (std::is_same_v<Kind, CurvilinearTrapezoid>)
        return std::array{&p.low, &p.high, &p.inexactness};
    else if constexpr (std::is_same_v<Kind, Trapezoidal>)
        return std::array{&p.low, &p.high, &p.beta};
    else if constexpr (std::is_same_v<Kind, Exponential>)
        return std::array{&p.mean};
    else if constexpr (std::is_same_v<Kind, Gamma>)
        return std::array{&p.shape, &p.scale};
    else if constexpr (std::is_same_v<Kind, TruncatedNormal>)
        return std::array{&p.mean, &p.standard_deviation, &p.low, &p.high};
    else if constexpr (std::is_same_v<Kind, Lognormal>)
        return std::array{&p.log_mean, &p.log_standard_deviation};
    else if constexpr (std::is_same_v<Kind, Beta>)
        return std::array{&p.low, &p.high, &p.alpha, &p.beta};
    else if constexpr (std::is_same_v<Kind, Laplace>)
        return std::array{&p.mean, &p.scale};
    else if constexpr (std::is_same_v<Kind, Weibull>)
        return std::array{&p.location, &p.scale, &p.shape};
    else if constexpr (std::is_same_v<Kind, Poisson>)
        return std::array{&p.number, &p.step, &p.zero};
    else if constexpr (std::is_same_v<Kind, Binomial>)
        return std::array{&p.trials, &p.probability, &p.step, &p.zero};
    else
        return std::array{&p.low, &p.high};
}

/// "Discrete" has as many probabilities as values, "histogram" one less than edges.
template <class Kind>
Result<DistributionParameters> lists_from(std::span<const double> numbers) {
    constexpr bool is_histogram = std::is_same_v<Kind, StatedHistogram>;
    if ((numbers.size() % 2 != 0) != is_histogram)
        return fail(ErrorCode::bad_input,
                    is_histogram ? tell<"histogram: there must be one edge more than probabilities.">()
                                 : tell<"discrete distribution: there must be as many probabilities as "
                                        "values.">());
    const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(first_list_size(numbers.size()));
    return Kind{{numbers.begin(), middle}, {middle, numbers.end()}};
}

/// The parameters of alternative `index` with these values.
template <std::size_t I = 0>
Result<DistributionParameters> with_values(std::size_t index, std::span<const double> values) {
    using Kind = std::variant_alternative_t<I, DistributionParameters>;
    if (index != I) {
        if constexpr (I + 1 < std::variant_size_v<DistributionParameters>)
            return with_values<I + 1>(index, values);
    }
    if constexpr (has_lists<Kind>) {
        return lists_from<Kind>(values);
    } else {
        Kind kind{};
        const auto places = members(kind);
        for (std::size_t i = 0; i < places.size(); ++i) *places[i] = values[i];
        return kind;
    }
}

}  // namespace

const std::vector<DistributionKindInfo>& distribution_kinds() {
    static const std::vector<DistributionKindInfo> kinds{
        {"normal", "normal", {mean_value, deviation}},
        {"student-t",
         "Student t",
         {mean_value, scale_factor, {"degrees_of_freedom", "degrees of freedom", false, false}}},
        {"rectangular", "rectangular", {low_limit, high_limit}},
        {"curvilinear-trapezoid",
         "curvilinear trapezoid",
         {low_limit, high_limit, {"inexactness", "inexactness of the limits", true, true}}},
        {"trapezoidal",
         "trapezoidal",
         {low_limit, high_limit, {"beta", "ratio of top to base", false, false}}},
        {"triangular", "triangular", {low_limit, high_limit}},
        {"arcsine", "arc sine", {low_limit, high_limit}},
        {"exponential", "exponential", {{"mean", "mean value", true, true}}},
        {"gamma", "gamma", {{"shape", "shape", false, false}, scale_factor}},
        {"truncated-normal", "truncated normal", {mean_value, deviation, low_limit, high_limit}},
        {"lognormal",
         "lognormal",
         {{"log_mean", "mean value of the logarithm of the number in SI", false, false},
          {"log_standard_deviation", "standard deviation of the logarithm", false, false}}},
        {"beta",
         "beta",
         {low_limit,
          high_limit,
          {"alpha", "parameter alpha", false, false},
          {"beta", "parameter beta", false, false}}},
        {"discrete", "discrete", {}, "values"},
        {"laplace", "Laplace", {mean_value, scale_factor}},
        {"weibull",
         "Weibull",
         {{"location", "location", true, false}, scale_factor, {"shape", "shape", false, false}}},
        {"poisson",
         "Poisson",
         {{"number", "expected number of events", false, false}, event_step, without_events}},
        {"binomial",
         "binomial",
         {{"trials", "number of trials", false, false},
          {"probability", "probability", false, false},
          event_step,
          without_events}},
        {"histogram", "histogram", {}, "edges"},
    };
    return kinds;
}

const DistributionKindInfo* find_distribution_kind(std::string_view key) {
    const std::vector<DistributionKindInfo>& kinds = distribution_kinds();
    const auto found = std::ranges::find(kinds, key, &DistributionKindInfo::key);
    return found == kinds.end() ? nullptr : &*found;
}

Result<Distribution> distribution_from(std::string_view kind, std::span<const double> parameters) {
    const std::vector<DistributionKindInfo>& kinds = distribution_kinds();
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i].key != kind) continue;
        const std::size_t wanted = kinds[i].parameters.size();
        if (wanted != 0 && wanted != parameters.size())
            return fail(ErrorCode::bad_input,
                        tell<"%1 distribution: %2 parameters are needed, %3 are given.">(
                            Message::declared(kinds[i].title), wanted, parameters.size()));
        return with_values(i, parameters).and_then(&Distribution::make);
    }
    std::string known;
    for (const DistributionKindInfo& info : kinds)
        known += (known.empty() ? "" : ", ") + std::string(info.key);
    return fail(ErrorCode::bad_input, tell<"the distribution \"%1\" is not known. Known distributions: %2.">(
                                          std::string(kind), known));
}

std::vector<double> distribution_parameters(const Distribution& distribution) {
    return std::visit(
        [](const auto& p) {
            std::vector<double> values;
            using Kind = std::remove_cvref_t<decltype(p)>;
            if constexpr (has_lists<Kind>) {
                if constexpr (std::is_same_v<Kind, Discrete>)
                    values = p.values;
                else
                    values = p.edges;
                values.insert(values.end(), p.probabilities.begin(), p.probabilities.end());
            } else {
                for (const double* place : members(p)) values.push_back(*place);
            }
            return values;
        },
        distribution.parameters());
}

std::size_t first_list_size(std::size_t parameters) {
    return (parameters + 1) / 2;
}

std::string_view Distribution::kind() const {
    return distribution_kinds()[parameters_.index()].key;
}

std::string_view Distribution::title() const {
    return distribution_kinds()[parameters_.index()].title;
}

}  // namespace covaria
