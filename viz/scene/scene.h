// The things to draw, as plain data: no VTK, no Qt. Lengths in metres, in the world frame W; roles instead
// of colours.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/model/layout.h"
#include "core/result/joint_covariance.h"
#include "core/text/numbers.h"
#include "core/text/text.h"
#include "viz/scene/section_plane.h"

namespace covaria {

/// The meaning of a mark; the palette of viz/vtk gives each role a colour on a light and on a dark ground.
enum class Role {
    axis_x,
    axis_y,
    axis_z,
    point,
    input,   ///< uncertainty of input quantities
    output,  ///< uncertainty of output quantities
    before,  ///< uncertainty in the results that are compared with
    body,
    link,
    sight_line,
    instrument,
    vector,  ///< a force
    moment,
    not_met,  ///< a requirement
    text,
    quiet_text
};

/// A part of the picture that can be shown and hidden as a whole.
enum class Layer {
    frames,
    points,
    bodies,
    links,
    vectors,
    ellipsoids,
    clouds,
    wall_histograms,
    labels,
    axes,
    legend,
    map,
    ellipsoids_before,
    meshes
};
inline constexpr std::size_t layer_count = 14;
/// Key of a layer in settings and dumps: "wall_histograms".
const char* layer_key(Layer layer);

/// The facts about an item that a pick tells.
struct SceneItem {
    std::string id = {};  ///< unique in the scene: "point:b1", "link:leg 3"
    Name name = {};       ///< its name in the layout
    Name group = {};
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< in W, m
    /// Standard and expanded uncertainties of the three coordinates, m, along the axes in which the point's
    /// quantities are expressed; empty where nothing is known.
    std::optional<Eigen::Vector3d> u = {};
    std::optional<Eigen::Vector3d> U = {};
    /// Coordinates that the results state, m, where that is in another frame (Scene::notes).
    std::optional<Eigen::Vector3d> stated = {};
    LayoutSource source = {};  ///< the set-up field it comes from
    std::string body = {};     ///< id of the body that it stands on or starts from
    bool operator==(const SceneItem& other) const;
};

struct SceneFrame {
    SceneItem item;
    Eigen::Matrix3d R_WF = Eigen::Matrix3d::Identity();
    double length = 0.0;  ///< length of the arrows, m
    bool operator==(const SceneFrame&) const = default;
};

struct ScenePoint {
    SceneItem item;
    PointKind kind = PointKind::other;
    double radius = 0.0;                               ///< m
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();   ///< seat's axis: the normal of the plate it sits on
    std::optional<PointCoordinates> coordinates = {};  ///< its quantities, in the result of the scene
    bool operator==(const ScenePoint&) const = default;
};

/// A plate (outline extruded along its normal, half to either side) or, without outline, an instrument.
struct SceneBody {
    SceneItem item;
    BodyKind kind = BodyKind::plate;
    std::string glyph = {};  ///< LayoutBody's glyph; its +x axis is the line of sight
    std::vector<Eigen::Vector3d> outline = {};
    std::size_t corners = 0;  ///< corners of the outline before they were rounded
    bool encloses = false;    ///< a path, not a body: it is seen through
    double feet = 0.0;        ///< height of those that it stands on, m
    /// Direction in which the turning part of an instrument looks; zero: along its x axis.
    Eigen::Vector3d sight = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double thickness = 0.0;                              ///< m
    Eigen::Matrix3d R_WB = Eigen::Matrix3d::Identity();  ///< orientation of a glyph
    double size = 0.0;                                   ///< size of a glyph, m
    bool operator==(const SceneBody&) const = default;
};

struct SceneLink {
    SceneItem item;  ///< position: the middle
    LinkKind kind = LinkKind::edge;
    Eigen::Vector3d from = Eigen::Vector3d::Zero();
    Eigen::Vector3d to = Eigen::Vector3d::Zero();
    double radius = 0.0;       ///< radius of a tube, m; 0 = a thin line
    double end_radius = 0.0;   ///< at `to`, where it is another
    bool is_dashed = false;    ///< concerns a thin line
    bool is_doubtful = false;  ///< a sight that a reading along it contradicts
    bool stands = false;       ///< the first of an arm, on its foot
    double foot = 0.0;         ///< how far that reaches below `from`, m
    bool operator==(const SceneLink&) const = default;
};

/// An arrow from item.position; a moment has two heads.
struct SceneVector {
    SceneItem item;
    std::string label = {};  ///< "F 79.93 N": its name is the same whatever its length
    VectorKind kind = VectorKind::force;
    Eigen::Vector3d arrow = Eigen::Vector3d::Zero();  ///< the arrow that is drawn, m: scaled to the scene
    double radius = 0.0;
    bool operator==(const SceneVector&) const = default;
};

/// A surface for context, outside the box of the scene unless there is nothing else.
struct SceneMesh {
    SceneItem item;  ///< position: the middle of its box
    std::shared_ptr<const TriangleMesh> triangles = {};
    double scale = 1.0;  ///< m in one unit of the triangles
    Eigen::Isometry3d X_WM = Eigen::Isometry3d::Identity();
    MeshColour colour = MeshColour::grey;
    double opacity = 1.0;
    Eigen::Vector3d in_W(const Eigen::Vector3d& of_file) const { return X_WM * (scale * of_file); }
    bool operator==(const SceneMesh& other) const;  ///< the same triangles: the same object
};

/// { centre + axes * s, |s| <= 1 }: coverage region of a point, magnified.
struct SceneEllipsoid {
    SceneItem item;  ///< the point's item; position = centre
    Role role = Role::output;
    /// Semi-axes as columns, longest first, already magnified, m. A flat region has zero columns.
    Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
    int rank = 3;                  ///< 1 = a line, 2 = a disc
    double coverage_factor = 0.0;  ///< k_p from chi-squared with `rank` degrees of freedom
    bool operator==(const SceneEllipsoid&) const = default;
};

struct SceneCloud {
    SceneItem item;
    Role role = Role::output;
    std::vector<float> offsets = {};         ///< x y z of each trial from item.position, already magnified, m
    std::vector<std::uint32_t> trials = {};  ///< number of each, from 0
    std::size_t size() const { return offsets.size() / 3; }
    Eigen::Vector3d dot(std::size_t i) const {  ///< place in W of a dot
        return item.position + Eigen::Map<const Eigen::Vector3f>(offsets.data() + 3 * i).cast<double>();
    }
    bool operator==(const SceneCloud&) const = default;
};

/// Histogram of one coordinate of a cloud, on a wall of the cloud's bounding box.
struct SceneWallHistogram {
    std::string cloud;  ///< id of the cloud's item
    Role role = Role::output;
    int axis = 0;                                   ///< coordinate that is counted: 0 x, 1 y, 2 z
    int height = 2;                                 ///< direction of the bars
    int normal = 1;                                 ///< direction across the wall
    Eigen::Vector3d low = Eigen::Vector3d::Zero();  ///< corners of the box, magnified, m
    Eigen::Vector3d high = Eigen::Vector3d::Zero();
    std::vector<double> bars = {};  ///< heights, 0 ... 1, over equal cells from low[axis] to high[axis]
    bool operator==(const SceneWallHistogram&) const = default;
};

struct SceneLabel {
    Text text;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double clearance = 0.0;  ///< radius of what it must not cover, m
    Role role = Role::text;
    int priority = 0;         ///< higher is placed first; a label without room is left out
    std::string item = {};    ///< id of what it names; empty: no item
    Text fact = {};           ///< the line below the name: "U: 36, 51, 34 µm"
    bool when_asked = false;  ///< written only while its item is selected or pointed at
    bool operator==(const SceneLabel&) const = default;
};

struct AxisTick {
    double at = 0.0;  ///< m
    std::string text;
    bool operator==(const AxisTick&) const = default;
};

/// Axes on the edges of the box around everything drawn.
struct SceneAxes {
    Eigen::Vector3d low = Eigen::Vector3d::Zero();
    Eigen::Vector3d high = Eigen::Vector3d::Zero();
    std::array<std::string, 3> titles = {};  ///< "x / mm"
    std::array<std::vector<AxisTick>, 3> ticks = {};
    bool operator==(const SceneAxes&) const = default;
};

/// Unit of the lengths written in the picture.
struct LengthUnit {
    std::string text = "mm";
    double per_metre = 1000.0;
    bool operator==(const LengthUnit&) const = default;
};

/// Points of space coloured by a number: a map of a study, the candidates of a design. Positions and values
/// are in the order of its grid; a value that is not finite is left out.
struct SceneMap {
    std::string title = {};                       ///< title of the colour bar: "u(3D), B / mm"
    std::vector<Eigen::Vector3d> positions = {};  ///< m
    std::vector<double> values = {};              ///< in the unit that the title names
    std::vector<bool> shown = {};                 ///< drawn as points; others are left to the surfaces
    double radius = 0.0;                          ///< radius of a point, m
    double low = 0.0, high = 1.0;                 ///< ends of the colour scale
    std::vector<AxisTick> ticks = {};             ///< ticks of the colour bar, in the same unit
    std::array<std::size_t, 3> grid = {};  ///< sizes of a grid in space, the last fastest; 0: no surfaces
    std::vector<double> levels = {};       ///< levels of the iso-surfaces
    std::vector<bool> marked = {};         ///< drawn larger, with a ring; empty: none
    std::vector<std::array<std::size_t, 2>> ways = {};  ///< from a point to another, coloured as that one
    double way_radius = 0.0;                            ///< m
    bool operator==(const SceneMap& other) const;
};

/// A mark at a point, or the tip of a vector, whose quantities do not meet what is required of them.
struct SceneVerdict {
    std::string item = {};        ///< its id
    Layer layer = Layer::points;  ///< layer of the item
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double radius = 0.0;  ///< radius of the item there, m
    bool operator==(const SceneVerdict&) const = default;
};

/// A box in W, m.
struct SceneBounds {
    Eigen::Vector3d low = Eigen::Vector3d::Zero();
    Eigen::Vector3d high = Eigen::Vector3d::Zero();
    bool operator==(const SceneBounds&) const = default;
};
enum class LegendMark { none, ellipsoid, cloud, histogram, line, arrow, diamond };

struct LegendLine {
    LegendMark mark = LegendMark::none;
    Role role = Role::text;
    Text text;
    bool operator==(const LegendLine&) const = default;
};

struct Scene {
    std::string title = {};
    Name group = {};                      ///< the output group shown
    std::string group_title = {};         ///< the group's title for people
    std::vector<std::string> notes = {};  ///< below the titles: of the layout, and what is not drawn
    std::string caption = {};             ///< "ellipsoids 95 %, × 4 000": whenever uncertainty is drawn
    double magnification = 1.0;
    double probability = 0.95;
    double size = 0.0;       ///< diagonal of the box of the layout (without uncertainties), m; 0 = empty
    bool in_inches = false;  ///< its reader wants lengths so
    LengthUnit unit = {};
    NumberLocale numbers = {};  ///< how its texts write theirs
    bool scale_bar = false;
    std::optional<double> floor = {};  ///< height of what everything stands on, m
    /// A box around the ellipsoids that the picture is about, where they are close together in a large whole.
    std::optional<SceneBounds> focus = {};
    std::optional<SectionPlane> section = {};  ///< whoever looks at it cuts it there (section.h)

