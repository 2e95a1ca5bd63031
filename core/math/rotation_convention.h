// Ways to state an orientation in numbers: Euler angles, rotation vector, quaternion, as named data.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/unit.h"
#include "core/math/real.h"

namespace covaria {

enum class RotationConvention { zyx, zyz, rotation_vector, quaternion };

struct RotationCoordinate {
    std::string_view symbol;  ///< "alpha"
    std::string_view name;    ///< "rotation about x"
    std::string_view unit;    ///< unit for display
    bool periodic;            ///< an angle on the circle
};

struct RotationConventionInfo {
    RotationConvention convention;
    std::string_view key;                             ///< name in files: "zyx"
    std::string_view title;                           ///< name for people
    std::string_view equation;                        ///< R as a product, or the meaning of the numbers
    std::span<const RotationCoordinate> coordinates;  ///< three, or four of a quaternion
};

/// All conventions, in the order of RotationConvention.
std::span<const RotationConventionInfo> rotation_conventions();
const RotationConventionInfo& rotation_convention(RotationConvention convention);
/// The convention with this key; terminates if there is none (keys come from a checked choice).
RotationConvention rotation_convention_from(std::string_view key);

/// Distance of R from the nearest orientation at which the coordinates are undefined or jump: the sine of the
/// angle to gimbal lock (zyx: |cos beta|, zyz: sin beta), or of half the angle to a half turn. 0 = singular.
double regularity(RotationConvention convention, const Matrix3<double>& R);

}  // namespace covaria
