// The set-up of "theodolite in rounds": readings of targets in both faces, figures to test against.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/setup/fields.h"

namespace covaria::sheets {

/// The readings of a target in a round, in both faces.
struct FaceReadings {
    std::string series = "1", set, target;
    std::optional<double> direction_1, direction_2;  ///< horizontal circle
    std::optional<double> zenith_1, zenith_2;        ///< vertical circle, zenith angles; face II beyond pi

    bool has_directions() const { return direction_1 && direction_2; }
    bool has_zeniths() const { return zenith_1 && zenith_2; }
    double direction() const;  ///< mean of the faces, as face I reads
    double zenith() const;     ///< mean of the faces
    double index() const;      ///< what a zenith angle reads too large
};

/// Figures that tests a and b hold an s against.
struct DeviationTests {
    std::optional<double> stated;       ///< sigma of test a
    std::optional<double> other;        ///< s of another campaign, test b
    int other_degrees_of_freedom = 32;  ///< those of `other`
};

struct TheodoliteSetup {
    std::vector<FaceReadings> readings;
    DeviationTests direction_tests, zenith_tests;
    double probability = 0.95;  ///< 1 - alpha of the tests
};

const Fields<TheodoliteSetup>& theodolite_fields();
std::optional<TheodoliteSetup> read_theodolite_setup(const SetupReader& reader, const AssetLibrary& assets,
                                                     Problems& problems);

}  // namespace covaria::sheets
