// Readings of targets from one station, in one or two faces and several rounds, to their means and Type A
// evaluations.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace covaria {

/// A reading: angles in rad (azimuth clockwise, zenith angle from the zenith), distance in m; a zenith angle
/// beyond pi is one of face two.
struct PolarReading {
    int line = 0;
    std::string point;
    double azimuth = 0.0, zenith = 0.0, distance = 0.0;
};

struct MeanReading {
    std::string point;
    int line = 0;  ///< line of the first reading
    double azimuth = 0.0, zenith = 0.0, distance = 0.0;
    std::size_t rounds = 0;
};

/// The standard deviation of one reading, pooled over the targets; u of a mean is s / sqrt(rounds).
struct PooledFigure {
    double s = 0.0;
    int degrees_of_freedom = 0;
};

struct Rounds {
    std::vector<MeanReading> means;  ///< means in the order of first readings
    PooledFigure azimuth, zenith, distance;
    std::size_t fewest_rounds = 0;
    bool two_faces = false;                 ///< whether all rounds are in two faces
    double collimation = 0.0, index = 0.0;  ///< means over the pairs of faces, if there are two
};

/// The rounds of readings. Readings of a target in the two faces are paired in their order; a reading without
/// a partner is a round of its own. Where all targets have as many rounds, a turn of the circle between
/// rounds is taken out of the azimuths (ISO 17123-3: nu = (rounds - 1)(targets - 1)).
Rounds rounds_of(const std::vector<PolarReading>& readings);

}  // namespace covaria
