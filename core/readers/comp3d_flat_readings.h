// Readings of a Comp3D network on their way into an analysis: refused where it cannot have them, brought from
// the sphere to the plane of the coordinates.
#pragma once

#include "core/readers/comp3d_ground.h"
#include "core/readers/reader.h"

namespace covaria {

class Comp3dFlatReadings {
public:
    Comp3dFlatReadings(const Comp3dGround& ground, const Comp3dSettings& settings, Comp3dSurveyReader& files,
                       NetworkEntry& entry)
        : ground_(ground), settings_(settings), files_(files), entry_(entry) {}
    /// Adds a reading; a remark where the network cannot have it. `change` is added to it, m or rad, where it
    /// is worth it.
    void add(NetworkReading reading, const Comp3dPlace& at, double change = 0.0);
    /// By how much a reading changes on its way into the plane, m or rad.
    double change_of(const NetworkReading& reading) const;
    /// Says what was done to all of them; zenith angles get the curvature of the Earth.
    void say_what_was_done(Proposals& proposals);

private:
    struct Reduced {
        std::size_t count = 0;
        double most = 0.0;
    };
    std::optional<Message> objection(const NetworkReading& reading) const;
    void reduce_by(NetworkReading& reading, double change);

    const Comp3dGround& ground_;
    const Comp3dSettings& settings_;
    Comp3dSurveyReader& files_;
    NetworkEntry& entry_;
    Reduced lengths_ = {}, angles_ = {};
    std::size_t off_ = 0;
};

}  // namespace covaria
