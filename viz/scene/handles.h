// The handles by which the mouse moves and turns things of a scene, and the places where they go.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viz/scene/camera.h"
#include "viz/scene/scene.h"

namespace covaria {

/// An item whose position is written in a set-up can be moved by itself, and turned by the tips of its axes
/// where its field is a pose.
struct Handle {
    SceneItem item;
    std::optional<SceneFrame> frame = {};  ///< has axes by whose tips it turns; empty: it is moved
    int tip = 0;                           ///< the axis whose tip is grasped: 0 x, 1 y, 2 z
    int axis = -1;                         ///< field's axis along which alone it moves; -1: it moves freely
    bool turns() const { return frame.has_value(); }
};

/// The marks on an item that can be grasped: arrows along the axes of its field, and the tips of its own axes
/// that turn it.
struct HandleMarks {
    struct Arrow {
        int axis = 0;
        Pixel from, to;
    };
    std::vector<Arrow> arrows;
    std::vector<Pixel> tips;
};
/// `length` of an arrow in pixels; one that points at the eye is left out. Nothing for an item whose place
/// nobody can write.
HandleMarks handle_marks(const Scene& scene, const Camera& camera, PictureSize size, const std::string& item,
                         double length);
/// The handle that moves the item along the arrow at the pixel.
std::optional<Handle> arrow_at(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel,
                               const std::string& item, double length, double reach);
/// New place, in W, of an arrow's item when the pointer goes from one pixel to another.
Eigen::Vector3d moved_along(const Handle& arrow, const Camera& camera, PictureSize size, Pixel from,
                            Pixel to);

/// The handle under a pixel: tips of axes before items; `preferred`: the id of an item that is taken before
/// others within reach (the selected one).
std::optional<Handle> handle_at(const Scene& scene, const Camera& camera, PictureSize size, Pixel pixel,
                                const std::function<bool(Layer)>& shown, const std::string& preferred,
                                double reach);

/// Axis of its frame about which a tip turns: that of the other two which points most to or from the eye.
int turning_axis(const Handle& handle, const Camera& camera);

/// The turn in W, about the origin of the frame and that one of its other two axes that points most to or
/// from the eye, by which the tip follows the pointer; in whole steps of `step` (rad) where it is not 0.
Eigen::Matrix3d turn_by(const Handle& handle, const Camera& camera, PictureSize size, Pixel from, Pixel to,
                        double step);

/// Coordinates that a move changes, along the axes of the field, at whole steps (m).
Eigen::Vector3d snapped(const SceneItem& item, const Eigen::Vector3d& p_W, double step);

}  // namespace covaria
