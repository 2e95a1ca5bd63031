// The readings of a Comp3D network as the network model has them: rounds, standard deviations by distance,
// brought from the sphere to the plane of the coordinates.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/readers/comp3d_site.h"
#include "core/readers/comp3d_survey.h"
#include "core/readers/network_entry.h"

namespace covaria {

/// What stands in the settings of a computation; without them as Comp3D has it at first.
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

class Comp3dReadings {
public:
    /// Adds to the readings, frames, leaning stations and instruments of `entry`; remarks go to `files`, what
    /// is done to all readings to `proposals`.
    Comp3dReadings(const Comp3dSurvey& survey, const Comp3dPoints& points, const Comp3dSettings& settings,
                   Comp3dSurveyReader& files, Proposals& proposals, NetworkEntry& entry);
    void take_all();

private:
    struct Reduced {
        std::size_t count = 0;
        double most = 0.0;
    };
    void take(const Comp3dObservation& o);
    void take_centring(const Comp3dObservation& o);
    void take(const Comp3dSubframe& subframe);
    void take_coordinates(const Comp3dSubframe& subframe, const std::string& frame);
    void take_polar(const Comp3dSubframe& subframe, const std::string& instrument);
    /// Adds the reading, reduced where it is worth it; a remark where the network cannot have it.
    void add(NetworkReading reading, const Comp3dPlace& at, bool is_reduced);
    void reduce(NetworkReading& reading);
    std::string round_of(const Comp3dObservation& o);
    std::optional<double> distance_of(const std::string& from, const std::string& to) const;
    std::optional<Message> objection(const NetworkReading& reading) const;
    const Comp3dPoint* placed(const std::string& name) const;
    bool is_levelled_at(const Comp3dSubframe& subframe) const;
    void tell_of_all();

    const Comp3dSurvey& survey_;
    const Comp3dPoints& points_;
    const Comp3dSettings& settings_;
    Comp3dSurveyReader& files_;
    Proposals& proposals_;
    NetworkEntry& entry_;
    Comp3dSite site_;
    std::map<std::string, int> rounds_;  ///< number of rounds of each station so far
    std::map<std::pair<std::string, std::string>, double> read_distances_;
    Reduced lengths_ = {}, angles_ = {};
    double bent_ = 0.0;  ///< most that the curvature bends an own frame that leans, m
    std::size_t off_ = 0;
};

}  // namespace covaria
