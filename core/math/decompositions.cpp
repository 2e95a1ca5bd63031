#include "core/math/decompositions.h"

namespace covaria {

std::optional<Eigen::VectorXd> damped_step(const Eigen::MatrixXd& normal, const Eigen::VectorXd& right) {
    if (!normal.allFinite()) return std::nullopt;
    const Eigen::LDLT<Eigen::MatrixXd> factors(normal);
    if (factors.info() != Eigen::Success) return std::nullopt;
    Eigen::VectorXd step = factors.solve(right);
    if (!step.allFinite()) return std::nullopt;
    return step;
}

}  // namespace covaria

template class Eigen::JacobiSVD<Eigen::MatrixXd>;
template class Eigen::HouseholderQR<Eigen::MatrixXd>;
template class Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;
template Eigen::LLT<Eigen::MatrixXd>& Eigen::LLT<Eigen::MatrixXd>::compute(
    const Eigen::EigenBase<Eigen::MatrixXd>&);
template Eigen::LDLT<Eigen::MatrixXd>& Eigen::LDLT<Eigen::MatrixXd>::compute(
    const Eigen::EigenBase<Eigen::MatrixXd>&);
template Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>&
Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>::compute(const Eigen::EigenBase<Eigen::MatrixXd>&, int);
