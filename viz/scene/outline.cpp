// Outlines of plates: normal, round corners.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "viz/scene/build_parts.h"

namespace covaria::detail {
namespace {

constexpr int corner_steps = 12;

bool is_convex(const std::vector<Eigen::Vector3d>& outline, const Eigen::Vector3d& normal) {
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector3d a = outline[(i + 1) % n] - outline[i];
        const Eigen::Vector3d b = outline[(i + 2) % n] - outline[(i + 1) % n];
        if (a.cross(b).dot(normal) <= 1e-9 * a.norm() * b.norm()) return false;
    }
    return true;
}

Eigen::Vector3d newell_sum(const std::vector<Eigen::Vector3d>& outline) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < outline.size(); ++i)
        sum += (outline[i] - outline[0]).cross(outline[(i + 1) % outline.size()] - outline[0]);
    return sum;
}

}  // namespace

Eigen::Vector3d normal_of(const std::vector<Eigen::Vector3d>& outline) {
    const Eigen::Vector3d sum = outline.empty() ? Eigen::Vector3d::Zero().eval() : newell_sum(outline);
    if (!(sum.norm() > 0)) return Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d n = sum.normalized();
    for (int i = 2; i >= 0; --i)
        if (std::abs(n[i]) > 1e-9) return n[i] > 0 ? n : Eigen::Vector3d(-n);
    return n;
}

std::vector<Eigen::Vector3d> rounded_outline(const std::vector<Eigen::Vector3d>& outline,
                                             const Eigen::Vector3d& normal, double distance) {
    if (outline.size() < 3 || !(newell_sum(outline).norm() > 0)) return outline;
    std::vector<Eigen::Vector3d> corners = outline;
    if (newell_sum(outline).dot(normal) < 0) corners.assign(outline.rbegin(), outline.rend());
    if (!is_convex(corners, normal)) return outline;
    std::vector<Eigen::Vector3d> rounded;
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector3d before = (corners[i] - corners[(i + n - 1) % n]).cross(normal).normalized();
        const Eigen::Vector3d after = (corners[(i + 1) % n] - corners[i]).cross(normal).normalized();
        const double angle = std::atan2(before.cross(after).dot(normal), before.dot(after));
        for (int step = 0; step <= corner_steps; ++step)
            rounded.push_back(corners[i] +
                              distance * (Eigen::AngleAxisd(angle * step / corner_steps, normal) * before));
    }
    return rounded;
}

}  // namespace covaria::detail
