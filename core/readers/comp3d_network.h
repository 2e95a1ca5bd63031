// A network of Comp3D as an analysis that adjusts it.
#pragma once

#include <array>
#include <string>

#include "core/readers/comp3d_ground.h"

namespace covaria {

class Comp3dNetwork {
public:
    Comp3dNetwork(const Comp3dSurvey& survey, const Comp3dSettings& settings, Comp3dSurveyReader& files,
                  Proposals& proposals);
    /// Takes a table of the covariance of constrained coordinates, whose standard deviations it replaces.
    Result<void> take_covariance(const std::string& text, const std::string& file);
    /// Adds the analysis; false where there is nothing that readings would adjust.
    bool propose(const std::string& title, const std::string& source);

private:
    enum class Knowledge { none, unknown, fixed, stated };
    Knowledge knowledge(const Comp3dPoint& point, std::size_t axis) const;
    NetworkPoint point_of(const Comp3dPoint& point);
    void take_points();
    void take_points_of_readings();
    void add_reading_of(const Comp3dPoint& point, std::size_t axis, double u);
    void tell_of_points();

    const Comp3dSurvey& survey_;
    const Comp3dSettings& settings_;
    Comp3dSurveyReader& files_;
    Proposals& proposals_;
    Comp3dPoints points_;
    std::map<std::string, double> sigmas_;  ///< by "A_x", from a table of covariance, m
    std::vector<NetworkCorrelation> correlations_;
    NetworkEntry entry_;
    std::size_t deflected_ = 0;
};

}  // namespace covaria
