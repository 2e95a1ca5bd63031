// Unit shapes from VTK's sources, transformed, coloured per vertex and appended.
#include "viz/vtk/shapes.h"

#include <vtkCellArray.h>
#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkLinearExtrusionFilter.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangleFilter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace covaria::detail {
namespace {

using Vector = Eigen::Vector3d;

vtkSmartPointer<vtkPolyData> with_normals(vtkPolyData* shape) {
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(shape);
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputConnection(triangles->GetOutputPort());
    normals->SetFeatureAngle(50);
    normals->Update();
    return normals->GetOutput();
}

template <class Source>
vtkSmartPointer<vtkPolyData> made_by(Source* source) {
    source->Update();
    return with_normals(source->GetOutput());
}

vtkPolyData* unit_sphere() {
    static const auto shape = [] {
        vtkNew<vtkSphereSource> source;
        source->SetRadius(1.0);
        source->SetThetaResolution(40);
        source->SetPhiResolution(24);
        source->Update();
        return vtkSmartPointer<vtkPolyData>(source->GetOutput());
    }();
    return shape;
}

/// From z = 0 to 1 with radius 1.
vtkPolyData* unit_cylinder() {
    static const auto shape = [] {
        vtkNew<vtkCylinderSource> source;
        source->SetResolution(28);
        source->SetRadius(1.0);
        source->SetHeight(1.0);
        vtkNew<vtkTransform> upright;
        upright->Translate(0, 0, 0.5);
        upright->RotateX(90);
        vtkNew<vtkTransformPolyDataFilter> turned;
        turned->SetInputConnection(source->GetOutputPort());
        turned->SetTransform(upright);
        return made_by(turned.Get());
    }();
    return shape;
}

/// Base at z = 0, tip at z = 1, radius 1.
vtkPolyData* unit_cone() {
    static const auto shape = [] {
        vtkNew<vtkConeSource> source;
        source->SetResolution(28);
        source->SetRadius(1.0);
        source->SetHeight(1.0);
        source->SetDirection(0, 0, 1);
        source->SetCenter(0, 0, 0.5);
        return made_by(source.Get());
    }();
    return shape;
}

vtkPolyData* unit_cube() {
    static const auto shape = [] {
        vtkNew<vtkCubeSource> source;
        return made_by(source.Get());
    }();
    return shape;
}

/// Columns: two directions across, and the way from `from` to `to`.
Eigen::Matrix3d along(const Vector& way, double radius) {
    const double length = way.norm();
    const Vector z = length > 0 ? Vector(way / length) : Vector::UnitZ();
    const Vector x = z.unitOrthogonal();
    Eigen::Matrix3d linear;
    linear << radius * x, radius * z.cross(x), length * z;
    return linear;
}

vtkSmartPointer<vtkPolyData> path(const std::vector<Vector>& points, const Vector& origin, bool closed_face) {
    vtkNew<vtkPoints> vertices;
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(static_cast<int>(points.size()));
    for (const Vector& p : points) {
        const Vector d = p - origin;
        cells->InsertCellPoint(vertices->InsertNextPoint(d.data()));
    }
    auto shape = vtkSmartPointer<vtkPolyData>::New();
    shape->SetPoints(vertices);
    if (closed_face)
        shape->SetPolys(cells);
    else
        shape->SetLines(cells);
    return shape;
}

}  // namespace

void Shapes::add_coloured(vtkPolyData* shape, Colour colour, double opacity) {
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetName("colour");
    colours->SetNumberOfComponents(4);
    colours->SetNumberOfTuples(shape->GetNumberOfPoints());
    const double values[4] = {double(colour.red), double(colour.green), double(colour.blue), 255 * opacity};
    for (int i = 0; i < 4; ++i) colours->FillComponent(i, values[i]);
    vtkNew<vtkPolyData> coloured;
    coloured->ShallowCopy(shape);
    coloured->GetPointData()->SetTCoords(nullptr);
    coloured->GetPointData()->SetScalars(colours);
    append_->AddInputData(coloured);
    ++parts_;
}

