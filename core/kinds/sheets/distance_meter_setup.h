// The set-up of "distance meter on a baseline": readings between pillars on a line, figures to test against.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/setup/fields.h"

namespace covaria::sheets {

/// A distance read between two pillars.
struct BaselineReading {
    std::string from, to;
    double distance = 0.0;
    double height_difference = 0.0;  ///< height of the target above the instrument
    double horizontal() const;
};

/// A length of the baseline that somebody else measured.
struct ReferenceLength {
    std::string pillar;
    double distance = 0.0;  ///< distance from the pillar where the line begins
    double u = 0.0;
};

struct DistanceMeterSetup {
    std::vector<BaselineReading> readings;
    std::optional<double> stated_s;          ///< sigma of test a
    std::optional<double> other_s;           ///< s of another campaign, test b
    int other_degrees_of_freedom = 0;        ///< those of `other_s`
    double probability = 0.95;               ///< 1 - alpha of the tests
    bool with_scale = false;                 ///< the scale is found, by reference lengths
    std::vector<ReferenceLength> reference;  ///< lengths that give the scale
    double u_reference_scale = 0.0;          ///< relative, shared by all reference lengths
    double u_atmosphere = 0.0;               ///< relative, shared by all readings

    std::vector<std::string> pillars;  ///< along the line
    std::vector<double> along;         ///< about where they stand; 0 for the first
    std::vector<std::pair<std::size_t, std::size_t>> places =
        {};                                                  ///< nearer and farther pillar of each reading
    std::size_t unknowns() const { return pillars.size(); }  ///< n - 1 lengths and the zero offset
    double degrees_of_freedom() const { return double(readings.size()) - double(unknowns()); }
};

const Fields<DistanceMeterSetup>& distance_meter_fields();
std::optional<DistanceMeterSetup> read_distance_meter_setup(const SetupReader& reader,
                                                            const AssetLibrary& assets, Problems& problems);

}  // namespace covaria::sheets
