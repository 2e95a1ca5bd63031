// Built-in conventions for stating an orientation.
#include "core/math/rotation_convention.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <exception>

namespace covaria {

namespace {

constexpr std::array zyx_angles{RotationCoordinate{"alpha", "rotation about x", "deg", true},
                                RotationCoordinate{"beta", "rotation about y", "deg", true},
                                RotationCoordinate{"gamma", "rotation about z", "deg", true}};
constexpr std::array zyz_angles{RotationCoordinate{"alpha", "first rotation, about z", "deg", true},
                                RotationCoordinate{"beta", "second rotation, about y", "deg", true},
                                RotationCoordinate{"gamma", "third rotation, about z", "deg", true}};
constexpr std::array vector_components{RotationCoordinate{"r_x", "rotation vector, x", "deg", false},
                                       RotationCoordinate{"r_y", "rotation vector, y", "deg", false},
                                       RotationCoordinate{"r_z", "rotation vector, z", "deg", false}};
constexpr std::array quaternion_components{RotationCoordinate{"q_0", "quaternion, scalar part", "1", false},
                                           RotationCoordinate{"q_x", "quaternion, x", "1", false},
                                           RotationCoordinate{"q_y", "quaternion, y", "1", false},
                                           RotationCoordinate{"q_z", "quaternion, z", "1", false}};

constexpr std::array conventions{
    RotationConventionInfo{RotationConvention::zyx, "zyx", "Z-Y-X angles (roll α, pitch β, yaw γ)",
                           "R = Rz(γ) Ry(β) Rx(α)", zyx_angles},
    RotationConventionInfo{RotationConvention::zyz, "zyz", "Z-Y-Z angles", "R = Rz(α) Ry(β) Rz(γ)",
                           zyz_angles},
    RotationConventionInfo{RotationConvention::rotation_vector, "rotation-vector", "rotation vector",
                           "r = angle times unit vector of the axis", vector_components},
    RotationConventionInfo{RotationConvention::quaternion, "quaternion", "unit quaternion",
                           "q = (cos θ/2, n sin θ/2) with q₀ ≥ 0", quaternion_components},
};

}  // namespace

std::span<const RotationConventionInfo> rotation_conventions() {
    return conventions;
}

const RotationConventionInfo& rotation_convention(RotationConvention convention) {
    return conventions[static_cast<std::size_t>(convention)];
}

RotationConvention rotation_convention_from(std::string_view key) {
    for (const RotationConventionInfo& info : conventions)
        if (info.key == key) return info.convention;
    std::fprintf(stderr, "covaria: there is no rotation convention '%.*s'\n", static_cast<int>(key.size()),
                 key.data());
    std::terminate();
}

double regularity(RotationConvention convention, const Matrix3<double>& R) {
    switch (convention) {
        case RotationConvention::zyx:
            return std::hypot(R(0, 0), R(1, 0));
        case RotationConvention::zyz:
            return std::hypot(R(0, 2), R(1, 2));
        case RotationConvention::rotation_vector:
        case RotationConvention::quaternion:
            break;
    }
    return std::sqrt(std::max(0.0, 1.0 + R.trace())) / 2.0;  // cos(angle/2)
}

}  // namespace covaria
