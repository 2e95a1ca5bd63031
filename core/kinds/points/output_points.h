// Outputs of an analysis as measured points, for set-ups that ask for what measured their points.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/kinds/points/point_uncertainty.h"
#include "core/model/asset.h"
#include "core/model/output_quantity.h"

namespace covaria {

/// The measured points of an analysis: every group of outputs with lengths x, y and z is one of that name.
/// Its deviations are those of the outputs, so none are stated beside them.
class OutputPoints : public Asset, public PointUncertaintySource, public PointOutputSource {
public:
    OutputPoints(std::string analysis, const std::vector<OutputQuantity>& outputs);

    Axes axes() const override { return Axes::world; }
    std::vector<PointDeviation> deviations(const Eigen::Vector3d&) const override { return {}; }
    std::optional<OutputReference> coordinate(const std::string& point, std::size_t axis) const override;

private:
    std::string analysis_;
    std::set<std::string> points_;
};

}  // namespace covaria
