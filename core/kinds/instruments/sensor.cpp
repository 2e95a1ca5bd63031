#include "core/kinds/instruments/sensor.h"
#include "core/math/decompositions.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace covaria {

Message words_of(Observable observable) {
    static constexpr Message (*words[])() = {tell<"distance">, tell<"azimuth">, tell<"elevation">};
    return words[static_cast<int>(observable)]();
}

Eigen::Isometry3d Station::X_WS() const {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.translation() = Eigen::Vector3d(coordinates[0], coordinates[1], coordinates[2]);
    X.linear() =
        station_rotation<double>(angles, Vector3<double>(coordinates[3], coordinates[4], coordinates[5]));
    return X;
}

namespace {

/// d(reading)/d(point) in the sensor's axes, a row for every observable.
Eigen::Matrix3d reading_gradients(const Eigen::Vector3d& v) {
    const double rho = v.head<2>().norm(), d = v.norm();
    Eigen::Matrix3d G;
    G.row(0) = v.transpose() / d;
    G.row(1) = Eigen::RowVector3d(-v.y(), v.x(), 0.0) / (rho * rho);
    G.row(2) = Eigen::RowVector3d(-v.x() * v.z(), -v.y() * v.z(), rho * rho) / (rho * d * d);
    return G;
}

/// The same where the horizontal distance is next to nothing: the azimuth as its effect across the azimuth
/// read.
Eigen::Matrix3d overhead_gradients(const Eigen::Vector3d& v, double azimuth) {
    Eigen::Matrix3d G;
    const Eigen::Vector3d across(-std::sin(azimuth), std::cos(azimuth), 0.0);
    const Eigen::Vector3d along(std::cos(azimuth), std::sin(azimuth), 0.0);
    G.row(0) = v.transpose() / v.norm();
    G.row(1) = across.transpose();
    G.row(2) = -along.transpose() / v.z();
    return G;
}

/// Of the three rotations that make R, each turns about an axis that those before it have turned.
Eigen::Matrix3d turning_axes(const Station& station) {
    const Vector3<double> a(station.coordinates[3], station.coordinates[4], station.coordinates[5]);
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    if (station.angles == StationAngles::zyx) {
        axes.col(1) = rotation_z(a[2]).col(1);
        axes.col(0) = (rotation_z(a[2]) * rotation_y(a[1])).col(0);
    } else {
        axes.col(1) = rotation_x(a[0]).col(1);
        axes.col(2) = (rotation_x(a[0]) * rotation_y(a[1])).col(2);
    }
    return axes;
}

using Matrix6 = Eigen::Matrix<double, 6, 6>;

Eigen::SelfAdjointEigenSolver<Matrix6> correlation_of(const SensorSource& sensor) {
    Matrix6 R = Matrix6::Identity();
    for (const StationCorrelation& c : sensor.station_correlations()) {
        const auto i = static_cast<int>(c.first), j = static_cast<int>(c.second);
        R(i, j) = R(j, i) = c.coefficient;
    }
    return eigen_decomposition(R);
}

}  // namespace

StationGeometry::StationGeometry(const Station& station)
    : X_WS_(station.X_WS()), inverse_(X_WS_.inverse()), turning_axes_(turning_axes(station)) {}

Eigen::Matrix<double, 3, 6> StationGeometry::effect_on(const Eigen::Vector3d& p_W) const {
    const Eigen::Vector3d from_station = p_W - X_WS_.translation();
    Eigen::Matrix<double, 3, 6> K;
    K.leftCols<3>() = -X_WS_.linear().transpose();
    for (int i = 0; i < 3; ++i)
        K.col(3 + i) = X_WS_.linear().transpose() * from_station.cross(turning_axes_.col(i));
    return K;
}

bool FieldOfView::contains(const Eigen::Vector3d& v) const {
    constexpr double rounding = 1e-12;
    const double distance = v.norm();
    return distance >= nearest && distance <= farthest &&
           std::abs(std::atan2(v.y(), v.x())) <= azimuth + rounding &&
           std::abs(std::atan2(v.z(), v.head<2>().norm())) <= elevation + rounding;
}

bool FieldOfView::is_limited() const {
    const FieldOfView all;
    return farthest < all.farthest || azimuth < all.azimuth || elevation < all.elevation;
}

ReadingSensitivity reading_sensitivity(const StationGeometry& station, const Eigen::Vector3d& p_W,
                                       double azimuth) {
    const Eigen::Vector3d v = station.in_axes(p_W);
    const double rho = v.head<2>().norm(), d = v.norm();
    ReadingSensitivity s;
    s.overhead = rho < near_zenith * d;
    if (s.overhead) s.azimuth_scale = near_zenith * d;
    const Eigen::Matrix3d G = s.overhead ? overhead_gradients(v, azimuth) : reading_gradients(v);
    s.to_point = G * station.X_WS().linear().transpose();
    s.to_station = G * station.effect_on(p_W);
    return s;
}

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
