// Collects simple solids and lines of many items into one mesh each, so that a layer is one or two actors.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "viz/scene/solids.h"
#include "viz/vtk/palette.h"

namespace covaria::detail {

/// Positions are given in W and stored relative to `origin` (single precision is then enough).
class Shapes {
public:
    explicit Shapes(const Eigen::Vector3d& origin) : origin_(origin) {}

    /// Rounds with fewer corners, where there are very many of them.
    void set_coarse(bool coarse) { coarse_ = coarse; }
    void solid(const Solid& solid, Colour colour);
    void sphere(const Eigen::Vector3d& centre, double radius, Colour colour);
    /// Image of the unit sphere; columns of `axes` are the semi-axes.
    void ellipsoid(const Eigen::Vector3d& centre, const Eigen::Matrix3d& axes, Colour colour, double opacity);
    void cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, Colour colour);
    /// Shaft and tip; `radius` is that of the shaft.
    void arrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, Colour colour);
    void polygon(const std::vector<Eigen::Vector3d>& corners, Colour colour, double opacity);
    void line(const std::vector<Eigen::Vector3d>& points, Colour colour, double opacity = 1.0);

    bool empty() const { return at_.empty(); }
    /// One actor of everything collected, shaded (solids) or not (lines); null when empty.
    vtkSmartPointer<vtkActor> solid_actor() const;
    vtkSmartPointer<vtkActor> line_actor() const;
    /// Actor of ellipsoids: seen through, denser at the rim.
    vtkSmartPointer<vtkActor> clear_actor() const;
    /// The same, with the place where each line begins as an array "begin": dashes are counted from there.
    vtkSmartPointer<vtkActor> dashed_actor() const;

private:
    using Vector = Eigen::Vector3d;
    struct Rgba {
        std::uint8_t red, green, blue, opacity;
    };
    /// Half of a section of a round solid: how far from its axis, how far along it, and its normal there.
    struct Profile {
        double radius, along, out, up;
    };

    std::uint32_t vertex(const Vector& at, const Vector& normal);
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    void turned(const std::vector<Profile>& profile, const Vector& from, const Vector& axis);
    void frustum(const Solid& solid);
    void rounded_box(const Solid& solid);
    void prism(const Solid& solid);
    void cap(const std::vector<Vector>& outline, const Vector& normal);
    vtkSmartPointer<vtkActor> actor() const;

    Vector origin_;
    bool coarse_ = false;
    Rgba ink_{0, 0, 0, 255};
    std::vector<float> at_, normals_, begins_;
    std::vector<Rgba> inks_;
    std::vector<std::uint32_t> triangles_;
    std::vector<std::vector<std::uint32_t>> lines_;
};

}  // namespace covaria::detail
