// Quantile functions whose inverses cost a microsecond and more (Student t, gamma, beta): tables over the
// normal score.
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <map>
#include <mutex>
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

/// t/z, an even function.
struct StudentTShape {
    static constexpr NormalScoreTable::Domain domain{0.0, limit, true};
    double degrees_of_freedom;
    std::pair<double, double> key() const { return {degrees_of_freedom, 0.0}; }
    double operator()(double z) const {
        const double score = std::max(z, 1e-8);  // t/z has its limit there
        return -t_quantile(normal_distribution_function(-score), degrees_of_freedom) / score;
    }
};

/// ln x
struct GammaShape {
    static constexpr NormalScoreTable::Domain domain{-limit, limit, false};
    double shape;
    std::pair<double, double> key() const { return {shape, 0.0}; }
    double operator()(double z) const {
        const double smaller = normal_distribution_function(-std::abs(z));
        return std::log(z < 0.0 ? boost::math::gamma_p_inv(shape, smaller, Quiet())
                                : boost::math::gamma_q_inv(shape, smaller, Quiet()));
    }
};

/// ln(x/(1 - x))
struct BetaShape {
    static constexpr NormalScoreTable::Domain domain{-limit, limit, false};
    double alpha, beta;
    std::pair<double, double> key() const { return {alpha, beta}; }
    double operator()(double z) const {
        const double smaller = normal_distribution_function(-std::abs(z));
        double rest = 0.0;
        const double x = z < 0.0 ? boost::math::ibeta_inv(alpha, beta, smaller, &rest, Quiet())
                                 : boost::math::ibetac_inv(alpha, beta, smaller, &rest, Quiet());
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
        if (table_ == nullptr || !(std::abs(z) < limit)) return shape_(z);
        return (*table_)(z);
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
