// The set-up of "two-face and length tests of a tracker": test values with their positions, limits.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/setup/fields.h"
#include "core/text/table.h"

namespace covaria::sheets {

enum class TrackerTestKind { two_face, length };

struct TrackerTest {
    std::string position;
    TrackerTestKind kind = TrackerTestKind::two_face;
    double value = 0.0;  ///< two-face: distance of both readings across the beam; else the measured length
    double reference = 0.0;                              ///< reference length
    std::optional<double> u;                             ///< u of this test value alone
    std::optional<double> mpe;                           ///< stated, instead of by the figures below
    double range = 0.0, azimuth = 0.0, elevation = 0.0;  ///< place of the target, of the length's middle
    double error() const { return kind == TrackerTestKind::two_face ? value : value - reference; }
    Eigen::Vector3d place() const;
};

struct TrackerTestsSetup {
    std::vector<TrackerTest> tests;
    /// MPE = constant + slope times the range (two-face) or the length.
    std::optional<double> two_face_constant, length_constant;
    double two_face_slope = 0.0, length_slope = 0.0;
    double u_two_face = 0.0, u_length = 0.0;  ///< u of each test value, independent
    double u_reference_scale = 0.0;           ///< relative, shared by all reference lengths
    double probability = 0.95;

    double mpe(const TrackerTest& test) const;
    double u_own(const TrackerTest& test) const;
    double u(const TrackerTest& test) const;  ///< includes what it shares
};

const Fields<TrackerTestsSetup>& tracker_tests_fields();
std::optional<TrackerTestsSetup> read_tracker_tests_setup(const SetupReader& reader,
                                                          const AssetLibrary& assets, Problems& problems);
std::vector<Table> tracker_tests_tables(const TrackerTestsSetup& setup);

}  // namespace covaria::sheets
