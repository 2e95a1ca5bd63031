// Vertices, normals and colours of the solids, made without filters: a scene of a thousand targets is one
// mesh.
#include "viz/vtk/shapes.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolygon.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "viz/vtk/shading.h"

namespace covaria::detail {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int steps_round = 40, steps_round_coarse = 16;
constexpr int steps_edge = 4;  // steps of a rounded edge
constexpr double sharp =
    0.64;  // cosine between neighbouring sides of a prism, below which their edge is seen

struct Across {
    Eigen::Vector3d x, y;
};
Across across(const Eigen::Vector3d& axis) {
    const Eigen::Vector3d x = axis.unitOrthogonal();
    return {x, axis.cross(x)};
}

}  // namespace

std::uint32_t Shapes::vertex(const Vector& at, const Vector& normal) {
    for (int i = 0; i < 3; ++i) {
        at_.push_back(static_cast<float>(at[i] - origin_[i]));
        normals_.push_back(static_cast<float>(normal[i]));
    }
    inks_.push_back(ink_);
    return static_cast<std::uint32_t>(inks_.size() - 1);
}

void Shapes::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    triangles_.insert(triangles_.end(), {a, b, c});
}

void Shapes::turned(const std::vector<Profile>& profile, const Vector& from, const Vector& axis) {
    const int steps = coarse_ ? steps_round_coarse : steps_round;
    const auto [x, y] = across(axis);
    std::uint32_t before = 0;
    for (std::size_t row = 0; row < profile.size(); ++row) {
        const Profile& p = profile[row];
        std::uint32_t first = 0;
        for (int i = 0; i <= steps; ++i) {
            const double angle = 2 * pi * i / steps;
            const Vector out = std::cos(angle) * x + std::sin(angle) * y;
            const std::uint32_t made =
                vertex(from + p.radius * out + p.along * axis, (p.out * out + p.up * axis).normalized());
            if (i == 0) first = made;
        }
        if (row > 0)
            for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(steps); ++i) {
                triangle(before + i, before + i + 1, first + i + 1);
                triangle(before + i, first + i + 1, first + i);
            }
        before = first;
    }
}

void Shapes::frustum(const Solid& solid) {
    const Vector way = solid.to - solid.from;
    const double length = way.norm();
    if (!(length > 0)) return;
    const double low = std::min({solid.bevel, solid.from_radius, length / 2}),
                 high = std::min({solid.bevel, solid.to_radius, length / 2});
    // The side leans by as much as it gets narrower.
    const double lean = std::atan2(solid.from_radius - solid.to_radius, std::max(1e-12, length - low - high));
    std::vector<Profile> profile{{0.0, 0.0, 0.0, -1.0}};
    if (solid.from_radius > low) profile.push_back({solid.from_radius - low, 0.0, 0.0, -1.0});
    const int fine = low >= 0.9 * solid.from_radius ? 3 * steps_edge : steps_edge;
    const int steps = coarse_ ? (fine + 2) / 3 : fine;
    for (int i = 0; i <= steps; ++i) {
        const double angle = -pi / 2 + (pi / 2 + lean) * i / steps;
        profile.push_back({solid.from_radius - low + low * std::cos(angle), low + low * std::sin(angle),
                           std::cos(angle), std::sin(angle)});
    }
    for (int i = 0; i <= steps; ++i) {
        const double angle = lean + (pi / 2 - lean) * i / steps;
        profile.push_back({solid.to_radius - high + high * std::cos(angle),
                           length - high + high * std::sin(angle), std::cos(angle), std::sin(angle)});
    }
    if (solid.to_radius > high) profile.push_back({solid.to_radius - high, length, 0.0, 1.0});
    profile.push_back({0.0, length, 0.0, 1.0});
    turned(profile, solid.from, way / length);
}

/// A ball whose eight parts are moved apart, with what lies between them.
void Shapes::rounded_box(const Solid& solid) {
    const Vector half = solid.edges / 2;
    const double bevel = std::min(solid.bevel, half.minCoeff());
    const Vector core = half - Vector::Constant(bevel);
    const int quarter = steps_edge + 1;
    std::uint32_t before = 0;
    const auto place = [&](const Vector& n, double sx, double sy, double sz) {
        const Vector at = bevel * n + Vector(sx * core.x(), sy * core.y(), sz * core.z());
        return vertex(solid.from + solid.R * at, solid.R * n);
    };
    std::vector<std::uint32_t> rings;
    for (int part = 0; part < 2; ++part)
        for (int i = 0; i < quarter; ++i) {
            const double up = part == 0 ? -1.0 : 1.0;
            const double height =
                pi / 2 * (part == 0 ? -1.0 + double(i) / steps_edge : double(i) / steps_edge);
            for (int side = 0; side < 4; ++side)
                for (int k = 0; k < quarter; ++k) {
                    const double angle = pi / 2 * (side + double(k) / steps_edge);
                    const Vector n(std::cos(height) * std::cos(angle), std::cos(height) * std::sin(angle),
                                   std::sin(height));
                    const double sx = side == 0 || side == 3 ? 1.0 : -1.0, sy = side < 2 ? 1.0 : -1.0;
                    const std::uint32_t made = place(n, sx, sy, up);
                    if (side == 0 && k == 0) rings.push_back(made);
                }
        }
    const auto count = static_cast<std::uint32_t>(4 * quarter);
    for (std::size_t ring = 1; ring < rings.size(); ++ring)
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t next = (i + 1) % count;
            before = rings[ring - 1];
            triangle(before + i, before + next, rings[ring] + next);
            triangle(before + i, rings[ring] + next, rings[ring] + i);
        }
    for (const bool top : {false, true}) {
        const std::uint32_t ring = top ? rings.back() : rings.front();
        for (std::uint32_t i = 1; i + 1 < count; ++i)
            top ? triangle(ring, ring + i, ring + i + 1) : triangle(ring, ring + i + 1, ring + i);
    }
}

