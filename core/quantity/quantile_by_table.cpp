// Quantile functions whose inverses cost a microsecond and more (Student t, gamma, beta): tables over the
// normal score.
#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <utility>

#include "core/math/special_quantiles.h"
#include "core/quantity/elementwise_quantile.h"
#include "core/quantity/normal_score_table.h"

namespace covaria::detail {

namespace {

using Table = std::shared_ptr<const NormalScoreTable>;

namespace policies = boost::math::policies;
using Quiet =
    policies::policy<policies::domain_error<policies::ignore_error>,
                     policies::overflow_error<policies::ignore_error>,
                     policies::evaluation_error<policies::ignore_error>, policies::promote_double<false>>;

constexpr double tolerance = 1e-11;
constexpr double limit = NormalScoreTable::largest_score;
constexpr double largest_direct_score = 37.0;  ///< beyond it probabilities are too small for double

/// Tables in use by shape parameters: distributions of one shape share theirs, however often they are made.
class SharedTables {
public:
    template <class Build>
    Table get(std::pair<double, double> shape, Build build) {
        const std::lock_guard lock(mutex_);
        if (const auto known = tables_.find(shape); known != tables_.end())
            if (Table table = known->second.lock()) return table;
        std::erase_if(tables_, [](const auto& entry) { return entry.second.expired(); });
        Table table = build();
        tables_[shape] = table;
        return table;
    }

private:
    std::mutex mutex_;
    std::map<std::pair<double, double>, std::weak_ptr<const NormalScoreTable>> tables_;
};

// Each shape gives the function of the score that is tabulated, smooth and computed directly where there is
// no table.

/// t/z, an even function. Near the centre from the probability between -t and t, which keeps all its digits
/// there.
struct StudentTShape {
    static constexpr NormalScoreTable::Domain domain{0.0, limit, true};
    double degrees_of_freedom;
    std::pair<double, double> key() const { return {degrees_of_freedom, 0.0}; }
    double operator()(double z) const {
        if (z > 0.5) return -t_quantile(normal_distribution_function(-z), degrees_of_freedom) / z;
        const double score = std::max(z, 1e-8);  // t/z has its limit there
        double rest = 0.0;
        const double x = boost::math::ibeta_inv(0.5, 0.5 * degrees_of_freedom,
                                                std::erf(score / std::numbers::sqrt2), &rest, Quiet());
        return std::sqrt(degrees_of_freedom * x / rest) / score;
    }
};

/// Below this logarithm the leading term of a distribution function is all of it, in double precision.
constexpr double leading_term_only = -45.0;

/// ln x
struct GammaShape {
    static constexpr NormalScoreTable::Domain domain{-limit, limit, false};
    double shape;
    std::pair<double, double> key() const { return {shape, 0.0}; }
    double operator()(double z) const {
        const double smaller = normal_distribution_function(-std::abs(z));
        if (z > 0.0) return std::log(boost::math::gamma_q_inv(shape, smaller, Quiet()));
        const double leading =
            (std::log(smaller) + std::lgamma(shape + 1.0)) / shape;  // p = x^a/Gamma(a + 1)
        return leading < leading_term_only ? leading
                                           : std::log(boost::math::gamma_p_inv(shape, smaller, Quiet()));
    }
};

/// ln(x/(1 - x))
struct BetaShape {
    static constexpr NormalScoreTable::Domain domain{-limit, limit, false};
    double alpha, beta;
    std::pair<double, double> key() const { return {alpha, beta}; }
    double operator()(double z) const {
        return z < 0.0 ? of_lower_tail(alpha, beta, z) : -of_lower_tail(beta, alpha, -z);
    }
    static double of_lower_tail(double a, double b, double z) {
        const double p = normal_distribution_function(z);
        const double log_beta = std::lgamma(a) + std::lgamma(b) - std::lgamma(a + b);
        const double leading = (std::log(p) + std::log(a) + log_beta) / a;  // p = x^a/(a B(a, b))
        if (leading + std::log1p(b) < leading_term_only) return leading;
        double rest = 0.0;
        const double x = boost::math::ibeta_inv(a, b, p, &rest, Quiet());
        return std::log(x) - std::log(rest);
    }
};

template <class Shape>
class Tabulated {
public:
    explicit Tabulated(const Shape& shape) : shape_(shape) {
        static SharedTables tables;
        table_ =
            tables.get(shape.key(), [&] { return NormalScoreTable::build(shape, Shape::domain, tolerance); });
    }
    double operator()(double z) const {
        if (table_ != nullptr && std::abs(z) < limit) return (*table_)(z);
        return shape_(std::clamp(z, -largest_direct_score, largest_direct_score));
    }

private:
    Shape shape_;
    Table table_;
};

class StudentTQuantile final : public QuantileFunction {
public:
    explicit StudentTQuantile(const StudentT& t)
        : mean_(t.mean), scale_(t.scale), ratio_(StudentTShape{t.degrees_of_freedom}) {}
    void at(std::span<const double> p, std::span<double> x) const override {
        normal_quantiles(p, x);
        at_scores(x, x);
    }
    void at_scores(std::span<const double> z, std::span<double> x) const override {
        for (std::size_t i = 0; i < z.size(); ++i) x[i] = mean_ + scale_ * (z[i] * ratio_(std::abs(z[i])));
    }

private:
    double mean_;
    double scale_;
    Tabulated<StudentTShape> ratio_;
};

/// x = formula(tabulated(z)).
template <class Shape, class Formula>
class TabulatedQuantile final : public QuantileFunction {
public:
    TabulatedQuantile(const Shape& shape, Formula formula)
        : tabulated_(shape), formula_(std::move(formula)) {}
    void at(std::span<const double> p, std::span<double> x) const override {
        normal_quantiles(p, x);
        at_scores(x, x);
    }
    void at_scores(std::span<const double> z, std::span<double> x) const override {
        for (std::size_t i = 0; i < z.size(); ++i) x[i] = tabulated_(z[i]);
        transform_batches(x, x, 0.0, formula_);
    }

private:
    Tabulated<Shape> tabulated_;
    Formula formula_;
};

template <class Shape, class Formula>
QuantileFunctionPointer make_tabulated(const Shape& shape, Formula formula) {
    return std::make_shared<TabulatedQuantile<Shape, Formula>>(shape, std::move(formula));
}

}  // namespace

QuantileFunctionPointer make_student_t(const StudentT& parameters) {
    return std::make_shared<StudentTQuantile>(parameters);
}

QuantileFunctionPointer make_gamma(const Gamma& parameters) {
    return make_tabulated(GammaShape{parameters.shape}, [scale = parameters.scale](Batch logarithm) {
        return Batch(scale) * xsimd::exp(logarithm);
    });
}

QuantileFunctionPointer make_beta(const Beta& parameters) {
    return make_tabulated(BetaShape{parameters.alpha, parameters.beta},
                          [low = parameters.low, high = parameters.high](Batch logit) {
                              const Batch x = Batch(1.0) / (Batch(1.0) + xsimd::exp(-logit));
                              return clamped(Batch(low) + Batch(high - low) * x, low, high);
                          });
}

}  // namespace covaria::detail
