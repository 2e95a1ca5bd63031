// Checks of the parameters of distributions, one function per kind.
#include "core/quantity/distribution_checks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/math/normal_quantile.h"

namespace covaria::detail {

namespace {

using Words = Message (*)();

constexpr double most_events = 1e7;  ///< tables of probabilities stay small

/// Keeps the first problem found.
class Check {
public:
    Check& that(bool good, Words problem) {
        if (message_.empty() && !good) message_ = problem();
        return *this;
    }
    Check& finite(Words name, double value) {
        constexpr double largest = 1e150;  // squares stay finite
        return of(name, std::isfinite(value), tell<"the %1 must be a finite number.", Message>)
            .of(name, std::abs(value) <= largest, tell<"the %1 is too large (at most 1e150).", Message>);
    }
    Check& not_negative(Words name, double value) {
        return finite(name, value).of(name, value >= 0.0, tell<"the %1 must not be negative.", Message>);
    }
    /// Outside, numbers of type double cannot hold the quantiles, or the distribution is normal for every
    /// purpose.
    Check& shape(Words name, double value) {
        return of(name, value >= 1e-3 && value <= 1e6,
                  tell<"the %1 must lie between 0.001 and 1000000.", Message>);
    }
    Check& limits(double low, double high) {
        return finite(tell<"lower limit">, low)
            .finite(tell<"upper limit">, high)
            .that(low <= high, tell<"the lower limit must not be greater than the upper limit.">);
    }
    Check& probabilities(const std::vector<double>& all) {
        double sum = 0.0;
        for (const double probability : all) {
            not_negative(tell<"probabilities">, probability);
            sum += probability;
        }
        return that(std::abs(sum - 1.0) <= 1e-9, tell<"the probabilities must sum to 1.">);
    }
    Message message() const { return message_; }

private:
    Check& of(Words name, bool good, Message (*problem)(Message&&)) {
        if (message_.empty() && !good) message_ = problem(name());
        return *this;
    }

