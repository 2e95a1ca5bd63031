// Bodies as a few simple solids, made from their figures: plain data, for whoever draws them, keeps words off
// them or asks how far they reach.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "viz/scene/scene.h"

namespace covaria {

/// The look of a surface; the palette of viz/vtk gives each a colour for either theme.
enum class Material { robot, joint, instrument, dark, leg, plate, part, nest, lens, support };

struct Solid {
    enum class Shape {
        frustum,  ///< round, from `from` to `to`; with a bevel of its radius at both ends a ball or a capsule
        box,      ///< about `from`, edges along the columns of R
        prism     ///< `outline` extruded by half of the thickness to either side along the normal
    };
    Shape shape = Shape::frustum;
    Material material = Material::part;
    Eigen::Vector3d from = Eigen::Vector3d::Zero();
    Eigen::Vector3d to = Eigen::Vector3d::Zero();
    double from_radius = 0.0, to_radius = 0.0;  ///< m
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    Eigen::Vector3d edges = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3d> outline = {};
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double thickness = 0.0;
    double bevel = 0.0;    ///< radius of its rounded edges, m
    double opacity = 1.0;  ///< below 1: no body, but what it encloses
    bool operator==(const Solid&) const = default;
};

/// Solids of a scene's bodies: instruments on their tripods, plates on their feet.
std::vector<Solid> solids_of_bodies(const Scene& scene);
/// Solids of arms with their joints, legs, bars; nothing of what is only a line.
std::vector<Solid> solids_of_links(const Scene& scene);
/// Solids of balls in their seats, flanges, supports; nothing at an instrument's own station.
std::vector<Solid> solids_of_points(const Scene& scene);

/// Height down to which standing instruments, plates and arms reach: the floor lies there.
double lowest_of(const Scene& scene);
/// Height down to which the drawn ellipsoids and clouds reach; infinite without any.
double lowest_uncertainty_of(const Scene& scene);

}  // namespace covaria
