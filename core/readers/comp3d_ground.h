// Where the points of a Comp3D network are before it is adjusted, as far as standard deviations by distance
// and reductions need it.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/readers/comp3d_site.h"
#include "core/readers/comp3d_survey.h"
#include "core/readers/network_entry.h"

namespace covaria {

/// The settings of a computation; without a file of them as Comp3D has them at first.
struct Comp3dSettings {
    double latitude = 48.8;  ///< of the centre, deg
    double refraction = 0.12;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< m
    Unit angle_unit = Unit::of("gon");
    bool has_internal_constraints = false;
    std::string projection = {};  ///< empty: the plane that touches at the centre
};

/// Points of a survey by their names; of points with one name the first.
using Comp3dPoints = std::map<std::string, const Comp3dPoint*>;

class Comp3dGround {
public:
    Comp3dGround(const Comp3dSurvey& survey, const Comp3dPoints& points, const Comp3dSettings& settings);
    const Comp3dPoints& points() const { return points_; }
    const Comp3dSite& site() const { return site_; }
    /// The point with its coordinates; null where the file has none, or does not use it.
    const Comp3dPoint* placed(const std::string& name) const;
    /// The distance between the coordinates, or as it was read.
    std::optional<double> distance_of(const std::string& from, const std::string& to) const;
    /// The ends of a reading, as far as they are known.
    std::optional<Comp3dSite::Sight> sight_of(const NetworkReading& reading) const;

private:
    void find_heights(const Comp3dSurvey& survey);

    const Comp3dPoints& points_;
    const Comp3dSettings& settings_;
    Comp3dSite site_;
    std::map<std::pair<std::string, std::string>, double> read_distances_;
    std::map<std::string, double> heights_;  ///< heights of points, stated or by sights from such, m
};

}  // namespace covaria
