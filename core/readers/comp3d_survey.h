// The points and observations of a Comp3D network, with those of the files that its files include.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/readers/neighbours.h"
#include "core/readers/reader.h"

namespace covaria {

/// A line without the comment behind its sign.
std::string_view comp3d_content(std::string_view line);

/// The part of a network that a code of a point stands for.
struct Comp3dCode {
    int code = 0;
    static std::optional<Comp3dCode> of(const std::string& cell);  ///< "-1" to "9"
    bool is_ignored() const { return code < 0; }
    /// Whether the network has the coordinate: points of heights and points of a plane have not all.
    bool has(std::size_t axis) const;
    bool constrains(std::size_t axis) const;
    bool is_remote() const { return code == 8 || code == 9; }  ///< kept out of internal constraints
};

struct Comp3dPlace {
    std::string file = {};  ///< empty: the file that is read
    int line = 0;
};

struct Comp3dPoint {
    Comp3dPlace at;
    Comp3dCode code;
    std::string name;
    std::array<double, 3> p{};                     ///< E, N, h, m
    std::array<std::optional<double>, 3> sigma{};  ///< as stated; below 0: the constraint is off
    bool is_deflected = false;                     ///< whether it has deflections of the vertical
};

/// A simple observation; lengths in m, angles as they stand there.
struct Comp3dObservation {
    Comp3dPlace at;
    int code = 0;  ///< without its sign
    std::string from, to;
    double value = 0.0, sigma = 0.0, sigma_relative = 0.0, height_from = 0.0, height_to = 0.0;
    bool is_used = true;
};

/// A target in an own frame: its coordinates, or two angles and a distance.
struct Comp3dSighting {
    Comp3dPlace at;
    std::string target;
    std::array<double, 3> value{}, sigma{}, sigma_relative{};
    double height = 0.0;
};
struct Comp3dSubframe {
    Comp3dPlace at;
    bool is_polar = false, is_level = false;
    std::string origin, name;
    std::vector<Comp3dSighting> sightings = {};
};

/// Distances that are equal, whatever they are.
struct Comp3dEquality {
    struct Pair {
        Comp3dPlace at;
        std::string from, to;
        double sigma = 0.0;
    };
    std::string name;
    std::vector<Pair> pairs = {};
};

/// Positions of targets that turn about an axis.
struct Comp3dAxis {
    struct Position {
        Comp3dPlace at;
        std::string target, point;
        double sigma_radius = 0.0, sigma_off = 0.0;  ///< along the radius, off the plane of the circle
    };
    Comp3dPlace at;
    std::string origin;
    std::vector<Position> positions = {};
};

struct Comp3dSurvey {
    std::vector<Comp3dPoint> points = {};
    std::vector<Comp3dObservation> observations = {};
    std::vector<Comp3dSubframe> subframes = {};
    std::vector<Comp3dEquality> equalities = {};
    std::vector<Comp3dAxis> axes = {};
    bool has_observations() const {
        return !observations.empty() || !subframes.empty() || !equalities.empty() || !axes.empty();
    }
};

/// Reads files into a survey. Lines that it does not hold are remarks of `proposals`. Errors have a line, and
/// the file where it is an included one.
class Comp3dSurveyReader {
public:
    Comp3dSurveyReader(const Neighbours& beside, Comp3dSurvey& survey, Proposals& proposals)
        : beside_(beside), survey_(survey), proposals_(proposals) {}

    /// `file` names the text in remarks; empty for the file that is read.
    Result<void> read_points(const std::string& text, const std::string& file);
    Result<void> read_observations(const std::string& text, const std::string& file);
    void leave_out(const Comp3dPlace& at, const Message& what);

private:
    using Cells = std::vector<std::string>;
    using TakeLine = Result<void> (Comp3dSurveyReader::*)(const Cells& cells, const Comp3dPlace& at);
    Result<void> read_lines(const std::string& text, const std::string& file, TakeLine take);
    Result<void> include(const std::string& name, const Comp3dPlace& at, TakeLine take);
    std::optional<std::string> text_beside(const std::string& name, const Comp3dPlace& at);
    Result<void> take_point(const Cells& cells, const Comp3dPlace& at);
    Result<void> take_observation(const Cells& cells, const Comp3dPlace& at);
    Result<void> take_sighting(const Cells& cells, const Comp3dPlace& at);
    Result<void> take_pair(const Cells& cells, const Comp3dPlace& at);
    Result<void> take_position(const Cells& cells, const Comp3dPlace& at);
    Result<void> take_subfile(int code, const Cells& cells, const Comp3dPlace& at);

    const Neighbours& beside_;
    Comp3dSurvey& survey_;
    Proposals& proposals_;
    std::vector<std::string> open_ = {};  ///< files that are being read, each included by the one before
    std::size_t included_ = 0;
};

}  // namespace covaria
