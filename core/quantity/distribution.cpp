// Distribution: construction, quantiles of blocks, scaling and shifting.
#include "core/quantity/distribution.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/guarded.h"
#include "core/quantity/distribution_checks.h"
#include "core/quantity/quantile_function.h"

namespace covaria {

namespace {

template <class T>
concept has_limits = requires(T t) {
    t.low;
    t.high;
};

template <class Limits>
void mirror_and_scale(Limits& p, double c) {
    p.low *= c;
    p.high *= c;
    if (c < 0.0) std::swap(p.low, p.high);
}

// The same kind with other parameters where the kind is closed under scaling by c != 0; false where it is
// not.
bool scale(Normal& p, double c) {
    p = {p.mean * c, p.standard_deviation * std::abs(c)};
    return true;
}
bool scale(StudentT& p, double c) {
    p = {p.mean * c, p.scale * std::abs(c), p.degrees_of_freedom};
    return true;
}
bool scale(Exponential& p, double c) {
    p.mean *= std::abs(c);
    return c > 0.0;
}
bool scale(Gamma& p, double c) {
    p.scale *= std::abs(c);
    return c > 0.0;
}
bool scale(Lognormal& p, double c) {
    p.log_mean += std::log(std::abs(c));
    return c > 0.0;
}
bool scale(Discrete& p, double c) {
    for (double& value : p.values) value *= c;
    return true;
}
bool scale(Laplace& p, double c) {
    p = {p.mean * c, p.scale * std::abs(c)};
    return true;
}
bool scale(Weibull& p, double c) {
    p = {p.location * c, p.scale * c, p.shape};
    return true;
}
bool scale(Poisson& p, double c) {
    p = {p.number, p.step * c, p.zero * c};
    return true;
}
bool scale(Binomial& p, double c) {
    p = {p.trials, p.probability, p.step * c, p.zero * c};
    return true;
}
bool scale(StatedHistogram& p, double c) {
    for (double& edge : p.edges) edge *= c;
    if (c < 0.0) {
        std::reverse(p.edges.begin(), p.edges.end());
        std::reverse(p.probabilities.begin(), p.probabilities.end());
    }
    return true;
}
bool scale(CurvilinearTrapezoid& p, double c) {
    mirror_and_scale(p, c);
    p.inexactness *= std::abs(c);
    return true;
}
bool scale(TruncatedNormal& p, double c) {
    mirror_and_scale(p, c);
    p.mean *= c;
    p.standard_deviation *= std::abs(c);
    return true;
}
bool scale(Beta& p, double c) {
    mirror_and_scale(p, c);
    if (c < 0.0) std::swap(p.alpha, p.beta);
    return true;
}
bool scale(has_limits auto& p, double c) {
    mirror_and_scale(p, c);
    return true;
}

bool shift(Normal& p, double d) {
    p.mean += d;
    return true;
}
bool shift(StudentT& p, double d) {
    p.mean += d;
    return true;
}
bool shift(TruncatedNormal& p, double d) {
    p = {p.mean + d, p.standard_deviation, p.low + d, p.high + d};
    return true;
}
bool shift(Discrete& p, double d) {
    for (double& value : p.values) value += d;
    return true;
}
bool shift(Laplace& p, double d) {
    p.mean += d;
    return true;
}
bool shift(Weibull& p, double d) {
    p.location += d;
    return true;
}
bool shift(Poisson& p, double d) {
    p.zero += d;
    return true;
}
bool shift(Binomial& p, double d) {
    p.zero += d;
    return true;
}
bool shift(StatedHistogram& p, double d) {
    for (double& edge : p.edges) edge += d;
    return true;
}
bool shift(has_limits auto& p, double d) {
    p.low += d;
    p.high += d;
    return true;
}
bool shift(auto&, double) {
    return false;
}

}  // namespace

Distribution::Distribution() : Distribution(Normal{0.0, 0.0}) {}
Distribution::Distribution(const Distribution&) = default;
Distribution::Distribution(Distribution&&) noexcept = default;
Distribution& Distribution::operator=(const Distribution&) = default;
Distribution& Distribution::operator=(Distribution&&) noexcept = default;
Distribution::~Distribution() = default;

Distribution::Distribution(DistributionParameters parameters, double location, double factor)
    : parameters_(std::move(parameters)),
      location_(location),
      factor_(factor),
      quantile_function_(detail::make_quantile_function(parameters_)) {
    if (location_ != 0.0 || factor_ != 1.0)
        quantile_function_ = detail::make_affine(quantile_function_, location_, factor_);
}

Result<Distribution> Distribution::make(DistributionParameters parameters) {
    Message problem = detail::distribution_problem(parameters);
    if (problem.empty()) return Distribution(std::move(parameters));
    const std::string_view name = distribution_kinds()[parameters.index()].title;
    return fail(ErrorCode::bad_input,
                tell<"%1 distribution: %2">(Message::declared(name), std::move(problem)));
}

Distribution Distribution::of(DistributionParameters parameters) {
    Result<Distribution> made = make(std::move(parameters));
    if (made) return *std::move(made);
    throw ImpossibleValue(made.error().message.english());
}

Distribution Distribution::normal(double standard_uncertainty) {
    return of(Normal{0.0, standard_uncertainty});
}

bool Distribution::operator==(const Distribution& other) const {
    return parameters_ == other.parameters_ && location_ == other.location_ && factor_ == other.factor_;
}

double Distribution::quantile(double p) const {
    double x = 0.0;
    quantile_function_->at({&p, 1}, {&x, 1});
    return x;
}

void Distribution::quantiles(std::span<const double> p, std::span<double> x) const {
    quantile_function_->at(p, x);
}

void Distribution::from_standard_normal(std::span<const double> z, std::span<double> x) const {
    quantile_function_->at_scores(z, x);
}

Distribution Distribution::scaled(double c) const {
    if (c == 0.0) return Distribution();
    if (c == 1.0) return *this;
    DistributionParameters parameters = parameters_;
    const bool closed = std::visit([c](auto& p) { return scale(p, c); }, parameters);
    return Distribution(std::move(parameters), location_ * c, closed ? factor_ : -factor_);
}

Distribution Distribution::shifted(double d) const {
    if (d == 0.0) return *this;
    DistributionParameters parameters = parameters_;
    const bool closed = std::visit([d](auto& p) { return shift(p, d); }, parameters);
    return Distribution(std::move(parameters), closed ? location_ : location_ + d, factor_);
}

}  // namespace covaria
