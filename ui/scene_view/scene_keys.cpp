#include "ui/scene_view/scene_keys.h"

#include <Qt>

namespace covaria::ui {

namespace {
constexpr double pixels_per_key = 30.0;
}

std::optional<StandardView> view_of_key(int key) {
    const int number = key - Qt::Key_1;
    if (number < 0 || number >= static_cast<int>(standard_view_count)) return {};
    return static_cast<StandardView>(number);
}

QPointF orbit_of_key(int key) {
    switch (key) {
        case Qt::Key_Left:
            return {-pixels_per_key, 0};
        case Qt::Key_Right:
            return {pixels_per_key, 0};
        case Qt::Key_Up:
            return {0, -pixels_per_key};
        case Qt::Key_Down:
            return {0, pixels_per_key};
        default:
            return {};
    }
}

}  // namespace covaria::ui
