// Capabilities of multi-axis force/moment sensors and of the machines that calibrate them, after Kim.
//
// Readings of the bridge are ratios (V/V); files and forms show mV/V. A row of a matrix is a channel, a
// column is the axis that is loaded.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/unit.h"
#include "core/model/offered.h"

namespace covaria {

struct ForceAxis {
    const char* key;     ///< "Fx": in files
    const char* symbol;  ///< "F_x"
    const char* unit;    ///< "N", "N*m"
    bool is_moment;
};
inline constexpr std::array<ForceAxis, 6> force_axes{{{"Fx", "F_x", "N", false},
                                                      {"Fy", "F_y", "N", false},
                                                      {"Fz", "F_z", "N", false},
                                                      {"Mx", "M_x", "N*m", true},
                                                      {"My", "M_y", "N*m", true},
                                                      {"Mz", "M_z", "N*m", true}}};
inline constexpr std::size_t most_channels = force_axes.size();

/// A machine that loads one axis after the other.
class ForceCalibratorSource : public Capability {
public:
    static constexpr const char* capability = "force-calibrator";
    static constexpr const char* lacking = "is no calibration machine";
    /// Relative standard uncertainty U/k of its load on an axis; empty: it does not load that axis.
    virtual std::optional<double> relative_uncertainty(std::size_t axis) const = 0;
};

/// Figures of one channel from a calibration, in V/V, N or N m.
struct ForceChannel {
    std::size_t axis = 0;       ///< index in force_axes
    double rated_load = 0.0;    ///< N or N m
    double rated_output = 0.0;  ///< mean net reading at the rated load (Kim, Eqs 1, 2)
    double u_a = 0.0;           ///< Type A, of the mean: the largest of all steps (Eqs 3, 4)
    double degrees_of_freedom = 2.0;
    double s_pooled = 0.0;                   ///< standard deviation of one reading, pooled over the steps
    double pooled_degrees_of_freedom = 0.0;  ///< 0: not known
    double runs = 3.0;
    double u_calibrator = 0.0;  ///< relative standard uncertainty of the load, U/k
    double zero = 0.0;          ///< non-zero error: largest change of the unloaded reading over a run
    double hysteresis = 0.0;    ///< largest difference between increasing and decreasing load

    const ForceAxis& kind() const { return force_axes[axis]; }
    Unit load_unit() const { return Unit::of(kind().unit); }
    /// Standard deviation of one reading at a step and its degrees of freedom.
    double s_single(bool pooled) const;
    double s_degrees_of_freedom(bool pooled) const;
};

/// Net readings of all channels with increasing load on one axis.
struct LoadedReading {
    std::size_t loaded = 0;  ///< channel whose axis is loaded
    double load = 0.0;       ///< N or N m
    std::array<double, most_channels> net{};
};

class ForceSensorSource : public Capability {
public:
    static constexpr const char* capability = "force-sensor";
    static constexpr const char* lacking = "is no force/moment sensor";
    virtual const std::vector<ForceChannel>& channels() const = 0;
    virtual double resolution() const = 0;  ///< resolution of the indicator
    /// e(h, c): net output of channel h under the rated load on the axis of channel c alone.
    virtual const Eigen::MatrixXd& rated_outputs() const = 0;
    /// Whether the interference has signs; without them it cannot be compensated.
    virtual bool has_signs() const = 0;
    /// Readings for the regression of the calibration matrix; empty if only a summary is known.
    virtual const std::vector<LoadedReading>& increasing() const = 0;
    /// Kim's U of a channel (Eq 12a), by which the evaluation of the paper is compared.
    virtual double paper_expanded_uncertainty(std::size_t channel) const = 0;
    virtual const Eigen::Isometry3d& placement() const = 0;
    virtual double height() const = 0;  ///< height of its housing, m
};

/// The sensor in an analysis of its loads, which are along its own axes: none of it can be dragged there.
Layout layout_for_loads(const Offered<ForceSensorSource>& sensor);

}  // namespace covaria
