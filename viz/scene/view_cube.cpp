#include "viz/scene/view_cube.h"

#include <Eigen/Geometry>

namespace covaria {
namespace {

constexpr double least_towards_eye = 0.06;  // below, a face is a line

constexpr std::array<StandardView, 6> faces_of_cube{StandardView::top,   StandardView::front,
                                                    StandardView::right, StandardView::bottom,
                                                    StandardView::back,  StandardView::left};

/// Whether the pixel is on the right of the way from a to b, as y grows downwards.
bool is_right_of(Pixel a, Pixel b, Pixel pixel) {
    return (b.x - a.x) * (pixel.y - a.y) - (b.y - a.y) * (pixel.x - a.x) >= 0;
}

}  // namespace

std::vector<CubeFace> view_cube(const Camera& camera, Pixel centre, double edge) {
    std::vector<CubeFace> faces;
    for (const StandardView view : faces_of_cube) {
        const ViewDirections looking = directions_of(view);
        const Eigen::Vector3d outwards = -looking.direction, up = looking.up,
                              right = looking.direction.cross(up);
        const double towards_eye = -outwards.dot(camera.direction);
        if (towards_eye < least_towards_eye) continue;
        CubeFace face{view, {}, towards_eye};
        static constexpr std::array<std::array<int, 2>, 4> signs{{{-1, 1}, {1, 1}, {1, -1}, {-1, -1}}};
        for (std::size_t i = 0; i < 4; ++i) {
            const Eigen::Vector3d corner = outwards + signs[i][0] * right + signs[i][1] * up;
            face.corners[i] = {centre.x + edge / 2 * corner.dot(camera.right()),
                               centre.y - edge / 2 * corner.dot(camera.up)};
        }
        faces.push_back(face);
    }
    return faces;
}

std::optional<StandardView> face_at(const std::vector<CubeFace>& faces, Pixel pixel) {
    for (const CubeFace& face : faces) {
        bool inside = true;
        for (std::size_t i = 0; i < 4; ++i)
            inside = inside && is_right_of(face.corners[i], face.corners[(i + 1) % 4], pixel);
        if (inside) return face.view;
    }
    return std::nullopt;
}

}  // namespace covaria
