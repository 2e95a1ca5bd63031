// The simple observations of a Comp3D network as readings: rounds, standard deviations by distance.
#pragma once

#include <map>
#include <string>

#include "core/readers/comp3d_flat_readings.h"

namespace covaria {

class Comp3dReadings {
public:
    Comp3dReadings(const Comp3dSurvey& survey, const Comp3dGround& ground, const Comp3dSettings& settings,
                   Comp3dSurveyReader& files, Comp3dFlatReadings& readings, NetworkEntry& entry)
        : survey_(survey),
          ground_(ground),
          settings_(settings),
          files_(files),
          readings_(readings),
          entry_(entry) {}
    void take_all();

private:
    void take(const Comp3dObservation& o);
    void take_centring(const Comp3dObservation& o);
    void take(const Comp3dEquality& equality);
    std::string round_of(const Comp3dObservation& o);

    const Comp3dSurvey& survey_;
    const Comp3dGround& ground_;
    const Comp3dSettings& settings_;
    Comp3dSurveyReader& files_;
    Comp3dFlatReadings& readings_;
    NetworkEntry& entry_;
    std::map<std::string, int> rounds_ = {};  ///< number of rounds of each station so far
};

}  // namespace covaria