void Shapes::add(vtkPolyData* unit_shape, const Eigen::Matrix3d& linear, const Vector& centre, Colour colour,
                 double opacity) {
    const Vector at = centre - origin_;
    vtkNew<vtkMatrix4x4> matrix;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) matrix->SetElement(i, j, linear(i, j));
        matrix->SetElement(i, 3, at[i]);
    }
    vtkNew<vtkTransform> transform;
    transform->SetMatrix(matrix);
    vtkNew<vtkTransformPolyDataFilter> moved;
    moved->SetInputData(unit_shape);
    moved->SetTransform(transform);
    moved->Update();
    add_coloured(moved->GetOutput(), colour, opacity);
}

void Shapes::sphere(const Vector& centre, double radius, Colour colour) {
    add(unit_sphere(), radius * Eigen::Matrix3d::Identity(), centre, colour);
}

void Shapes::ellipsoid(const Vector& centre, const Eigen::Matrix3d& axes, Colour colour, double opacity) {
    Eigen::Matrix3d linear = axes;
    if (linear.determinant() < 0) linear.col(2) = -linear.col(2);  // keeps the outside outside
    add(unit_sphere(), linear, centre, colour, opacity);
}

void Shapes::cylinder(const Vector& from, const Vector& to, double radius, Colour colour) {
    if (!((to - from).norm() > 0)) return;
    add(unit_cylinder(), along(to - from, radius), from, colour);
}

void Shapes::cone(const Vector& from, const Vector& to, double radius, Colour colour) {
    if (!((to - from).norm() > 0)) return;
    add(unit_cone(), along(to - from, radius), from, colour);
}

void Shapes::arrow(const Vector& from, const Vector& to, double radius, Colour colour) {
    const Vector way = to - from;
    const double tip = std::min(7.0 * radius, 0.4 * way.norm());
    const Vector neck = to - way.normalized() * tip;
    cylinder(from, neck, radius, colour);
    cone(neck, to, 2.6 * radius, colour);
}

void Shapes::box(const Vector& centre, const Eigen::Matrix3d& R, const Vector& edges, Colour colour) {
    add(unit_cube(), R * edges.asDiagonal(), centre, colour);
}

void Shapes::prism(const std::vector<Vector>& outline, const Vector& normal, double thickness, Colour colour,
                   double opacity) {
    std::vector<Vector> lower = outline;
    for (Vector& corner : lower) corner -= thickness / 2 * normal;
    vtkNew<vtkLinearExtrusionFilter> extrusion;
    extrusion->SetInputData(path(lower, origin_, true));
    extrusion->SetExtrusionTypeToVectorExtrusion();
    extrusion->SetVector(normal.x(), normal.y(), normal.z());
    extrusion->SetScaleFactor(thickness);
    extrusion->Update();
    add_coloured(with_normals(extrusion->GetOutput()), colour, opacity);
}

void Shapes::polygon(const std::vector<Vector>& corners, Colour colour, double opacity) {
    add_coloured(path(corners, origin_, true), colour, opacity);
}

void Shapes::line(const std::vector<Vector>& points, Colour colour, double opacity) {
    add_coloured(path(points, origin_, false), colour, opacity);
}

void Shapes::dashes(const Vector& from, const Vector& to, double dash, Colour colour) {
    const Vector way = to - from;
    const double length = way.norm();
    // A dash and a gap of the same length; a whole number of dashes, beginning and ending with one.
    const int count = dash > 0 ? std::clamp(static_cast<int>(length / (2 * dash)), 1, 400) : 1;
    const double period = 1.0 / (2 * count - 1);
    for (int i = 0; i < count; ++i)
        line({from + 2 * i * period * way, from + (2 * i + 1) * period * way}, colour);
}

vtkSmartPointer<vtkActor> Shapes::actor() const {
    if (empty()) return nullptr;
    append_->Update();
    vtkNew<vtkPolyData> mesh;
    mesh->ShallowCopy(append_->GetOutput());
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    mapper->SetStatic(true);
    auto made = vtkSmartPointer<vtkActor>::New();
    made->SetMapper(mapper);
    return made;
}

vtkSmartPointer<vtkActor> Shapes::solid_actor() const {
    auto made = actor();
    if (!made) return made;
    vtkProperty* property = made->GetProperty();
    property->SetAmbient(0.38);
    property->SetDiffuse(0.66);
    property->SetSpecular(0.12);
    property->SetSpecularPower(24);
    return made;
}

vtkSmartPointer<vtkActor> Shapes::line_actor() const {
    auto made = actor();
    if (made) made->GetProperty()->LightingOff();
    return made;
}

}  // namespace covaria::detail
