// Checks of the parameters of distributions, one function per kind.
#include "core/quantity/distribution_checks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/normal_quantile.h"

namespace covaria::detail {

namespace {

/// Keeps the first problem found.
class Check {
public:
    Check& that(bool good, std::string problem) {
        if (message_.empty() && !good) message_ = std::move(problem);
        return *this;
    }
    Check& finite(const char* name, double value) {
        constexpr double largest = 1e150;  // squares stay finite
        return that(std::isfinite(value), std::string("the ") + name + " must be a finite number.")
            .that(std::abs(value) <= largest, std::string("the ") + name + " is too large (at most 1e150).");
    }
    Check& not_negative(const char* name, double value) {
        return finite(name, value).that(value >= 0.0, std::string("the ") + name + " must not be negative.");
    }
    /// Outside, numbers of type double cannot hold the quantiles, or the distribution is normal for every
    /// purpose.
    Check& shape(const char* name, double value) {
        return that(value >= 1e-3 && value <= 1e6,
                    std::string("the ") + name + " must lie between 0.001 and 1000000.");
    }
    Check& limits(double low, double high) {
        return finite("lower limit", low)
            .finite("upper limit", high)
            .that(low <= high, "the lower limit must not be greater than the upper limit.");
    }
    std::string message() const { return message_; }

private:
    std::string message_;
};

std::string problem(const Normal& n) {
    return Check()
        .finite("mean value", n.mean)
        .not_negative("standard deviation", n.standard_deviation)
        .message();
}

std::string problem(const StudentT& t) {
    return Check()
        .finite("mean value", t.mean)
        .not_negative("scale", t.scale)
        .that(t.degrees_of_freedom >= 0.2,
              "the degrees of freedom must be at least 0.2 (they may be infinite).")
        .message();
}

std::string problem(const Rectangular& r) {
    return Check().limits(r.low, r.high).message();
}

std::string problem(const CurvilinearTrapezoid& c) {
    return Check()
        .limits(c.low, c.high)
        .not_negative("inexactness of the limits", c.inexactness)
        .that(c.inexactness <= 0.5 * (c.high - c.low),
              "the inexactness of the limits must not exceed half the distance between them.")
        .message();
}

std::string problem(const Trapezoidal& t) {
    return Check()
        .limits(t.low, t.high)
        .that(t.beta >= 0.0 && t.beta <= 1.0, "the ratio beta of top to base must lie between 0 and 1.")
        .message();
}

std::string problem(const Triangular& t) {
    return Check().limits(t.low, t.high).message();
}

std::string problem(const Arcsine& a) {
    return Check().limits(a.low, a.high).message();
}

std::string problem(const Exponential& e) {
    return Check().not_negative("mean value", e.mean).message();
}

std::string problem(const Gamma& g) {
    return Check().shape("shape", g.shape).not_negative("scale", g.scale).message();
}

std::string problem(const TruncatedNormal& t) {
    Check check;
    check.finite("mean value", t.mean).not_negative("standard deviation", t.standard_deviation);
    check.that(t.low <= t.high, "the lower limit must not be greater than the upper limit.");
    check.that(t.low < infinity && t.high > -infinity, "one of the limits excludes every value.");
    if (!check.message().empty() || t.low == t.high) return check.message();
    if (t.standard_deviation == 0.0)
        return check.that(t.low <= t.mean && t.mean <= t.high, "the mean value lies outside the limits.")
            .message();
    // 1e-300 leaves room for differences of probabilities: beyond it they are no longer normal numbers.
    const double nearest = std::clamp(t.mean, t.low, t.high) - t.mean;
    return check
        .that(normal_distribution_function(-std::abs(nearest) / t.standard_deviation) > 1e-300,
              "the limits lie so far from the mean value that no probability is left between them.")
        .message();
}

std::string problem(const Lognormal& l) {
    const double variance = l.log_standard_deviation * l.log_standard_deviation;
    return Check()
        .finite("mean value of the logarithm", l.log_mean)
        .not_negative("standard deviation of the logarithm", l.log_standard_deviation)
        .that(
            std::isfinite(std::exp(2.0 * (l.log_mean + variance))),
            "the parameters of the logarithm are too large: the quantity has no finite variance in numbers.")
        .message();
}

std::string problem(const Beta& b) {
    return Check()
        .limits(b.low, b.high)
        .shape("parameter alpha", b.alpha)
        .shape("parameter beta", b.beta)
        .message();
}

std::string problem(const Discrete& d) {
    Check check;
    check.that(!d.values.empty(), "a discrete distribution needs at least one value.");
    check.that(d.values.size() == d.probabilities.size(), "there must be as many probabilities as values.");
    double sum = 0.0;
    for (const double value : d.values) check.finite("values", value);
    for (const double probability : d.probabilities) {
        check.not_negative("probabilities", probability);
        sum += probability;
    }
    return check.that(std::abs(sum - 1.0) <= 1e-9, "the probabilities must sum to 1.").message();
}

}  // namespace

std::string distribution_problem(const DistributionParameters& parameters) {
    return std::visit([](const auto& p) { return problem(p); }, parameters);
}

}  // namespace covaria::detail
