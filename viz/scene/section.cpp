#include "viz/scene/section.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text/round_numbers.h"

namespace covaria {
namespace {

/// Length along the axis of the section by which an ellipsoid reaches to either side of its centre.
double half_along(const SceneEllipsoid& ellipsoid, int axis) {
    return ellipsoid.axes.row(axis).norm();
}

/// Half of what a body has along the axis of the section, and the place that is deepest in what is left.
double least_depth(const SceneBody& body, const SectionPlane& section) {
    if (body.outline.empty()) return section.depth_of(body.item.position) - body.size / 2;
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& corner : body.outline) least = std::min(least, section.depth_of(corner));
    return least - std::abs(body.normal[section.axis]) * body.thickness / 2;
}

void cut(SceneCloud& cloud, const SectionPlane& section) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        if (section.hides(cloud.dot(i))) continue;
        std::copy_n(&cloud.offsets[3 * i], 3, &cloud.offsets[3 * kept]);
        if (i < cloud.trials.size()) cloud.trials[kept] = cloud.trials[i];
        ++kept;
    }
    cloud.offsets.resize(3 * kept);
    cloud.trials.resize(std::min(kept, cloud.trials.size()));
}

}  // namespace

double SectionSteps::at(int i) const {
    // A multiple of the step: 0.3, not the sum of three times 0.1.
    return (std::round(first / step) + i) * step;
}

int SectionSteps::nearest(double position) const {
    return static_cast<int>(std::lround(std::clamp((position - first) / step, 0.0, double(count))));
}

SectionSteps steps_of_section(const Scene& scene, int axis) {
    constexpr double fewest = 500.0;
    const SceneBounds bounds = bounds_of_items(scene);
    const double low = bounds.low[axis], high = bounds.high[axis], per_metre = scene.unit.per_metre;
    SectionSteps steps;
    if (!(high > low)) return {steps.step, low, 0};
    // Far from the origin a smaller step would be none.
    const double step = std::max((high - low) / fewest, 8.0 * resolution_at(std::max(-low, high)));
    steps.step = round_number_below(step * per_metre) / per_metre;
    steps.first = std::floor(low / steps.step) * steps.step;
    steps.count = static_cast<int>(std::ceil((high - steps.first) / steps.step));
    return steps;
}

SectionPlane middle_section(const Scene& scene, int axis, const Camera& camera) {
    const SceneBounds bounds = scene.focus ? *scene.focus : bounds_of_items(scene);
    return {axis, (bounds.low[axis] + bounds.high[axis]) / 2, camera.direction[axis] <= 0.0};
}

bool is_cut_away(const Scene& scene, const Eigen::Vector3d& p_W) {
    return scene.section && scene.section->hides(p_W);
}

std::optional<std::array<Eigen::Vector3d, 2>> left_of_line(const Scene& scene, const Eigen::Vector3d& from,
                                                           const Eigen::Vector3d& to) {
    if (!scene.section) return std::array{from, to};
    const double begin = scene.section->depth_of(from), end = scene.section->depth_of(to);
    if (begin > 0.0 && end > 0.0) return std::nullopt;
    std::array<Eigen::Vector3d, 2> left{from, to};
    if (begin > 0.0 || end > 0.0) left[begin > 0.0 ? 0 : 1] = from + begin / (begin - end) * (to - from);
    return left;
}

Scene left_by_section(Scene scene) {
    if (!scene.section) return scene;
    const SectionPlane section = *scene.section;
    const auto erase_cut = [&](auto& items) {
        std::erase_if(items, [&](const auto& each) { return section.hides(each.item.position); });
    };
    erase_cut(scene.frames);
    erase_cut(scene.points);
    std::erase_if(scene.bodies, [&](const SceneBody& body) { return least_depth(body, section) > 0.0; });
    std::erase_if(scene.links, [&](SceneLink& link) {
        const auto left = left_of_line(scene, link.from, link.to);
        if (!left) return true;
        link.from = (*left)[0];
        link.to = (*left)[1];
        return false;
    });
    std::erase_if(scene.vectors, [&](SceneVector& vector) {
        const Eigen::Vector3d tip = vector.item.position + vector.arrow;
        const auto left = left_of_line(scene, vector.item.position, tip);
        if (!left) return true;
        vector.item.position = (*left)[0];
        vector.arrow = (*left)[1] - (*left)[0];
        return false;
    });
    for (auto* ellipsoids : {&scene.ellipsoids, &scene.ellipsoids_before})
        std::erase_if(*ellipsoids, [&](const SceneEllipsoid& each) {
            return section.depth_of(each.item.position) > half_along(each, section.axis);
        });
    for (SceneCloud& cloud : scene.clouds) cut(cloud, section);
    std::erase_if(scene.labels, [&](const SceneLabel& label) { return section.hides(label.at); });
    std::erase_if(scene.not_met, [&](const SceneVerdict& mark) { return section.hides(mark.at); });
    return scene;
}

}  // namespace covaria
