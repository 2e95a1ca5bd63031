// Second-order terms of the law of propagation.
#include "core/propagation/second_order.h"

#include <cmath>

namespace covaria::detail {
namespace {

constexpr double step_in_u = 0.1;
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

/// First and second derivative of c by component k.
struct Derivatives {
    Eigen::MatrixXd first, second;
};

/// By central differences; `sensitivity` is c at the estimates.
Result<Derivatives> differences(const MeasurementModel& model, const LawOfPropagation& law,
                                const Eigen::MatrixXd& factors, const Eigen::MatrixXd& sensitivity,
                                Eigen::Index k, double step) {
    const auto above = displaced_sensitivity(model, law, factors, k, step);
    const auto below = displaced_sensitivity(model, law, factors, k, -step);
    if (!above || !below) return fail(above ? below.error() : above.error());
    return Derivatives{(*above - *below) / (2.0 * step),
                       (*above - 2.0 * sensitivity + *below) / (step * step)};
}

}  // namespace

// sum_i sum_j [ 1/2 f_ij^2 + f_i f_ijj ] u_i^2 u_j^2, column j of the derivatives at a time.
Result<SecondOrder> second_order_terms(const MeasurementModel& model, const InputSet& inputs,
                                       const LawOfPropagation& law, const std::stop_token& stop) {
    SecondOrder terms{Eigen::VectorXd::Zero(law.estimate.size()), Eigen::VectorXd::Zero(law.estimate.size())};
    if (law.terms.size() * inputs.components.size() > most_terms)
        return fail(ErrorCode::bad_input, tell<"there are too many quantities for them">());
    const Eigen::MatrixXd factors = factor_matrix(inputs), sensitivity = sensitivity_matrix(law);
    const Eigen::RowVectorXd squares = law.u.array().square().matrix().transpose();
    for (Eigen::Index j = 0; j < law.u.size(); ++j) {
        if (stop.stop_requested()) return fail(ErrorCode::cancelled, tell<"the evaluation was stopped">());
        if (!(law.u(j) > 0)) continue;
        const double step = step_in_u * law.u(j);
        const auto near = differences(model, law, factors, sensitivity, j, step);
        const auto far = differences(model, law, factors, sensitivity, j, 2.0 * step);
        if (!near || !far) return fail(near ? far.error() : near.error());
        // Richardson: without the error of the second power of the step.
        const Eigen::MatrixXd first = (4.0 * near->first - far->first) / 3.0;
        const Eigen::MatrixXd second = (4.0 * near->second - far->second) / 3.0;
        const Eigen::MatrixXd term = 0.5 * first.array().square() + sensitivity.array() * second.array();
        terms.variance += term * squares.transpose() * squares(j);
        terms.shift += 0.5 * first.col(j) * squares(j);
    }
    return terms;
}

}  // namespace covaria::detail
