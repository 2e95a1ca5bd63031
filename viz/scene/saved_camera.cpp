#include "viz/scene/saved_camera.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace covaria {
namespace {

SavedView::Vector saved(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

Eigen::Vector3d vector_of(const SavedView::Vector& v) {
    return {v[0], v[1], v[2]};
}

double width_over_height(PictureSize size) {
    return static_cast<double>(std::max(1, size.width)) / std::max(1, size.height);
}

}  // namespace

SavedView saved_view(const std::string& name, const Camera& camera, PictureSize size,
                     const Visibility& visibility) {
    SavedView view;
    view.name = name;
    view.direction = saved(camera.direction);
    view.up = saved(camera.up);
    view.centre = saved(camera.focal_point);
    view.height = 2 * camera.half_height;
    view.width = view.height * width_over_height(size);
    view.perspective = camera.perspective;
    view.hidden.assign(visibility.hidden.begin(), visibility.hidden.end());
    view.only = visibility.only;
    return view;
}

Camera camera_of(const SavedView& view, PictureSize size) {
    Camera camera;
    camera.focal_point = vector_of(view.centre);
    camera.direction = vector_of(view.direction).normalized();
    const Eigen::Vector3d up = vector_of(view.up);
    camera.up = (up - up.dot(camera.direction) * camera.direction).normalized();
    camera.half_height = std::max(view.height, view.width / width_over_height(size)) / 2;
    camera.perspective = view.perspective;
    return camera;
}

Visibility visibility_of(const SavedView& view) {
    return {{view.hidden.begin(), view.hidden.end()}, view.only};
}

}  // namespace covaria
