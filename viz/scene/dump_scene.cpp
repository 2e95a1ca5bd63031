// Canonical text of a scene.
#include "viz/scene/dump_scene.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace covaria {
namespace {

std::string mm(double metres) {
    const double rounded = std::round(metres * 1e6) / 1e3;
    std::ostringstream text;
    text << (rounded == 0 ? 0.0 : rounded);  // no negative zero
    return text.str();
}

std::string mm(const Eigen::Vector3d& v) {
    return "(" + mm(v.x()) + " " + mm(v.y()) + " " + mm(v.z()) + ")";
}

std::string number(const Eigen::Vector3d& v) {
    const Eigen::Vector3d rounded = (v * 1e3).array().round() / 1e3 + 0.0;
    std::ostringstream text;
    text << "(" << rounded.x() << " " << rounded.y() << " " << rounded.z() << ")";
    return text.str();
}

const char* text_of(Role role) {
    static constexpr const char* names[] = {
        "axis_x", "axis_y",     "axis_z",     "point",  "input",  "output",  "before", "body",
        "link",   "sight_line", "instrument", "vector", "moment", "not_met", "text",   "quiet_text"};
    return names[static_cast<std::size_t>(role)];
}

const char* text_of(PointKind kind) {
    static constexpr const char* names[] = {"nest",   "target", "support", "ball",
                                            "flange", "tool",   "station", "other"};
    return names[static_cast<std::size_t>(kind)];
}

const char* text_of(LinkKind kind) {
    static constexpr const char* names[] = {"leg",        "robot_link", "bar",           "joint_axis",
                                            "sight_line", "dimension",  "field_of_view", "edge"};
    return names[static_cast<std::size_t>(kind)];
}

const char* text_of(BodyKind kind) {
    static constexpr const char* names[] = {"plate", "artefact", "instrument", "force_sensor"};
    return names[static_cast<std::size_t>(kind)];
}

void put_item(std::ostream& out, const SceneItem& item) {
    out << item.id;
    if (!item.group.empty()) out << " [" << item.group << "]";
    out << " at " << mm(item.position);
    if (item.u) out << " u " << mm(*item.u);
    if (item.U) out << " U " << mm(*item.U);
    if (!item.source.path.empty())
        out << " from " << item.source.asset << item.source.path
            << (item.source.draggable ? " draggable" : "");
}

Eigen::Vector3d spread(const SceneCloud& cloud) {
    const Eigen::Map<const Eigen::Matrix3Xf> offsets(cloud.offsets.data(), 3,
                                                     static_cast<Eigen::Index>(cloud.size()));
    const Eigen::Matrix3Xd d = offsets.cast<double>().colwise() - offsets.cast<double>().rowwise().mean();
    return (d.rowwise().squaredNorm() / static_cast<double>(std::max<std::size_t>(1, cloud.size())))
        .cwiseSqrt();
}

void put_head(std::ostream& out, const Scene& scene) {
    out << "scene \"" << scene.title << "\" group \"" << scene.group << "\"\n"
        << "caption \"" << scene.caption << "\" magnification " << scene.magnification << " p "
        << scene.probability << "\n"
        << "size " << mm(scene.size) << " unit " << scene.unit.text << (scene.scale_bar ? " scale bar" : "")
        << (scene.floor ? " floor " + mm(*scene.floor) : "") << "\n";
    if (scene.focus) out << "focus " << mm(scene.focus->low) << " " << mm(scene.focus->high) << "\n";
    if (scene.section)
        out << "section across "
            << "xyz"[scene.section->axis] << " at " << mm(scene.section->at)
            << (scene.section->hides_high ? " hides high" : " hides low") << "\n";
    for (const std::string& note : scene.notes) out << "note \"" << note << "\"\n";
}

void put_solids(std::ostream& out, const Scene& scene) {
    for (const SceneFrame& frame : scene.frames) {
        put_item(out << "frame ", frame.item);
        out << " x " << number(frame.R_WF.col(0)) << " z " << number(frame.R_WF.col(2)) << "\n";
    }
    for (const ScenePoint& point : scene.points) {
        put_item(out << text_of(point.kind) << " ", point.item);
        out << " radius " << mm(point.radius) << " axis " << number(point.axis) << "\n";
    }
    for (const SceneBody& body : scene.bodies) {
        put_item(out << text_of(body.kind) << " ", body.item);
        if (body.outline.empty())
            out << " glyph " << body.glyph << " size " << mm(body.size) << " sight " << number(body.sight)
                << "\n";
        else
            out << " corners " << body.outline.size() << " normal " << number(body.normal) << " thickness "
                << mm(body.thickness) << " feet " << mm(body.feet) << (body.encloses ? " path" : "") << "\n";
    }
    for (const SceneLink& link : scene.links) {
        put_item(out << text_of(link.kind) << " ", link.item);
        out << " " << mm(link.from) << " to " << mm(link.to) << " radius " << mm(link.radius);
        if (link.end_radius > 0) out << " to " << mm(link.end_radius);
        out << (link.is_dashed ? " dashed" : "") << (link.is_doubtful ? " doubtful" : "")
            << (link.stands ? " stands" : "") << "\n";
    }
    for (const SceneVector& vector : scene.vectors) {
        put_item(out << (vector.kind == VectorKind::moment ? "moment " : "force "), vector.item);
        out << " \"" << vector.label << "\" arrow " << mm(vector.arrow) << "\n";
    }
    for (const SceneMesh& mesh : scene.meshes) {
        put_item(out << "mesh ", mesh.item);
        out << " triangles " << mesh.triangles->triangles() << " opacity " << mesh.opacity << "\n";
    }
}

void put_uncertainties(std::ostream& out, const Scene& scene) {
    for (const auto* ellipsoids : {&scene.ellipsoids, &scene.ellipsoids_before})
        for (const SceneEllipsoid& e : *ellipsoids)
            out << "ellipsoid " << e.item.id << " " << text_of(e.role) << " rank " << e.rank << " k "
                << std::round(e.coverage_factor * 1e4) / 1e4 << " axes " << mm(e.axes.col(0)) << " "
                << mm(e.axes.col(1)) << " " << mm(e.axes.col(2)) << "\n";
    for (const SceneVerdict& verdict : scene.not_met)
        out << "requirement not met: " << verdict.item << " at " << mm(verdict.at) << "\n";
    for (const SceneCloud& cloud : scene.clouds)
        out << "cloud " << cloud.item.id << " " << text_of(cloud.role) << " " << cloud.size()
            << " trials, spread " << mm(spread(cloud)) << "\n";
    for (const SceneWallHistogram& h : scene.wall_histograms)
        out << "histogram " << h.cloud << " " << text_of(h.role) << " "
            << "xyz"[h.axis] << " on wall across "
            << "xyz"[h.normal] << " bars " << h.bars.size() << " box " << mm(h.low) << " " << mm(h.high)
            << "\n";
}

void put_map(std::ostream& out, const SceneMap& map) {
    std::size_t shown = 0, known = 0;
    for (std::size_t i = 0; i < map.values.size(); ++i) {
        known += std::isfinite(map.values[i]);
        shown += std::isfinite(map.values[i]) && map.shown[i];
    }
    out << "map \"" << map.title << "\" points " << map.positions.size() << " with values " << known
        << " shown " << shown << " colours " << map.low << " to " << map.high << " radius " << mm(map.radius)
        << "\n";
    if (!map.positions.empty())
        out << "map from " << mm(map.positions.front()) << " to " << mm(map.positions.back()) << "\n";
    out << "colour bar:";
    for (const AxisTick& tick : map.ticks) out << " " << tick.text;
    out << "\n";
    if (const auto marked = std::count(map.marked.begin(), map.marked.end(), true); marked > 0)
        out << "marked " << marked << "\n";
    if (!map.ways.empty()) out << "ways " << map.ways.size() << " radius " << mm(map.way_radius) << "\n";
    if (map.levels.empty()) return;
    out << "iso-surfaces of " << map.grid[0] << " x " << map.grid[1] << " x " << map.grid[2] << ":";
    for (const double level : map.levels) out << " " << level;
    out << "\n";
}

void put_words(std::ostream& out, const Scene& scene) {
    for (const SceneLabel& label : scene.labels)
        out << "label \"" << to_unicode(label.text) << "\" at " << mm(label.at) << " priority "
            << label.priority << "\n";
    if (scene.axes) {
        out << "axes " << mm(scene.axes->low) << " " << mm(scene.axes->high) << "\n";
        for (std::size_t i = 0; i < 3; ++i) {
            out << "axis \"" << scene.axes->titles[i] << "\":";
            for (const AxisTick& tick : scene.axes->ticks[i]) out << " " << tick.text;
            out << "\n";
        }
    }
    for (const LegendLine& line : scene.legend)
        out << "legend " << text_of(line.role) << " \"" << to_unicode(line.text) << "\"\n";
}

}  // namespace

std::string dump_scene(const Scene& scene) {
    std::ostringstream out;
    put_head(out, scene);
    put_solids(out, scene);
    put_uncertainties(out, scene);
    if (scene.map) put_map(out, *scene.map);
    put_words(out, scene);
    return out.str();
}

}  // namespace covaria