    std::vector<SceneFrame> frames;
    std::vector<ScenePoint> points;
    std::vector<SceneBody> bodies;
    std::vector<SceneLink> links;
    std::vector<SceneVector> vectors;
    std::vector<SceneMesh> meshes = {};
    std::vector<SceneEllipsoid> ellipsoids;
    /// Ellipsoids of the results that are compared with, about the same points, magnified alike.
    std::vector<SceneEllipsoid> ellipsoids_before = {};
    std::vector<SceneCloud> clouds;
    std::vector<SceneWallHistogram> wall_histograms;
    std::vector<SceneVerdict> not_met = {};
    std::vector<SceneLabel> labels;
    std::optional<SceneAxes> axes = {};
    std::vector<LegendLine> legend;
    std::optional<SceneMap> map = {};

    bool operator==(const Scene&) const = default;
};

/// Whether ellipsoids or clouds are drawn: a magnification is of them.
bool draws_uncertainty(const Scene& scene);
/// The item with this id, or null.
const SceneItem* find_item(const Scene& scene, const std::string& id);
/// The item's name; axes of an instrument have none of their own.
std::string name_of(const SceneItem& item);
/// Whether one field of a set-up states the places of both.
bool stand_by_one_field(const SceneItem& a, const SceneItem& b);

/// A box around everything drawn, axes included, without context meshes if there is anything else: they may
/// be a whole hall, and what is measured small in it.
SceneBounds bounds_of(const Scene& scene);
/// The same without the axes.
SceneBounds bounds_of_items(const Scene& scene);
/// The first with the meshes.
SceneBounds bounds_with_meshes(const Scene& scene);

}  // namespace covaria
