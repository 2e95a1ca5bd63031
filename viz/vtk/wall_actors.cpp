// Actors that stand on the far walls of a box: the grid of the axes, the histograms of a cloud.
#include <vtkProperty.h>

#include "viz/vtk/layer_actors.h"
#include "viz/vtk/shapes.h"

namespace covaria::detail {
namespace {

using Vector = Eigen::Vector3d;

/// Corners of a rectangle in the plane across `normal`, at low[normal].
std::vector<Vector> rectangle(const Vector& low, const Vector& high, int normal) {
    const int a = (normal + 1) % 3, b = (normal + 2) % 3;
    std::vector<Vector> corners(4, low);
    corners[1][a] = corners[2][a] = high[a];
    corners[2][b] = corners[3][b] = high[b];
    return corners;
}

std::vector<Vector> closed(std::vector<Vector> corners) {
    corners.push_back(corners.front());
    return corners;
}

LayerActor wall(vtkSmartPointer<vtkActor> actor, double line_width, int normal, double shift) {
    LayerActor made{std::move(actor), line_width};
    made.wall_normal = normal;
    made.wall_shift = shift;
    return made;
}

void add_grid(const SceneAxes& axes, int normal, Shapes& lines, Colour colour) {
    for (int along : {(normal + 1) % 3, (normal + 2) % 3})
        for (const AxisTick& tick : axes.ticks[static_cast<std::size_t>(along)]) {
            Vector from = axes.low, to = axes.high;
            to[normal] = from[normal];
            from[along] = to[along] = tick.at;
            lines.line({from, to}, colour, 0.55);
        }
    lines.line(closed(rectangle(axes.low, axes.high, normal)), colour);
}

/// A bar of the histogram as a rectangle on the wall.
std::vector<Vector> bar(const SceneWallHistogram& h, std::size_t cell) {
    constexpr double highest = 0.62;  // part of the wall's height
    const double width = (h.high[h.axis] - h.low[h.axis]) / static_cast<double>(h.bars.size());
    Vector low = h.low, high = h.low;
    low[h.axis] += (static_cast<double>(cell) + 0.06) * width;
    high[h.axis] = low[h.axis] + 0.88 * width;
    high[h.height] += highest * h.bars[cell] * (h.high[h.height] - h.low[h.height]);
    return rectangle(low, high, h.normal);
}

}  // namespace

std::vector<LayerActor> axes_actors(const Scene& scene, const Vector& origin, ScenePalette palette) {
    std::vector<LayerActor> actors;
    if (!scene.axes) return actors;
    for (int normal = 0; normal < 3; ++normal) {
        Shapes lines(origin);
        add_grid(*scene.axes, normal, lines, grid_colour(palette));
        const double shift = scene.axes->high[normal] - scene.axes->low[normal];
        actors.push_back(wall(lines.line_actor(), 1.0, normal, shift));
    }
    return actors;
}

std::vector<LayerActor> histogram_actors(const Scene& scene, const Vector& origin, ScenePalette palette) {
    std::vector<LayerActor> actors;
    for (const SceneWallHistogram& histogram : scene.wall_histograms) {
        Shapes bars(origin), frame(origin);
        const Colour colour = colour_of(histogram.role, palette);
        for (std::size_t cell = 0; cell < histogram.bars.size(); ++cell)
            if (histogram.bars[cell] > 0) bars.polygon(bar(histogram, cell), colour, 0.72);
        frame.line(closed(rectangle(histogram.low, histogram.high, histogram.normal)), colour, 0.5);
        const double shift = histogram.high[histogram.normal] - histogram.low[histogram.normal];
        if (auto actor = bars.line_actor()) {
            actor->ForceTranslucentOn();
            actors.push_back(wall(actor, 0.0, histogram.normal, shift));
        }
        actors.push_back(wall(frame.line_actor(), 1.0, histogram.normal, shift));
    }
    return actors;
}

}  // namespace covaria::detail