void Shapes::cap(const std::vector<Vector>& outline, const Vector& normal) {
    vtkNew<vtkPolygon> polygon;
    std::vector<std::uint32_t> corners;
    for (const Vector& corner : outline) {
        const Vector d = corner - origin_;
        polygon->GetPointIds()->InsertNextId(polygon->GetPoints()->InsertNextPoint(d.data()));
        corners.push_back(vertex(corner, normal));
    }
    vtkNew<vtkIdList> ids;
    polygon->Triangulate(ids);
    for (vtkIdType i = 0; i + 2 < ids->GetNumberOfIds(); i += 3)
        triangle(corners[static_cast<std::size_t>(ids->GetId(i))],
                 corners[static_cast<std::size_t>(ids->GetId(i + 1))],
                 corners[static_cast<std::size_t>(ids->GetId(i + 2))]);
}

void Shapes::prism(const Solid& solid) {
    const std::size_t n = solid.outline.size();
    if (n < 3) return;
    Vector sum = Vector::Zero();
    for (std::size_t i = 0; i < n; ++i)
        sum += (solid.outline[i] - solid.outline[0]).cross(solid.outline[(i + 1) % n] - solid.outline[0]);
    const double sense = sum.dot(solid.normal) < 0 ? -1.0 : 1.0;
    const auto out_of_side = [&](std::size_t i) {
        const Vector side = solid.outline[(i + 1) % n] - solid.outline[i % n];
        return Vector((sense * side.cross(solid.normal)).normalized());
    };
    std::vector<Vector> lower = solid.outline, upper = solid.outline;
    const Vector half = solid.thickness / 2 * solid.normal;
    for (std::size_t i = 0; i < n; ++i) {
        lower[i] -= half;
        upper[i] += half;
        const Vector normal = out_of_side(i), before = out_of_side(i + n - 1), after = out_of_side(i + 1);
        const auto smooth = [&](const Vector& other) {
            return other.dot(normal) > sharp ? Vector((normal + other).normalized()) : normal;
        };
        const Vector &a = solid.outline[i], &b = solid.outline[(i + 1) % n];
        const std::uint32_t first = vertex(a - half, smooth(before));
        vertex(b - half, smooth(after));
        vertex(b + half, smooth(after));
        vertex(a + half, smooth(before));
        triangle(first, first + 1, first + 2);
        triangle(first, first + 2, first + 3);
    }
    cap(lower, -solid.normal);
    cap(upper, solid.normal);
}

void Shapes::solid(const Solid& solid, Colour colour) {
    ink_ = {colour.red, colour.green, colour.blue,
            static_cast<std::uint8_t>(std::lround(255 * solid.opacity))};
    if (solid.shape == Solid::Shape::frustum) frustum(solid);
    if (solid.shape == Solid::Shape::box) rounded_box(solid);
    if (solid.shape == Solid::Shape::prism) prism(solid);
}

void Shapes::sphere(const Vector& centre, double radius, Colour colour) {
    ellipsoid(centre, radius * Eigen::Matrix3d::Identity(), colour, 1.0);
}

void Shapes::ellipsoid(const Vector& centre, const Eigen::Matrix3d& axes, Colour colour, double opacity) {
    ink_ = {colour.red, colour.green, colour.blue, static_cast<std::uint8_t>(std::lround(255 * opacity))};
    Eigen::Matrix3d linear = axes;
    if (linear.determinant() < 0) linear.col(2) = -linear.col(2);  // keeps the outside outside
    // The normal of the image of a ball is that of the ball under the transposed inverse.
    const Vector lengths = linear.colwise().norm();
    Eigen::Matrix3d of_normals = linear;
    for (int i = 0; i < 3; ++i) of_normals.col(i) /= std::max(1e-300, lengths[i] * lengths[i]);
    const int around = coarse_ ? 20 : 56, rows = coarse_ ? 12 : 32;
    for (int row = 0; row <= rows; ++row)
        for (int i = 0; i <= around; ++i) {
            const double height = pi * (double(row) / rows - 0.5), angle = 2 * pi * i / around;
            const Vector n(std::cos(height) * std::cos(angle), std::cos(height) * std::sin(angle),
                           std::sin(height));
            const std::uint32_t made = vertex(centre + linear * n, (of_normals * n).normalized());
            if (row == 0 || i == 0) continue;
            const std::uint32_t below = made - static_cast<std::uint32_t>(around) - 1;
            triangle(below - 1, below, made);
            triangle(below - 1, made, made - 1);
        }
}

