#include "core/kinds/ballbar/ballbar.h"

namespace covaria {

std::vector<Eigen::Vector3d> support_positions(const BallbarSource& ballbars) {
    std::vector<double> lengths, heights;
    for (const SupportLength& length : ballbars.support_lengths()) lengths.push_back(length.length);
    for (const SupportHeight& height : ballbars.heights()) heights.push_back(height.z);
    std::vector<Eigen::Vector3d> found(ballbars.supports());
    support_positions<double>(lengths, heights, found.data());
    return found;
}

}  // namespace covaria
