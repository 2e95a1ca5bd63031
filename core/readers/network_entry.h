// A network as readers find it - points with what is known of them, readings - and the analysis that adjusts
// it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/unit.h"
#include "core/project/project.h"

namespace covaria {

/// The plane and the height of a point are each "fixed", "stated", "datum", "unknown" or "none".
struct NetworkPoint {
    std::string name = {};
    std::array<std::optional<double>, 3> p{};  ///< m
    std::string plane = "unknown", height = "unknown";
    std::array<std::optional<double>, 3> u{};  ///< of stated coordinates, m
    const std::string& role(std::size_t axis) const { return axis < 2 ? plane : height; }
    bool has(std::size_t axis) const { return role(axis) != "none"; }
    bool is_found() const;  ///< whether the readings change any of its coordinates
};

/// Lengths in m, angles in the unit of the network.
struct NetworkReading {
    std::string kind;  ///< "slope-distance", "x"
    std::string from = {}, to = {}, second = {}, round = {}, frame = {}, instrument = {}, label = {};
    double value = 0.0, u = 0.0, height_from = 0.0, height_to = 0.0;
    bool face_two = false;  ///< of a direction
    bool is_used = true;
    bool is_of_angle() const;
    bool needs_plane() const;
    bool needs_height() const;
};

struct NetworkCorrelation {
    std::string first, second;  ///< labels of readings
    double coefficient = 0.0;
};

/// An own frame of coordinates, of which more is known than that there is one.
struct NetworkFrame {
    std::string name = {};
    std::optional<double> u_of_tilt = {};  ///< rad; empty: it leans as it will
    std::string shape = "frame";           ///< or "plane"
};

/// An effect of an instrument on all of its readings.
struct NetworkFigure {
    std::string instrument = {};    ///< empty: of all readings without one
    std::string figure, knowledge;  ///< "refraction" and "fixed", at 0; "index" and "unknown"
};

struct NetworkEntry {
    std::vector<NetworkPoint> points = {};
    std::vector<NetworkReading> readings = {};
    std::vector<NetworkCorrelation> correlations = {};
    std::vector<NetworkFrame> frames = {};
    std::vector<std::string> leaning = {};  ///< stations whose instruments are not levelled
    std::vector<NetworkFigure> figures = {};
    Unit angle_unit = Unit::of("gon");        ///< unit of the readings of angles
    bool clockwise = false;                   ///< directions grow from y towards x
    std::optional<double> earth_radius = {};  ///< m
    std::optional<double> refraction = {};    ///< empty: that of the model
    std::optional<double> gross_limit = {};   ///< m
    bool leaves_undetermined = false;         ///< what nothing tells is left out
    bool adjusts_anything() const;

    /// Takes what no reading tells of points that are unknown out of the network: the heights of one in a
    /// plane, the places of one that is levelled.
    void settle_unknowns();
    /// The points that readings name; the others are removed, and returned.
    std::vector<std::string> remove_unread_points();
    AnalysisEntry analysis(const std::string& name, const std::string& notes) const;

private:
    SetupTable points_table() const;
    SetupTable readings_table() const;
    void write_figures(Setup& setup) const;
};

}  // namespace covaria
