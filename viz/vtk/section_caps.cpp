#include "viz/vtk/section_caps.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

#include "viz/vtk/shapes.h"

namespace covaria::detail {
namespace {

using Place = Eigen::Vector2d;  // in the plane
struct Segment {
    Place from, to;
    double at(double u) const {
        return from.y() + (u - from.x()) / (to.x() - from.x()) * (to.y() - from.y());
    }
};

/// False: nothing of the solid is in the plane.
bool may_be_in_plane(const Solid& solid, const SectionPlane& section) {
    double low = section.depth_of(solid.from), high = low;
    const auto add = [&](const Eigen::Vector3d& p, double reach) {
        low = std::min(low, section.depth_of(p) - reach);
        high = std::max(high, section.depth_of(p) + reach);
    };
    if (solid.shape == Solid::Shape::prism) {
        low = high = section.depth_of(solid.outline.front());
        for (const Eigen::Vector3d& corner : solid.outline) add(corner, solid.thickness / 2);
    } else {
        add(solid.from, solid.from_radius + solid.edges.norm() / 2);
        if (solid.shape == Solid::Shape::frustum) add(solid.to, solid.to_radius);
    }
    return low <= 0.0 && high >= 0.0;
}

/// Collects the faces and outlines of solids in one plane.
class Caps {
public:
    /// Faces are a little way into what is left, so that no corner of a solid is in their plane; lines are
    /// half of it before them.
    Caps(const SectionPlane& section, double inward, const Eigen::Vector3d& origin)
        : section_(section), origin_(origin), u_((section.axis + 1) % 3), v_((section.axis + 2) % 3) {
        const double way = section.hides_high ? -inward : inward;
        line_at_ = section.at + way / 2;
        section_.at += way;
    }

    void add(const Solid& solid) {
        Shapes shape(origin_);
        shape.solid(solid, {});
        const auto actor = shape.solid_actor();
        if (!actor) return;
        const std::vector<Segment> outline =
            outline_of(*vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput()));
        fill(outline);
        for (const Segment& segment : outline)
            lines_->InsertNextCell({vertex(segment.from, line_at_), vertex(segment.to, line_at_)});
    }

    std::vector<LayerActor> actors(ScenePalette palette) const {
        if (points_->GetNumberOfPoints() == 0) return {};
        return {{actor(faces_, true, inside_colour(palette))},
                {actor(lines_, false, colour_of(Role::body, palette)), 1.0}};
    }

private:
    Place place_of(const double* p) const { return {p[u_], p[v_]}; }

    /// The lines in which the triangles of a closed surface meet the plane.
    std::vector<Segment> outline_of(vtkPolyData& mesh) const {
        std::vector<Segment> outline;
        vtkNew<vtkIdList> corners;
        for (vtkIdType cell = 0; cell < mesh.GetPolys()->GetNumberOfCells(); ++cell) {
            mesh.GetPolys()->GetCellAtId(cell, corners);
            std::vector<Place> met;
            for (int i = 0; i < 3; ++i) {
                Eigen::Vector3d a, b;
                mesh.GetPoint(corners->GetId(i), a.data());
                mesh.GetPoint(corners->GetId((i + 1) % 3), b.data());
                const double da = section_.depth_of(a + origin_), db = section_.depth_of(b + origin_);
                if ((da > 0.0) == (db > 0.0)) continue;
                const Eigen::Vector3d p = a + da / (da - db) * (b - a);
                met.push_back(place_of(p.data()));
            }
            if (met.size() == 2) outline.push_back({met[0], met[1]});
        }
        return outline;
    }

    /// Fills what an odd number of lines is beside: in strips between neighbouring corners.
    void fill(const std::vector<Segment>& outline) {
        std::vector<double> at;
        for (const Segment& segment : outline) at.insert(at.end(), {segment.from.x(), segment.to.x()});
        std::ranges::sort(at);
        std::vector<const Segment*> met;
        for (std::size_t i = 1; i < at.size(); ++i) {
            const double low = at[i - 1], high = at[i], middle = (low + high) / 2;
            if (!(low < middle && middle < high)) continue;
            met.clear();
            for (const Segment& segment : outline)
                if ((segment.from.x() < middle) != (segment.to.x() < middle)) met.push_back(&segment);
            std::ranges::sort(met, {}, [&](const Segment* each) { return each->at(middle); });
            for (std::size_t k = 0; k + 1 < met.size(); k += 2) {
                const Segment &a = *met[k], &b = *met[k + 1];
                const auto corner = [&](double u, const Segment& side) {
                    return vertex({u, side.at(u)}, section_.at);
                };
                faces_->InsertNextCell({corner(low, a), corner(high, a), corner(high, b), corner(low, b)});
            }
        }
    }

    vtkIdType vertex(const Place& place, double at) {
        Eigen::Vector3d p;
        p[section_.axis] = at - origin_[section_.axis];
        p[u_] = place.x();
        p[v_] = place.y();
        return points_->InsertNextPoint(p.data());
    }

    vtkSmartPointer<vtkActor> actor(vtkCellArray* cells, bool are_faces, Colour colour) const {
        vtkNew<vtkPolyData> data;
        data->SetPoints(points_);
        are_faces ? data->SetPolys(cells) : data->SetLines(cells);
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(data);
        mapper->SetStatic(true);
        auto made = vtkSmartPointer<vtkActor>::New();
        made->SetMapper(mapper);
        made->GetProperty()->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
        made->GetProperty()->LightingOff();
        return made;
    }

    SectionPlane section_;
    Eigen::Vector3d origin_;
    int u_, v_;
    double line_at_ = 0.0;
    vtkNew<vtkPoints> points_;
    vtkNew<vtkCellArray> faces_, lines_;
};

}  // namespace

std::vector<LayerActor> cap_actors(const std::vector<Solid>& solids, const Scene& scene,
                                   const Eigen::Vector3d& origin, ScenePalette palette) {
    constexpr double inward = 1e-5;  // part of the scene's size
    if (!scene.section) return {};
    Caps caps(*scene.section, inward * scene.size, origin);
    for (const Solid& solid : solids)
        if (!(solid.opacity < 1.0) && may_be_in_plane(solid, *scene.section)) caps.add(solid);
    return caps.actors(palette);
}

}  // namespace covaria::detail
