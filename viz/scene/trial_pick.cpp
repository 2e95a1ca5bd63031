#include "viz/scene/trial_pick.h"

#include <cmath>

#include "viz/scene/section.h"

namespace covaria {

std::optional<std::uint64_t> trial_at(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel,
                                      const std::function<bool(Layer)>& shown, double reach) {
    if (!shown(Layer::clouds)) return std::nullopt;
    std::optional<std::uint64_t> found;
    double nearest = reach;
    double depth = 0.0;
    for (const SceneCloud& cloud : scene.clouds)
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            const Eigen::Vector3d p_W = cloud.dot(i);
            const Pixel at = project(camera, size, p_W);
            const double distance = std::hypot(at.x - pixel.x, at.y - pixel.y);
            const double behind = p_W.dot(camera.direction);
            if (is_cut_away(scene, p_W) || distance > nearest ||
                (distance == nearest && found && behind >= depth))
                continue;
            nearest = distance;
            depth = behind;
            found = cloud.trials[i];
        }
    return found;
}

}  // namespace covaria
