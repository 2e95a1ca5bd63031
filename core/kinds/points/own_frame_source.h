// Deviations that are the same for every point, along the axes of the frame the points define.
#pragma once

#include <utility>
#include <vector>

#include "core/kinds/points/point_uncertainty.h"
#include "core/model/asset.h"

namespace covaria {

class OwnFrameSource : public PointUncertaintySource {
public:
    OwnFrameSource() = default;
    explicit OwnFrameSource(std::vector<PointDeviation> deviations) : deviations_(std::move(deviations)) {}
    Axes axes() const override { return Axes::own_frame; }
    std::vector<PointDeviation> deviations(const Eigen::Vector3d&) const override { return deviations_; }

private:
    std::vector<PointDeviation> deviations_;
};

}  // namespace covaria
