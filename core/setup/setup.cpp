#include "core/setup/setup.h"

namespace covaria {

Eigen::Isometry3d PoseValue::si() const {
    const auto angle = [&](std::size_t i, const Eigen::Vector3d& axis) {
        return Eigen::AngleAxisd(angle_unit.to_si(angles[i]), axis);
    };
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = (angle(2, Eigen::Vector3d::UnitZ()) * angle(1, Eigen::Vector3d::UnitY()) *
                     angle(0, Eigen::Vector3d::UnitX()))
                        .toRotationMatrix();
    for (int i = 0; i < 3; ++i)
        pose.translation()[i] = length_unit.to_si(position[static_cast<std::size_t>(i)]);
    return pose;
}

std::array<double, 6> PoseValue::coordinates_si() const {
    std::array<double, 6> si{};
    for (std::size_t i = 0; i < 3; ++i) {
        si[i] = length_unit.to_si(position[i]);
        si[i + 3] = angle_unit.to_si(angles[i]);
    }
    return si;
}

}  // namespace covaria