void Shapes::cylinder(const Vector& from, const Vector& to, double radius, Colour colour) {
    Solid made;
    made.from = from;
    made.to = to;
    made.from_radius = made.to_radius = radius;
    solid(made, colour);
}

void Shapes::arrow(const Vector& from, const Vector& to, double radius, Colour colour) {
    const Vector way = to - from;
    const double tip = std::min(7.0 * radius, 0.4 * way.norm());
    const Vector neck = to - way.normalized() * tip;
    cylinder(from, neck, radius, colour);
    Solid cone;
    cone.from = neck;
    cone.to = to;
    cone.from_radius = 2.6 * radius;
    solid(cone, colour);
}

void Shapes::polygon(const std::vector<Vector>& corners, Colour colour, double opacity) {
    ink_ = {colour.red, colour.green, colour.blue, static_cast<std::uint8_t>(std::lround(255 * opacity))};
    cap(corners, (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized());
}

void Shapes::line(const std::vector<Vector>& points, Colour colour, double opacity) {
    ink_ = {colour.red, colour.green, colour.blue, static_cast<std::uint8_t>(std::lround(255 * opacity))};
    std::vector<std::uint32_t>& ids = lines_.emplace_back();
    for (const Vector& p : points) {
        ids.push_back(vertex(p, Vector::UnitZ()));
        for (int i = 0; i < 3; ++i) begins_.push_back(static_cast<float>(points.front()[i] - origin_[i]));
    }
}

vtkSmartPointer<vtkActor> Shapes::actor() const {
    if (empty()) return nullptr;
    const auto count = static_cast<vtkIdType>(inks_.size());
    const auto array = [count](const char* name, int parts, const void* values) {
        vtkNew<vtkFloatArray> made;
        made->SetName(name);
        made->SetNumberOfComponents(parts);
        made->SetNumberOfTuples(count);
        std::memcpy(made->GetPointer(0), values, sizeof(float) * std::size_t(parts) * std::size_t(count));
        return vtkSmartPointer<vtkFloatArray>(made);
    };
    vtkNew<vtkPoints> points;
    points->SetData(array("points", 3, at_.data()));
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetName("colour");
    colours->SetNumberOfComponents(4);
    colours->SetNumberOfTuples(count);
    std::memcpy(colours->GetPointer(0), inks_.data(), 4 * inks_.size());
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->GetPointData()->SetScalars(colours);
    vtkNew<vtkCellArray> triangles, lines;
    for (std::size_t i = 0; i + 2 < triangles_.size(); i += 3)
        triangles->InsertNextCell(
            {vtkIdType(triangles_[i]), vtkIdType(triangles_[i + 1]), vtkIdType(triangles_[i + 2])});
    for (const auto& line : lines_) {
        lines->InsertNextCell(static_cast<int>(line.size()));
        for (const std::uint32_t id : line) lines->InsertCellPoint(id);
    }
    if (!triangles_.empty()) {
        mesh->SetPolys(triangles);
        mesh->GetPointData()->SetNormals(array("normals", 3, normals_.data()));
    }
    if (!lines_.empty()) mesh->SetLines(lines);
    if (begins_.size() == at_.size()) mesh->GetPointData()->AddArray(array("begin", 3, begins_.data()));
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    mapper->SetStatic(true);
    auto made = vtkSmartPointer<vtkActor>::New();
    made->SetMapper(mapper);
    return made;
}

vtkSmartPointer<vtkActor> Shapes::solid_actor() const {
    auto made = actor();
    if (made) shade(made, Surface::matt);
    return made;
}

vtkSmartPointer<vtkActor> Shapes::line_actor() const {
    auto made = actor();
    if (made) made->GetProperty()->LightingOff();
    return made;
}

vtkSmartPointer<vtkActor> Shapes::clear_actor() const {
    auto made = actor();
    if (!made) return made;
    made->ForceTranslucentOn();
    made->GetProperty()->BackfaceCullingOn();
    shade(made, Surface::clear);
    return made;
}

vtkSmartPointer<vtkActor> Shapes::dashed_actor() const {
    auto made = line_actor();
    if (made) shade(made, Surface::dashed);
    return made;
}

}  // namespace covaria::detail
