// Deviations of points measured together, where the source looks at each point by itself.
#include "core/kinds/points/point_uncertainty.h"

#include <map>
#include <utility>

namespace covaria {

std::vector<JointDeviation> PointUncertaintySource::joint_deviations(
    const std::vector<Eigen::Vector3d>& points) const {
    std::vector<JointDeviation> joint;
    std::map<std::string, std::size_t> common;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (PointDeviation& d : deviations(points[i])) {
            const auto [known, is_new] =
                d.common ? common.try_emplace(d.id, joint.size()) : std::pair(common.end(), true);
            const std::size_t index = d.common ? known->second : joint.size();
            if (is_new) {
                JointDeviation added{d.id, d.name, std::move(d.component), {}, {}, {}};
                added.estimate = d.estimate;
                if (!d.common) added.point = i;
                added.directions.assign(points.size(), Eigen::Vector3d::Zero());
                joint.push_back(std::move(added));
            }
            joint[index].directions[i] = d.direction;
        }
    return joint;
}

}  // namespace covaria
