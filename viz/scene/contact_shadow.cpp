#include "viz/scene/contact_shadow.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace covaria {
namespace {

constexpr std::size_t cells = 448;
constexpr double reach_of_floor = 1.05;  // part of the diagonal of the scene's floor plan, to each side

/// Bodies up to some height above the floor, of the scene's size, with how dark and how wide they are there.
struct Storey {
    double top, darkness, blur;
};
constexpr std::array<Storey, 3> storeys{{{0.02, 0.34, 0.007}, {0.12, 0.16, 0.022}, {0.6, 0.09, 0.07}}};

class Plan {
public:
    Plan(const ContactShadow& place, double floor, double size) : place_(place), floor_(floor), size_(size) {
        for (auto& storey : covered_) storey.assign(cells * cells, 0.0F);
    }

    void add(const Solid& solid) {
        if (solid.opacity < 1.0) return;
        if (solid.shape == Solid::Shape::prism) return add_prism(solid);
        if (solid.shape == Solid::Shape::box) return add_box(solid);
        const Eigen::Vector3d way = solid.to - solid.from;
        const double flat = std::hypot(way.x(), way.y());
        const int steps = 1 + static_cast<int>(std::min(400.0, std::max(flat, std::abs(way.z())) / cell()));
        for (int i = 0; i <= steps; ++i) {
            const double t = double(i) / steps;
            add_disc(solid.from + t * way, solid.from_radius + t * (solid.to_radius - solid.from_radius));
        }
    }

    std::vector<float> darkness() {
        std::vector<float> all(cells * cells, 0.0F);
        for (std::size_t k = 0; k < storeys.size(); ++k) {
            const int radius = std::max(1, static_cast<int>(std::lround(storeys[k].blur * size_ / cell())));
            for (int pass = 0; pass < 2; ++pass) blur(covered_[k], radius);
            for (std::size_t i = 0; i < all.size(); ++i)
                all[i] += (1.0F - all[i]) * static_cast<float>(storeys[k].darkness) * covered_[k][i];
        }
        return all;
    }

private:
    double cell() const { return 2 * place_.half / cells; }

    void mark(double x, double y, std::size_t storey) {
        const double i = (x - place_.middle.x() + place_.half) / cell(),
                     j = (y - place_.middle.y() + place_.half) / cell();
        if (!(i >= 0 && j >= 0 && i < cells && j < cells)) return;
        covered_[storey][static_cast<std::size_t>(j) * cells + static_cast<std::size_t>(i)] = 1.0F;
    }

    std::size_t storey_of(double z) const {
        std::size_t k = 0;
        while (k < storeys.size() && z - floor_ > storeys[k].top * size_) ++k;
        return k;
    }

    void add_disc(const Eigen::Vector3d& centre, double radius) {
        const std::size_t storey = storey_of(centre.z() - radius);
        if (storey >= storeys.size()) return;
        const double step = std::max(cell(), radius / 60);
        for (double x = -radius; x <= radius; x += step)
            for (double y = -radius; y <= radius; y += step)
                if (x * x + y * y <= radius * radius) mark(centre.x() + x, centre.y() + y, storey);
        mark(centre.x(), centre.y(), storey);
    }

    void add_box(const Solid& solid) {
        constexpr int parts = 6;
        for (int i = -parts; i <= parts; ++i)
            for (int j = -parts; j <= parts; ++j)
                for (const int k : {-1, 1}) {
                    const Eigen::Vector3d part = Eigen::Vector3d(i, j, k * parts) / (2.0 * parts);
                    add_disc(solid.from + solid.R * part.cwiseProduct(solid.edges),
                             solid.edges.minCoeff() / 8);
                }
    }

    /// A row of cells at a time: where it crosses the outline, it enters or leaves.
    void add_prism(const Solid& solid) {
        if (solid.outline.size() < 3) return;
        const std::size_t storey = storey_of(solid.from.z() - solid.thickness / 2);
        if (storey >= storeys.size()) return;
        const auto [low, high] =
            std::ranges::minmax(solid.outline, {}, [](const Eigen::Vector3d& corner) { return corner.y(); });
        const double step = std::max(cell(), (high.y() - low.y()) / double(cells));
        for (double y = low.y(); y <= high.y(); y += step) {
            std::vector<double> crossings;
            for (std::size_t i = 0; i < solid.outline.size(); ++i) {
                const Eigen::Vector3d &a = solid.outline[i],
                                      &b = solid.outline[(i + 1) % solid.outline.size()];
                if ((a.y() > y) != (b.y() > y))
                    crossings.push_back(a.x() + (y - a.y()) * (b.x() - a.x()) / (b.y() - a.y()));
            }
            std::ranges::sort(crossings);
            for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
                for (double x = crossings[i]; x <= crossings[i + 1]; x += cell()) mark(x, y, storey);
        }
    }

    /// The mean of neighbours along both directions, with running sums.
    static void blur(std::vector<float>& values, int radius) {
        std::vector<float> line(cells);
        const auto along = [&](std::size_t first, std::size_t step) {
            float sum = 0.0F;
            const int n = static_cast<int>(cells);
            const auto at = [&](int i) -> float {
                return i < 0 || i >= n ? 0.0F : values[first + static_cast<std::size_t>(i) * step];
            };
            for (int i = -radius; i <= radius; ++i) sum += at(i);
            for (int i = 0; i < n; ++i) {
                line[static_cast<std::size_t>(i)] = std::max(0.0F, sum / static_cast<float>(2 * radius + 1));
                sum += at(i + radius + 1) - at(i - radius);
            }
            for (std::size_t i = 0; i < cells; ++i) values[first + i * step] = line[i];
        };
        for (std::size_t row = 0; row < cells; ++row) along(row * cells, 1);
        for (std::size_t column = 0; column < cells; ++column) along(column, cells);
    }

    const ContactShadow& place_;
    double floor_, size_;
    std::array<std::vector<float>, storeys.size()> covered_;
};

}  // namespace

ContactShadow contact_shadow(const Scene& scene) {
    ContactShadow shadow;
    if (!scene.floor || !(scene.size > 0)) return shadow;
    const SceneBounds bounds = bounds_of(scene);
    const Eigen::Vector3d extent = bounds.high - bounds.low;
    shadow.middle = (bounds.low + bounds.high) / 2;
    shadow.middle.z() = *scene.floor;
    shadow.half = reach_of_floor * std::max(std::hypot(extent.x(), extent.y()), 0.5 * scene.size);
    if (!std::isfinite(shadow.half) || !(shadow.half > 0)) return shadow;
    shadow.cells = cells;
    Plan plan(shadow, *scene.floor, scene.size);
    for (const auto& solids : {solids_of_bodies(scene), solids_of_links(scene), solids_of_points(scene)})
        for (const Solid& solid : solids) plan.add(solid);
    shadow.darkness = plan.darkness();
    return shadow;
}

}  // namespace covaria
