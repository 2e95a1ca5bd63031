// Rotation axes of a Comp3D network: targets that turn with something are on circles about its axis.
#pragma once

#include "core/readers/comp3d_flat_readings.h"

namespace covaria {

/// The circle of an axis with one target is put with what the network has: a point in its middle, a plane,
/// and equal distances to the target's positions. Several circles about one axis, and two axes that meet,
/// would need planes that are parallel and axes that are points: they are left out.
class Comp3dAxes {
public:
    Comp3dAxes(const Comp3dSurvey& survey, const Comp3dGround& ground, Comp3dSurveyReader& files,
               Comp3dFlatReadings& readings, NetworkEntry& entry)
        : survey_(survey), ground_(ground), files_(files), readings_(readings), entry_(entry) {}
    void take_all(Proposals& proposals);

private:
    struct Circle {
        Eigen::Vector3d middle;
        double radius = 0.0;
    };
    bool take(const Comp3dAxis& axis);
    std::optional<Circle> circle_of(const Comp3dAxis& axis) const;

    const Comp3dSurvey& survey_;
    const Comp3dGround& ground_;
    Comp3dSurveyReader& files_;
    Comp3dFlatReadings& readings_;
    NetworkEntry& entry_;
};

}  // namespace covaria
