// Layout of things, in metrology words: frames, points, bodies, links, sight lines. No colours, no drawing.
//
// Items carry `group` (the output group they belong to: "pose 7"; empty = belongs to all) and `source`, the
// JSON pointer of the set-up field they come from (relative to the set-up), so that picking or dragging them
// edits that field.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/name.h"
#include "core/model/triangle_mesh.h"

namespace covaria {

/// Place in a set-up where a position is written: a pose, or a row of a table with columns x, y, z.
struct LayoutSource {
    std::string path = {};  ///< "/base_points/rows/1"; empty = not from one field
    bool draggable = false;
    Eigen::Isometry3d X_WS = Eigen::Isometry3d::Identity();  ///< frame in which the field gives the position
    std::string asset = {};  ///< id of the asset whose set-up it is; empty = of the model or asset itself
};

struct LayoutFrame {
    Name name;  ///< "base b"
    Eigen::Isometry3d X_WF = Eigen::Isometry3d::Identity();
    Name group = {};
    LayoutSource source = {};
};

enum class PointKind { nest, target, support, ball, flange, tool, station, other };

struct LayoutPoint {
    Name name;  ///< "b1"
    PointKind kind = PointKind::other;
    Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
    Name group = {};
    LayoutSource source = {};
    /// The point is itself a set of input quantities (index of x, y, z, possibly in frame F) ...
    std::optional<std::array<std::size_t, 3>> inputs = {};
    /// ... or of output quantities; its uncertainty ellipsoid is then drawn from the result.
    std::optional<std::array<std::size_t, 3>> outputs = {};
    Eigen::Matrix3d R_WQ =
        Eigen::Matrix3d::Identity();  ///< axes in which those three coordinates are expressed
    /// Numbers of the links, where the inputs are taken from other analyses of a chain.
    std::optional<std::array<std::size_t, 3>> links = {};
};

enum class LinkKind { leg, robot_link, bar, joint_axis, sight_line, dimension, field_of_view, edge };

struct LayoutLink {
    Name name;
    LinkKind kind = LinkKind::edge;
    Eigen::Vector3d from_W = Eigen::Vector3d::Zero();
    Eigen::Vector3d to_W = Eigen::Vector3d::Zero();
    Name group = {};
    /// Whether a reading along the sight contradicts the others.
    bool is_doubtful = false;
};

enum class BodyKind { plate, artefact, instrument, force_sensor };

/// A flat or solid thing outlined by points ("the moving platform", "plate of the artefact"), or an
/// instrument glyph.
struct LayoutBody {
    Name name;
    BodyKind kind = BodyKind::plate;
    std::vector<Eigen::Vector3d> outline_W = {};  ///< polygon, in order; empty for glyphs
    double thickness = 0.0;                       ///< 0 = chosen by the picture
    Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
    std::string glyph = {};  ///< kind of instrument: "total-station", "tracker", "camera", "distance-meter"
    Name group = {};
    LayoutSource source = {};
};

enum class VectorKind { force, moment };

/// A quantity with direction (force, moment) at a point. Vectors of one kind are drawn to one scale.
struct LayoutVector {
    Name name;
    Eigen::Vector3d at_W = Eigen::Vector3d::Zero();
    Eigen::Vector3d vector_W = Eigen::Vector3d::Zero();  ///< N or N m
    Name group = {};
    VectorKind kind = VectorKind::force;
    bool is_measured = false;  ///< its label says how large it is
    /// Output quantities that are its three coordinates; their uncertainty is then drawn at the tip ...
    std::optional<std::array<std::size_t, 3>> outputs = {};
    Eigen::Matrix3d R_WQ = Eigen::Matrix3d::Identity();  ///< ... along these axes
};

enum class MeshColour { grey, blue, green, orange, red };

/// A surface for context: the cell, the part, the fixture. No number depends on it.
struct LayoutMesh {
    Name name;
    std::shared_ptr<const TriangleMesh> triangles = {};  ///< never null in a layout
    double scale = 1.0;                                  ///< m in one unit of the triangles
    Eigen::Isometry3d X_WM = Eigen::Isometry3d::Identity();
    MeshColour colour = MeshColour::grey;
    double opacity = 1.0;  ///< 0 ... 1
    LayoutSource source = {};
    /// Whether it looks the same: the same triangles are the same object.
    bool looks_like(const LayoutMesh& other) const;
};

struct Layout {
    std::vector<LayoutFrame> frames;
    std::vector<LayoutPoint> points;
    std::vector<LayoutLink> links;
    std::vector<LayoutBody> bodies;
    std::vector<LayoutVector> vectors;
    std::vector<LayoutMesh> meshes = {};
    std::vector<Message> notes = {};  ///< sentences to be shown beside a picture of it
    /// Number of points with an uncertainty, where only some of these name their quantities because all would
    /// hide the rest. 0: all of them name their quantities.
    std::size_t uncertain_points = 0;
};

/// The layout of an asset as part of another layout: what is written in its own set-up is marked with its id.
Layout as_part(Layout layout, const std::string& asset);

}  // namespace covaria
