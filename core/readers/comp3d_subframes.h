// Own frames of a Comp3D network: coordinates of scanners, and instruments that lean.
#pragma once

#include "core/readers/comp3d_flat_readings.h"

namespace covaria {

class Comp3dSubframes {
public:
    Comp3dSubframes(const Comp3dSurvey& survey, const Comp3dGround& ground, const Comp3dSettings& settings,
                    Comp3dSurveyReader& files, Comp3dFlatReadings& readings, NetworkEntry& entry)
        : survey_(survey),
          ground_(ground),
          settings_(settings),
          files_(files),
          readings_(readings),
          entry_(entry) {}
    void take_all(Proposals& proposals);

private:
    using Turn = std::optional<Eigen::Matrix3d>;
    void take(const Comp3dSubframe& subframe);
    void take_coordinates(const Comp3dSubframe& subframe, const std::string& frame);
    void take_polar(const Comp3dSubframe& subframe, const std::string& instrument);
    bool is_levelled_at(const Comp3dSubframe& subframe) const;
    std::optional<Comp3dSite::Sight> sight_of(const Comp3dSubframe& subframe,
                                              const Comp3dSighting& sighting) const;
    Turn turn_of(const Comp3dSubframe& subframe) const;
    Eigen::Vector3d vector_of(const Comp3dSubframe& subframe, const Comp3dSighting& sighting) const;
    /// The vector in the frame, in metres, as it is in a flat network; as zenith angles have it there where
    /// it `is_curved`.
    Eigen::Vector3d flat_vector_of(const Comp3dSubframe& subframe, const Comp3dSighting& sighting,
                                   const Turn& turn, bool is_curved);

    const Comp3dSurvey& survey_;
    const Comp3dGround& ground_;
    const Comp3dSettings& settings_;
    Comp3dSurveyReader& files_;
    Comp3dFlatReadings& readings_;
    NetworkEntry& entry_;
    double bent_ = 0.0;  ///< most that heights and curvature change own frames that are not reduced, m
};

}  // namespace covaria
