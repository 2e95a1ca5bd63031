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
#include "core/readers/network_entry.h"
#include "core/readers/reader.h"

namespace covaria {

/// A point of the network; its plane and its height are each "fixed", "datum", "unknown" or "none".
struct GamaPoint {
    std::string name;
    std::array<std::optional<double>, 3> p{};
    std::string plane = "none", height = "none";
    bool has(std::size_t axis) const { return (axis < 2 ? plane : height) != "none"; }
};

/// The element <parameters>: the unit of weights, the bound of gross absolute terms.
struct GamaParameters {
    double sigma = 10.0, tolerance = 1000.0;  ///< sigma a priori; tolerance in mm
    bool a_posteriori = true;
    /// Names and lines of parts that change results and are not taken over.
    std::vector<std::pair<int, Message>> named = {};
};
GamaParameters gama_parameters(const XmlText& xml, const pugi::xml_node& node);

class GamaNetwork {
public:
    GamaNetwork(const XmlText& xml, Proposals& proposals) : xml_(xml), proposals_(proposals) {}

    /// Takes the axes and the sense of angles from the element <network>.
    void take_axes(const pugi::xml_node& network);
    void take_parameters(GamaParameters parameters) { parameters_ = std::move(parameters); }
    const GamaParameters& parameters() const { return parameters_; }
    void take_point(const pugi::xml_node& node, const std::array<std::optional<double>, 3>& p, bool observed);
    /// Takes coordinates observed in one cluster, and their covariance in mm² where it is stated.
    Result<void> take_coordinates(const pugi::xml_node& cluster);
    /// Adds the analysis; returns false, and says nothing, where nothing of the network can be adjusted.
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
    NetworkEntry entry() const;

    const XmlText& xml_;
    Proposals& proposals_;
    std::vector<GamaPoint> points_;
    std::map<std::string, std::size_t> index_;
    std::vector<GamaObserved> coordinates_;  ///< observed coordinates
    std::vector<StatedCorrelation> of_coordinates_;
    std::vector<Row> rows_;
    std::string axes_ = "ne";
    GamaParameters parameters_;
    double least_u_of_angle_ = std::numeric_limits<double>::infinity();  ///< least u of an angle, gon
    bool clockwise_ = false;                                             ///< angles grow from y towards x
};

}  // namespace covaria
