#include "core/readers/network_entry.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/readers/entry_texts.h"

namespace covaria {

namespace {

constexpr const char* network_adjustment = "network-adjustment";

SetupCell number_cell(const std::optional<double>& value, double factor = 1.0) {
    return value ? SetupCell(factor * *value) : SetupCell();
}
SetupCell text_cell(const std::string& text) {
    return text.empty() ? SetupCell() : SetupCell(text);
}
SetupCell height_cell(double height) {
    return height == 0.0 ? SetupCell() : SetupCell(height);
}

bool is_unknown(const std::string& role) {
    return role == "unknown" || role == "datum";
}

}  // namespace

bool NetworkPoint::is_found() const {
    const auto found = [](const std::string& role) { return role != "fixed" && role != "none"; };
    return found(plane) || found(height);
}

bool NetworkReading::is_of_angle() const {
    return kind == "direction" || kind == "angle" || kind == "azimuth" || kind == "zenith-angle";
}

bool NetworkReading::needs_plane() const {
    return kind != "height-difference" && kind != "dz" && kind != "z";
}

bool NetworkReading::needs_height() const {
    return kind == "height-difference" || kind == "dz" || kind == "z" || kind == "slope-distance" ||
           kind == "zenith-angle" || kind.starts_with("frame-");
}

bool NetworkEntry::adjusts_anything() const {
    return !readings.empty() && std::ranges::any_of(points, &NetworkPoint::is_found);
}

void NetworkEntry::settle_unknowns() {
    std::set<std::string> of_plane, of_height;
    for (const NetworkReading& r : readings)
        for (const std::string& name : {r.from, r.to, r.second}) {
            if (r.is_used && r.needs_plane()) of_plane.insert(name);
            if (r.is_used && r.needs_height()) of_height.insert(name);
        }
    for (NetworkPoint& point : points) {
        if (is_unknown(point.plane) && !of_plane.contains(point.name)) point.plane = "none";
        if (is_unknown(point.height) && !of_height.contains(point.name)) point.height = "none";
    }
}

std::vector<std::string> NetworkEntry::remove_unread_points() {
    std::set<std::string> read;
    for (const NetworkReading& r : readings) read.insert({r.from, r.to, r.second});
    std::vector<std::string> removed;
    for (const NetworkPoint& point : points)
        if (!read.contains(point.name)) removed.push_back(point.name);
    std::erase_if(points, [&](const NetworkPoint& point) { return !read.contains(point.name); });
    return removed;
}

SetupTable NetworkEntry::points_table() const {
    TableRows rows(table_of(network_adjustment, "points"));
    for (const NetworkPoint& point : points)
        rows.add({{"name", point.name},
                  {"x", number_cell(point.p[0])},
                  {"y", number_cell(point.p[1])},
                  {"z", number_cell(point.p[2])},
                  {"plane", point.plane},
                  {"height", point.height},
                  {"u_x", number_cell(point.u[0], 1e3)},
                  {"u_y", number_cell(point.u[1], 1e3)},
                  {"u_z", number_cell(point.u[2], 1e3)}});
    return rows.table();
}

SetupTable NetworkEntry::readings_table() const {
    TableRows rows(table_of(network_adjustment, "readings"));
    for (const char* column : {"angle", "u_angle"}) rows.set_unit(column, angle_unit);
    for (const NetworkReading& r : readings) {
        const bool angle = r.is_of_angle();
        rows.add({{"label", text_cell(r.label)},
                  {"kind", r.kind},
                  {"from", r.from},
                  {"to", text_cell(r.to)},
                  {"second", text_cell(r.second)},
                  {"round", text_cell(r.round)},
                  {"frame", text_cell(r.frame)},
                  {angle ? "angle" : "length", r.value},
                  {angle ? "u_angle" : "u_length", angle ? r.u : 1e3 * r.u},
                  {"height_from", height_cell(r.height_from)},
                  {"height_to", height_cell(r.height_to)},
                  {"instrument", text_cell(r.instrument)},
                  {"face", r.face_two ? SetupCell(std::string("two")) : SetupCell()},
                  {"use", r.is_used ? SetupCell() : SetupCell(std::string("left-out"))}});
    }
    return rows.table();
}

void NetworkEntry::write_figures(Setup& setup) const {
    TableRows between(table_of(network_adjustment, "correlations"));
    for (const NetworkCorrelation& c : correlations)
        between.add({{"first", c.first}, {"second", c.second}, {"coefficient", c.coefficient}});
    TableRows frame_rows(table_of(network_adjustment, "frames"));
    for (const NetworkFrame& frame : frames)
        frame_rows.add({{"name", frame.name},
                        {"shape", frame.shape},
                        {"scale", std::string("fixed")},
                        {"u_tilt", number_cell(frame.u_of_tilt)}});
    TableRows stations(table_of(network_adjustment, "stations"));
    for (const std::string& point : leaning)
        stations.add({{"point", point}, {"tilt", std::string("unknown")}});
    TableRows figure_rows(table_of(network_adjustment, "figures"));
    for (const NetworkFigure& f : figures)
        figure_rows.add({{"instrument", text_cell(f.instrument)},
                         {"figure", f.figure},
                         {"knowledge", f.knowledge},
                         {"ratio", f.knowledge == "fixed" ? SetupCell(0.0) : SetupCell()}});
    for (const auto& [key, rows] : {std::pair<const char*, const TableRows*>{"correlations", &between},
                                    {"frames", &frame_rows},
                                    {"stations", &stations},
                                    {"figures", &figure_rows}})
        if (!rows->table().rows.empty()) setup.values[key] = rows->table();
}

AnalysisEntry NetworkEntry::analysis(const std::string& name, const std::string& notes) const {
    AnalysisEntry analysis{.id = "network", .model = network_adjustment, .name = name};
    analysis.notes = notes;
    Setup& setup = analysis.setup;
    setup.values["points"] = points_table();
    setup.values["readings"] = readings_table();
    setup.values["sense"] = std::string(clockwise ? "y-to-x" : "x-to-y");
    write_figures(setup);
    if (earth_radius) setup.values["earth_radius"] = Quantity{1e-3 * *earth_radius, Unit::of("km")};
    if (refraction) setup.values["refraction"] = Quantity{*refraction, Unit{}};
    if (gross_limit) setup.values["gross_limit"] = Quantity{*gross_limit, Unit::of("m")};
    if (leaves_undetermined) setup.values["undetermined"] = std::string("leave-out");
    return analysis;
}

}  // namespace covaria
