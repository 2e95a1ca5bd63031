#include "core/model/sensor.h"

#include <Eigen/Eigenvalues>

namespace covaria {

Eigen::Isometry3d Station::X_WS() const {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.translation() = Eigen::Vector3d(coordinates[0], coordinates[1], coordinates[2]);
    X.linear() =
        station_rotation<double>(angles, Vector3<double>(coordinates[3], coordinates[4], coordinates[5]));
    return X;
}

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

Eigen::SelfAdjointEigenSolver<Matrix6> correlation_of(const SensorSource& sensor) {
    Matrix6 R = Matrix6::Identity();
    for (const StationCorrelation& c : sensor.station_correlations()) {
        const auto i = static_cast<int>(c.first), j = static_cast<int>(c.second);
        R(i, j) = R(j, i) = c.coefficient;
    }
    return Eigen::SelfAdjointEigenSolver<Matrix6>(R);
}

}  // namespace

bool has_valid_correlation(const SensorSource& sensor) {
    return correlation_of(sensor).eigenvalues().minCoeff() > -1e-9;
}

Eigen::Matrix<double, 6, 6> station_factor(const SensorSource& sensor) {
    const Eigen::SelfAdjointEigenSolver<Matrix6> solver = correlation_of(sensor);
    Eigen::Matrix<double, 6, 1> u;
    for (int i = 0; i < 6; ++i)
        u[i] = sensor.station_components()[static_cast<std::size_t>(i)].distribution.standard_uncertainty();
    return u.asDiagonal() * solver.eigenvectors() *
           solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

}  // namespace covaria
