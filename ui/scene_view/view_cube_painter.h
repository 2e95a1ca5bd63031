// Paints the cube of the scene, and knows its place in the view.
#pragma once

#include <QPalette>
#include <QRectF>
#include <optional>
#include <vector>

#include "viz/scene/view_cube.h"

class QPainter;

namespace covaria::ui {

/// Place of the cube in a view of this size, in its pixels: top right. Empty: there is no room.
QRectF cube_place(QSize view);
/// The faces turned to the eye.
std::vector<CubeFace> cube_in(const QRectF& place, const Camera& camera);
/// `pointed`: the face under the pointer.
void paint_cube(QPainter& painter, const std::vector<CubeFace>& faces, std::optional<StandardView> pointed,
                const QPalette& palette);
/// "Top", of a standard view.
QString view_title(StandardView view);

}  // namespace covaria::ui
