// Collects simple solids and lines of many items into one mesh each, so that a layer is one or two actors.
#pragma once

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>
#include <vector>

#include "viz/vtk/palette.h"

namespace covaria::detail {

/// Positions are given in W and stored relative to `origin` (single precision is then enough).
class Shapes {
public:
    explicit Shapes(const Eigen::Vector3d& origin) : origin_(origin) {}

    void sphere(const Eigen::Vector3d& centre, double radius, Colour colour);
    /// Image of the unit sphere; columns of `axes` are the semi-axes.
    void ellipsoid(const Eigen::Vector3d& centre, const Eigen::Matrix3d& axes, Colour colour, double opacity);
    void cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, Colour colour);
    /// Round base at `from`, tip at `to`.
    void cone(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, Colour colour);
    /// Shaft and tip; `radius` is that of the shaft.
    void arrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, Colour colour);
    /// Edges along the columns of R.
    void box(const Eigen::Vector3d& centre, const Eigen::Matrix3d& R, const Eigen::Vector3d& edges,
             Colour colour);
    /// Polygon extruded by half the thickness to either side.
    void prism(const std::vector<Eigen::Vector3d>& outline, const Eigen::Vector3d& normal, double thickness,
               Colour colour, double opacity);
    void polygon(const std::vector<Eigen::Vector3d>& corners, Colour colour, double opacity);
    void line(const std::vector<Eigen::Vector3d>& points, Colour colour, double opacity = 1.0);
    void dashes(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double dash, Colour colour);

    bool empty() const { return parts_ == 0; }
    /// One actor of everything collected, with soft shading (solids) or none (lines); null when empty.
    vtkSmartPointer<vtkActor> solid_actor() const;
    vtkSmartPointer<vtkActor> line_actor() const;

private:
    void add(vtkPolyData* unit_shape, const Eigen::Matrix3d& linear, const Eigen::Vector3d& centre,
             Colour colour, double opacity = 1.0);
    void add_coloured(vtkPolyData* shape, Colour colour, double opacity);
    vtkSmartPointer<vtkActor> actor() const;
    Eigen::Vector3d origin_;
    vtkNew<vtkAppendPolyData> append_;
    int parts_ = 0;
};

}  // namespace covaria::detail
