// The set-up of "force-moment channels", read; its input quantities, tables and charts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/kinds/force/force_sensor.h"
#include "core/model/offered.h"
#include "core/quantity/input_quantity.h"
#include "core/setup/fields.h"

namespace covaria::force_channels {

/// Loads that act on the other axes while a channel is read.
enum class OtherLoads {
    none,
    largest,  ///< one, that to which the channel answers most
    all,      ///< each unknown between minus and plus its rated load
};

struct ChannelSetup {
    Offered<ForceSensorSource> sensor;
    OtherLoads others = OtherLoads::all;
    bool pooled = false;     ///< standard deviation pooled over the steps
    bool student_t = false;  ///< Type A by a t-distribution in Monte Carlo (JCGM 101 6.4.9)
    double k = 2.0;          ///< coverage factor of the comparison

    const std::vector<ForceChannel>& channels() const { return sensor->channels(); }
    std::size_t size() const { return channels().size(); }
    double e(std::size_t h, std::size_t c) const {
        return sensor->rated_outputs()(static_cast<Eigen::Index>(h), static_cast<Eigen::Index>(c));
    }
    /// The channel to which h answers most; h itself if there is no other.
    std::size_t strongest(std::size_t h) const;
    /// Whether the load on the axis of c is part of the equation of h.
    bool interferes(std::size_t h, std::size_t c) const;
};

const Fields<ChannelSetup>& fields();
std::optional<ChannelSetup> read(const SetupReader& setup, const AssetLibrary& assets, Problems& problems);

/// Standard uncertainty of a net reading at rated load and its effective degrees of freedom (JCGM 100 G.4):
/// repeatability, machine, resolution, non-zero, hysteresis as rectangular.
struct Single {
    double u = 0.0, degrees_of_freedom = 0.0;
};
Single single_component(const ChannelSetup& setup, std::size_t h);
/// Standard uncertainty with unknown loads on other axes, each rectangular: root sum of squares.
double combined(const ChannelSetup& setup, std::size_t h, OtherLoads others);
/// Sum of the magnitudes of all interference: every other axis at its rated load, signs at their worst.
double worst_case(const ChannelSetup& setup, std::size_t h);

/// Readings of the channels, in the order of the channels; then the loads on the axes, if they matter.
InputSet inputs(const ChannelSetup& setup);

std::vector<Table> tables(const ChannelSetup& setup);
std::vector<PlotSpecification> figures(const ChannelSetup& setup);

}  // namespace covaria::force_channels
