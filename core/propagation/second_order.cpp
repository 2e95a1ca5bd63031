// Second-order terms of the law of propagation.
#include "core/propagation/second_order.h"

#include <cmath>
#include <utility>
#include <vector>

namespace covaria::detail {
namespace {

constexpr double first_step = 0.2;  // in units of u
constexpr int most_halvings = 12;
constexpr int least_levels = 3;                // fewer say nothing about what is left
constexpr double settled_part = 1e-10;         // relative to the derivatives
constexpr double tolerable_error = 0.01;       // relative to the second-order variance
constexpr std::size_t most_terms = 2'000'000;  // outputs x components

/// c(epsilon) for component k displaced by `step`.
Result<Eigen::MatrixXd> displaced_sensitivity(const MeasurementModel& model, const LawOfPropagation& law,
                                              const Eigen::MatrixXd& factors, Eigen::Index k, double step) {
    const Eigen::VectorXd x = law.inputs + step * factors.col(k);
    Eigen::MatrixXd jacobian(law.estimate.size(), law.inputs.size());
    if (!model.jacobian({x.data(), static_cast<std::size_t>(x.size())}, jacobian) || !jacobian.allFinite())
        return fail(ErrorCode::numeric, tell<"the measurement model has no sensitivity coefficients near the "
                                             "estimates: second-order terms do not exist">());
    return Eigen::MatrixXd(jacobian * factors);
}

/// Differences with ever smaller steps, extrapolated, entry by entry where they agree best.
class Extrapolation {
public:
    /// The next difference, with half of the step of the one before.
    void add(Eigen::MatrixXd difference) {
        std::vector<Eigen::MatrixXd> row{std::move(difference)};
        for (std::size_t k = 0; k < last_.size(); ++k) {
            const double fours = std::pow(4.0, static_cast<double>(k + 1));
            row.push_back((fours * row[k] - last_[k]) / (fours - 1.0));
        }
        if (last_.empty()) {
            value = row.front();
            error = Eigen::MatrixXd::Constant(value.rows(), value.cols(), infinity);
        }
        for (std::size_t k = 1; k < row.size(); ++k) {
            const Eigen::MatrixXd off =
                (row[k] - row[k - 1]).cwiseAbs().cwiseMax((row[k] - last_[k - 1]).cwiseAbs());
            for (Eigen::Index i = 0; i < off.size(); ++i)
                if (off(i) < error(i)) {
                    value(i) = row[k](i);
                    error(i) = off(i);
                }
        }
        last_ = std::move(row);
    }
    std::size_t levels() const { return last_.size(); }
    bool has_converged() const { return error.sum() <= settled_part * value.cwiseAbs().sum(); }

    Eigen::MatrixXd value, error;

private:
    std::vector<Eigen::MatrixXd> last_;
};

/// First and second derivative of c by component k.
struct Derivatives {
    Extrapolation first, second;
};

/// `sensitivity` is c at the estimates. Steps that lead to where the model has no derivatives are too wide.
Result<Derivatives> differences(const MeasurementModel& model, const LawOfPropagation& law,
                                const Eigen::MatrixXd& factors, const Eigen::MatrixXd& sensitivity,
                                Eigen::Index k) {
    Derivatives found;
    double step = first_step * law.u(k);
    for (int halving = 0; halving <= most_halvings; ++halving, step *= 0.5) {
        const auto above = displaced_sensitivity(model, law, factors, k, step);
        const auto below = displaced_sensitivity(model, law, factors, k, -step);
        if ((!above || !below) && halving == most_halvings)
            return fail(above ? below.error() : above.error());
        if (!above || !below) continue;
        found.first.add((*above - *below) / (2.0 * step));
        found.second.add((*above - 2.0 * sensitivity + *below) / (step * step));
        const bool enough = found.first.levels() >= least_levels;
        if (enough && found.first.has_converged() && found.second.has_converged()) break;
        if (found.first.levels() == 2 * least_levels) break;  // rounding takes over
    }
    return found;
}

}  // namespace

// sum_i sum_j [ 1/2 f_ij^2 + f_i f_ijj ] u_i^2 u_j^2, column j of the derivatives at a time.
Result<SecondOrder> second_order_terms(const MeasurementModel& model, const InputSet& inputs,
                                       const LawOfPropagation& law, const std::stop_token& stop) {
    SecondOrder terms{Eigen::VectorXd::Zero(law.estimate.size()), Eigen::VectorXd::Zero(law.estimate.size())};
    if (law.condensed || law.terms.size() * inputs.components.size() > most_terms)
        return fail(ErrorCode::bad_input, tell<"there are too many quantities for them">());
    const Eigen::MatrixXd factors = factor_matrix(inputs), sensitivity = sensitivity_matrix(law);
    const Eigen::RowVectorXd squares = law.u.array().square().matrix().transpose();
    Eigen::VectorXd unsure = Eigen::VectorXd::Zero(law.estimate.size()), sure = unsure;
    for (Eigen::Index j = 0; j < sure.size(); ++j) sure(j) = law.covariance(j, j);
    for (Eigen::Index j = 0; j < law.u.size(); ++j) {
        if (stop.stop_requested()) return fail(ErrorCode::cancelled, tell<"the evaluation was stopped">());
        if (!(law.u(j) > 0)) continue;
        const auto found = differences(model, law, factors, sensitivity, j);
        if (!found) return fail(found.error());
        const Extrapolation &first = found->first, &second = found->second;
        const Eigen::MatrixXd half_square = 0.5 * first.value.array().square();
        const Eigen::MatrixXd product = sensitivity.array() * second.value.array();
        terms.variance += (half_square + product) * squares.transpose() * squares(j);
        terms.shift += 0.5 * first.value.col(j) * squares(j);
        sure += (half_square + product.cwiseAbs()) * squares.transpose() * squares(j);
        const Eigen::MatrixXd off = first.value.array().abs() * first.error.array() +
                                    sensitivity.array().abs() * second.error.array();
        unsure += off * squares.transpose() * squares(j);
    }
    if (!(unsure.array() <= tolerable_error * sure.array()).all())
        return fail(ErrorCode::numeric,
                    tell<"the measurement model has a kink at the estimates, or bends too sharply there for "
                         "derivatives of second and third order">());
    return terms;
}

}  // namespace covaria::detail
