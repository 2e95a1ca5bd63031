#include "core/model/sensor.h"

namespace covaria {

Eigen::Isometry3d Station::X_WS() const {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.translation() = Eigen::Vector3d(coordinates[0], coordinates[1], coordinates[2]);
    X.linear() =
        station_rotation<double>(angles, Vector3<double>(coordinates[3], coordinates[4], coordinates[5]));
    return X;
}

}  // namespace covaria
