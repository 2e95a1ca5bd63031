#include "core/propagation/kinks.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace covaria::detail {
namespace {

constexpr std::size_t affordable_numbers = 100'000;          // outputs x quantities
constexpr std::array<double, 2> kink_distances{1e-5, 1e-6};  // in standard uncertainties, the second nearer
/// Least jump that counts, as a part of the uncertainty that the sensitivities beside the kink give.
constexpr double noticeable_jump = 1e-3;
/// A curve's difference falls with the distance, or with its root at the ends of a domain.
constexpr double jump_stays = 0.7;
constexpr double last_digits = 1e-15;    // relative change of the estimates that means nothing
constexpr double mostly_rounding = 0.1;  // change of the uncertainty by these digits, relative
constexpr double above_rounding = 10.0;  // a jump of less may be one of the last digits

/// Contributions c u of the quantities (columns) to each output (rows) at x.
Result<Eigen::MatrixXd> contributions_at(const MeasurementModel& model, const Eigen::VectorXd& x,
                                         const Eigen::VectorXd& u) {
    Eigen::MatrixXd jacobian =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(model.outputs().size()), x.size());
    if (!model.jacobian({x.data(), static_cast<std::size_t>(x.size())}, jacobian) || !jacobian.allFinite())
        return fail(ErrorCode::numeric, tell<"the measurement model has no value there">());
    return Eigen::MatrixXd(jacobian * u.asDiagonal());
}

}  // namespace

DoubtfulCoefficients doubtful_coefficients(const MeasurementModel& model, const InputSet& inputs,
                                           const LawOfPropagation& law) {
    const auto outputs = static_cast<std::size_t>(law.estimate.size());
    DoubtfulCoefficients found{std::vector<bool>(outputs, false), std::vector<bool>(outputs, false)};
    if (outputs * inputs.quantities.size() > affordable_numbers || !law.is_differentiable()) return found;
    Eigen::VectorXd u(law.inputs.size()), direction(law.inputs.size());
    for (Eigen::Index i = 0; i < u.size(); ++i) {
        constexpr double golden = 0.6180339887498949;
        const double turns = golden * static_cast<double>(i + 1);
        u(i) = standard_uncertainty_of(inputs, static_cast<std::size_t>(i));
        direction(i) = (i % 2 == 0 ? 1.0 : -1.0) * (0.5 + turns - std::floor(turns)) * u(i);
    }
    std::array<Eigen::MatrixXd, 2> jumps;
    Eigen::VectorXd size = Eigen::VectorXd::Zero(law.estimate.size());
    for (std::size_t k = 0; k < kink_distances.size(); ++k) {
        const auto above = contributions_at(model, law.inputs + kink_distances[k] * direction, u);
        const auto below = contributions_at(model, law.inputs - kink_distances[k] * direction, u);
        if (!above || !below) return found;
        jumps[k] = (*above - *below).cwiseAbs();
        size = size.cwiseMax(above->rowwise().norm()).cwiseMax(below->rowwise().norm());
    }
    const auto here = contributions_at(model, law.inputs, u);
    const auto beside = contributions_at(model, (1.0 + last_digits) * law.inputs, u);
    if (!here || !beside) return found;
    const Eigen::VectorXd rounding = (*here - *beside).cwiseAbs().rowwise().maxCoeff();
    for (std::size_t j = 0; j < outputs; ++j) {
        const auto row = static_cast<Eigen::Index>(j);
        found.is_rounding[j] = rounding(row) > mostly_rounding * size(row);
        for (Eigen::Index i = 0; i < u.size() && !found.is_rounding[j]; ++i) {
            const double far = jumps[0](row, i), near = jumps[1](row, i);
            if (near > noticeable_jump * size(row) && near > jump_stays * far &&
                near > above_rounding * rounding(row))
                found.has_kink[j] = true;
        }
    }
    return found;
}

}  // namespace covaria::detail
