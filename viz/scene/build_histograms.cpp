// Histograms of a cloud's coordinates on three walls of its bounding box.
#include <algorithm>
#include <array>

#include "viz/scene/build_parts.h"

namespace covaria::detail {
namespace {

constexpr std::size_t cells = 31;
/// Each wall shows one coordinate: x on the wall across y with bars along z, and so on.
struct Wall {
    int axis, height, normal;
};
constexpr std::array<Wall, 3> walls{{{0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};

const SceneCloud* chosen_cloud(const SceneBuild& build) {
    const SceneCloud* first = nullptr;
    for (const SceneCloud& cloud : build.scene.clouds) {
        if (!build.options.histograms_of.empty()) {
            if (cloud.item.name == build.options.histograms_of) return &cloud;
        } else if (!first || (first->role != Role::output && cloud.role == Role::output)) {
            first = &cloud;
        }
    }
    return first;
}

SceneBounds box_of(const SceneCloud& cloud) {
    const Eigen::Map<const Eigen::Matrix3Xf> offsets(cloud.offsets.data(), 3,
                                                     static_cast<Eigen::Index>(cloud.size()));
    SceneBounds box{offsets.rowwise().minCoeff().cast<double>(), offsets.rowwise().maxCoeff().cast<double>()};
    // A flat cloud still gets walls to draw on; a margin keeps the outermost trials off them.
    const Eigen::Vector3d extent = box.high - box.low;
    const Eigen::Vector3d margin =
        (0.5 * (0.3 * extent.maxCoeff() - extent.array()).max(0.04 * extent.array()));
    box.low += cloud.item.position - margin;
    box.high += cloud.item.position + margin;
    return box;
}

std::vector<double> bars_of(const SceneCloud& cloud, int axis, double low, double high) {
    std::vector<double> bars(cells, 0.0);
    const double centre = cloud.item.position[axis];
    for (std::size_t i = static_cast<std::size_t>(axis); i < cloud.offsets.size(); i += 3) {
        const double place = (centre + static_cast<double>(cloud.offsets[i]) - low) / (high - low);
        const double cell = std::clamp(place * cells, 0.0, cells - 1.0);
        bars[static_cast<std::size_t>(cell)] += 1.0;
    }
    const double highest = *std::max_element(bars.begin(), bars.end());
    for (double& bar : bars) bar /= highest;
    return bars;
}

}  // namespace

void add_wall_histograms(SceneBuild& build) {
    const SceneCloud* cloud = build.options.wall_histograms ? chosen_cloud(build) : nullptr;
    if (!cloud || cloud->size() < 2 * cells) return;
    const SceneBounds box = box_of(*cloud);
    if (!((box.high - box.low).minCoeff() > 0)) return;
    for (const Wall& wall : walls) {
        SceneWallHistogram histogram;
        histogram.cloud = cloud->item.id;
        histogram.role = cloud->role;
        histogram.axis = wall.axis;
        histogram.height = wall.height;
        histogram.normal = wall.normal;
        histogram.low = box.low;
        histogram.high = box.high;
        histogram.bars = bars_of(*cloud, wall.axis, box.low[wall.axis], box.high[wall.axis]);
        build.scene.wall_histograms.push_back(std::move(histogram));
    }
}

}  // namespace covaria::detail
