// A network of GNU Gama as an analysis that adjusts it: its points with what is known of them, its
// observations.
#pragma once

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "core/readers/gama_observations.h"
#include "core/readers/reader.h"

namespace covaria {

/// A point of the network: "fixed", "datum", "unknown" or "none" of its plane and its height.
struct GamaPoint {
    std::string name;
    std::array<std::optional<double>, 3> p{};
    std::string plane = "none", height = "none";
    bool has(std::size_t axis) const { return (axis < 2 ? plane : height) != "none"; }
};

/// <parameters>: the unit of weights, the bound of gross absolute terms.
struct GamaParameters {
    double sigma = 10.0, tolerance = 1000.0;  ///< a priori; in mm
    bool a_posteriori = true;
    std::vector<std::pair<int, Message>> named = {};  ///< what changes results and is not taken over
};
GamaParameters gama_parameters(const XmlText& xml, const pugi::xml_node& node);

class GamaNetwork {
public:
    GamaNetwork(const XmlText& xml, Proposals& proposals) : xml_(xml), proposals_(proposals) {}

    /// <network>, of its axes and the sense of its angles.
    void take_axes(const pugi::xml_node& network);
    void take_parameters(GamaParameters parameters) { parameters_ = std::move(parameters); }
    const GamaParameters& parameters() const { return parameters_; }
    void take_point(const pugi::xml_node& node, const std::array<std::optional<double>, 3>& p, bool observed);
    /// Coordinates observed in one cluster, and their covariance in mm² where it is stated.
    Result<void> take_coordinates(const pugi::xml_node& cluster);
    /// Adds the analysis; false: nothing of the network can be adjusted, and nothing is said.
    bool propose(const std::vector<GamaObserved>& observed,
                 const std::vector<StatedCorrelation>& correlations, const std::string& title,
                 const std::string& source);

private:
    struct Row {
        GamaObserved observed;
        std::string label;
    };
    std::optional<std::string> objection(const GamaObserved& observed) const;
    double north() const;
    SetupTable points_table() const;
    SetupTable readings_table() const;

    const XmlText& xml_;
    Proposals& proposals_;
    std::vector<GamaPoint> points_;
    std::map<std::string, std::size_t> index_;
    std::vector<GamaObserved> coordinates_;  ///< observed ones
    std::vector<StatedCorrelation> of_coordinates_;
    std::vector<Row> rows_;
    std::string axes_ = "ne";
    GamaParameters parameters_;
    double least_u_of_angle_ = std::numeric_limits<double>::infinity();  ///< in gon
    bool clockwise_ = false;                                             ///< angles grow from y towards x
};

}  // namespace covaria