    Message message_;
};

Message problem(const Normal& n) {
    return Check()
        .finite(tell<"mean value">, n.mean)
        .not_negative(tell<"standard deviation">, n.standard_deviation)
        .message();
}

Message problem(const StudentT& t) {
    return Check()
        .finite(tell<"mean value">, t.mean)
        .not_negative(tell<"scale">, t.scale)
        .that(t.degrees_of_freedom >= 0.2,
              tell<"the degrees of freedom must be at least 0.2 (they may be infinite).">)
        .message();
}

Message problem(const Rectangular& r) {
    return Check().limits(r.low, r.high).message();
}

Message problem(const CurvilinearTrapezoid& c) {
    return Check()
        .limits(c.low, c.high)
        .not_negative(tell<"inexactness of the limits">, c.inexactness)
        .that(c.inexactness <= 0.5 * (c.high - c.low),
              tell<"the inexactness of the limits must not exceed half the distance between them.">)
        .message();
}

Message problem(const Trapezoidal& t) {
    return Check()
        .limits(t.low, t.high)
        .that(t.beta >= 0.0 && t.beta <= 1.0, tell<"the ratio beta of top to base must lie between 0 and 1.">)
        .message();
}

Message problem(const Triangular& t) {
    return Check().limits(t.low, t.high).message();
}

Message problem(const Arcsine& a) {
    return Check().limits(a.low, a.high).message();
}

Message problem(const Exponential& e) {
    return Check().not_negative(tell<"mean value">, e.mean).message();
}

Message problem(const Gamma& g) {
    return Check().shape(tell<"shape">, g.shape).not_negative(tell<"scale">, g.scale).message();
}

Message problem(const TruncatedNormal& t) {
    Check check;
    check.finite(tell<"mean value">, t.mean).not_negative(tell<"standard deviation">, t.standard_deviation);
    check.that(t.low <= t.high, tell<"the lower limit must not be greater than the upper limit.">);
    check.that(t.low < infinity && t.high > -infinity, tell<"one of the limits excludes every value.">);
    if (!check.message().empty() || t.low == t.high) return check.message();
    if (t.standard_deviation == 0.0)
        return check
            .that(t.low <= t.mean && t.mean <= t.high, tell<"the mean value lies outside the limits.">)
            .message();
    // 1e-300 leaves room for differences of probabilities: beyond it they are no longer normal numbers.
    const double nearest = std::clamp(t.mean, t.low, t.high) - t.mean;
    return check
        .that(normal_distribution_function(-std::abs(nearest) / t.standard_deviation) > 1e-300,
              tell<"the limits lie so far from the mean value that no probability is left between them.">)
        .message();
}

Message problem(const Lognormal& l) {
    const double variance = l.log_standard_deviation * l.log_standard_deviation;
    return Check()
        .finite(tell<"mean value of the logarithm">, l.log_mean)
        .not_negative(tell<"standard deviation of the logarithm">, l.log_standard_deviation)
        .that(std::isfinite(std::exp(2.0 * (l.log_mean + variance))),
              tell<"the parameters of the logarithm are too large: the quantity has no finite variance in "
                   "numbers.">)
        .message();
}

Message problem(const Beta& b) {
    return Check()
        .limits(b.low, b.high)
        .shape(tell<"parameter alpha">, b.alpha)
        .shape(tell<"parameter beta">, b.beta)
        .message();
}

Message problem(const Discrete& d) {
    Check check;
    check.that(!d.values.empty(), tell<"a discrete distribution needs at least one value.">);
    check.that(d.values.size() == d.probabilities.size(),
               tell<"there must be as many probabilities as values.">);
    for (const double value : d.values) check.finite(tell<"values">, value);
    return check.probabilities(d.probabilities).message();
}

Message problem(const Laplace& l) {
    return Check().finite(tell<"mean value">, l.mean).not_negative(tell<"scale">, l.scale).message();
}

Message problem(const Weibull& w) {
    return Check()
        .finite(tell<"location">, w.location)
        .finite(tell<"scale">, w.scale)
        .that(w.shape >= 0.1 && w.shape <= 1e6, tell<"the shape must lie between 0.1 and 1000000.">)
        .message();
}

Message problem(const Poisson& p) {
    return Check()
        .finite(tell<"step">, p.step)
        .finite(tell<"value without an event">, p.zero)
        .that(p.number >= 0.0 && p.number <= most_events,
              tell<"the expected number of events must lie between 0 and 10000000; beyond it a normal "
                   "distribution says the same.">)
        .message();
}

Message problem(const Binomial& b) {
    return Check()
        .finite(tell<"step">, b.step)
        .finite(tell<"value without an event">, b.zero)
        .that(b.trials >= 0.0 && b.trials <= most_events && b.trials == std::round(b.trials),
              tell<"the number of trials must be a whole number up to 10000000; beyond it a normal "
                   "distribution says the same.">)
        .that(b.probability >= 0.0 && b.probability <= 1.0, tell<"the probability must lie between 0 and 1.">)
        .message();
}

Message problem(const StatedHistogram& h) {
    Check check;
    check.that(!h.probabilities.empty(), tell<"a histogram needs at least one cell.">);
    check.that(h.edges.size() == h.probabilities.size() + 1,
               tell<"there must be one edge more than probabilities.">);
    for (const double edge : h.edges) check.finite(tell<"edges">, edge);
    check.that(std::adjacent_find(h.edges.begin(), h.edges.end(), std::greater_equal<>()) == h.edges.end(),
               tell<"the edges must rise.">);
    return check.probabilities(h.probabilities).message();
}

}  // namespace

Message distribution_problem(const DistributionParameters& parameters) {
    return std::visit([](const auto& p) { return problem(p); }, parameters);
}

}  // namespace covaria::detail
