// The set-up of "points from sensors", read, checked, and completed with predicted or given readings.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/kinds/instruments/linear_reading.h"
#include "core/kinds/instruments/sensor.h"
#include "core/model/offered.h"
#include "core/quantity/input_quantity.h"
#include "core/setup/fields.h"

namespace covaria::network {

/// Most sensors: enough for every network seen so far, and for rows on the stack of the inner loop.
inline constexpr std::size_t most_sensors = 40;
inline constexpr std::size_t most_rows = 3 * most_sensors;
inline constexpr std::size_t most_joint_rows = 600;
inline constexpr std::size_t most_shared = 16 * most_sensors;  ///< most deviations that readings share
inline constexpr std::size_t most_joint_targets = most_joint_rows / 3;

enum class Estimator {
    nonlinear,    ///< weighted least squares of the readings
    linear,       ///< OLS, then GLS of linearised equations (Galetto et al., Eqs 1-4)
    linear_start  ///< OLS of the linearised equations alone (Eq 3)
};
enum class Weights {
    with_stations,     ///< covariance of readings and stations, all targets of a set-up at once
    observations_only  ///< covariance of the readings alone, as in the paper
};

using Sensor = Offered<SensorSource>;

/// The table of the sensors, of the model and of the asset.
struct SensorList {
    struct Row {
        Sensor sensor;
    };
    std::vector<Row> rows;
};
const Fields<SensorList>& sensor_list_fields();
/// Returns the rows that are sensors, in their order; an error where one is listed twice.
std::vector<Sensor> sensors_of(const SensorList& list, Problems& problems);

/// The set-up as typed, SI.
struct StatedNetwork {
    struct Target {
        std::string name;
        Eigen::Vector3d nominal = Eigen::Vector3d::Zero();
        bool new_set_up = false;
    };
    struct Distance {
        std::string from, to;
    };
    struct Angle {
        std::string from, at, to;
    };
    struct Frame {
        std::string name, origin, on_x, in_xy;
    };
    struct Bar {
        std::string from, to;
        std::optional<double> length;
        double u = 0.0;
        bool constrains = false;
        std::string distribution;
    };
    struct Reading {
        std::string target;
        Sensor sensor;
        std::array<std::optional<double>, 3> values;  ///< by Observable
    };
    SensorList sensors;
    std::vector<Target> targets;
    std::vector<Distance> distances;
    std::vector<Angle> angles;
    std::vector<Frame> frames;
    std::vector<Bar> bars;
    bool measured = false;
    std::vector<Reading> readings;
    Estimator estimator = Estimator::nonlinear;
    Weights weights = Weights::with_stations;
};
const Fields<StatedNetwork>& network_fields();

/// The readings of one target by one sensor.
struct Sight {
    std::size_t sensor = 0;
    std::array<bool, 3> has{};            ///< by Observable
    std::array<double, 3> reading{};      ///< estimates, SI
    std::array<double, 3> u{};            ///< standard uncertainties for the weights, SI
    std::array<std::size_t, 3> input{};   ///< indices of the input quantities
    std::array<std::string, 3> source{};  ///< place in the set-up
    /// Part of each residual that comes from the station being found elsewhere than stated: the change of the
    /// reading by that move of the station, to first order at the place where it was found.
    std::array<double, 3> raised{};
    /// The target is so near to the zenith that the azimuth is read by its effect: its input quantity is then
    /// the displacement across the azimuth `reading[1]`, which is a constant.
    bool overhead = false;
};

struct Target {
    std::string name;
    /// Point at which all that is not linear is evaluated: nominal, or with given readings the estimate.
    Eigen::Vector3d nominal = Eigen::Vector3d::Zero();
    std::size_t set_up = 0;  ///< index of the set-up of the sensors it is measured from
    std::vector<Sight> sights = {};
    std::size_t rows = 0;  ///< number of its readings
    bool has_linear_start = false;
    bool divided = false;  ///< apart from the others of its set-up: too many to be weighed together
    /// (JᵀWJ)⁻¹ with weights of its readings alone, by rows.
    std::array<double, 9> inverse_normal{};
};

/// Weights of the readings of a target by one sensor, which share nothing with those by others.
struct WeightBlock {
    std::vector<std::size_t> rows;  ///< among the readings of the target
    std::vector<double> weights;    ///< rows x rows of C⁻¹
};

/// Relation of one reading to a deviation that readings share.
struct SharedWeight {
    std::size_t row = 0;
    double effect = 0.0;    ///< change of the reading by the deviation: A
    double estimate = 0.0;  ///< contribution of the reading to the estimate of the deviation: S
};

/// Move of a station by a deviation that readings share.
struct SharedMove {
    std::size_t sensor = 0;
    std::array<double, 6> by{};  ///< per unit; all zero: it is no deviation of a station
};

/// Targets measured while the sensors stood where they stand, estimated together.
struct JointSetUp {
    std::size_t index = 0;  ///< index of the set-up
    std::size_t first = 0;  ///< index of its first target
    std::size_t targets = 0;
    std::vector<std::size_t> bars = {};  ///< scale bars that constrain its targets
    /// Weights W = diag(1/u) (I − A S) diag(1/u) = C⁻¹ of the readings, then the bars: 1/u; A and S,
    /// deviation by deviation, of the readings that have to do with it. (JᵀWJ)⁻¹ of the targets by rows. All
    /// empty: each target by itself.
    std::vector<double> by_u = {}, inverse_normal = {};
    std::vector<SharedWeight> shared = {};
    std::vector<std::size_t> ends_of_shared = {};
    /// Moves of the stations by deviation, and the change of each reading by the coordinates of its station
    /// where all are now. Set where the stations are known so badly that their effect on readings is not
    /// linear: each trial then finds them as well. Empty: in each trial they stand where they were drawn.
    std::vector<SharedMove> moves = {};
    std::vector<std::array<double, 6>> by_station = {};
    bool finds_stations() const { return !moves.empty(); }
    /// Weights of a target by itself, used with its (JᵀWJ)⁻¹, where too many are in one set-up to be weighed.
    std::vector<WeightBlock> blocks = {};
    const SharedWeight* end_of_shared(std::size_t deviation) const {
        return shared.data() + ends_of_shared[deviation];
    }
    bool together() const { return !inverse_normal.empty(); }
    bool by_itself() const { return !blocks.empty(); }
};

struct Distance {
    std::size_t from = 0, to = 0;
};

/// A calibrated length between two targets.
struct ScaleBar {
    std::size_t from = 0, to = 0;
    double length = 0.0;            ///< calibrated, m; in a design the distance of the nominal targets
    double u = 0.0;                 ///< standard uncertainty, m
    std::string distribution = {};  ///< shape of its deviation
    bool constrains = false;        ///< takes part in the estimation; else it is compared with its result
    Message name = {};              ///< "scale bar A – B"
    std::string source = {};        ///< place in the set-up
    std::size_t input = 0;          ///< index of the input quantity
};
/// The words "scale bar A – B".
Message scale_bar_words(const std::string& from, const std::string& to);

/// The angle at the target `at`, between the directions to `from` and `to`.
struct Angle {
    std::size_t from = 0, at = 0, to = 0;
};

/// A frame on three targets: origin, a point on +x, a point in the xy-plane at positive y.
struct TargetFrame {
    std::string name;
    std::array<std::size_t, 3> targets{};
};

/// A station that was stated with an uncertainty, at the place where given readings find it.
struct FoundStation {
    std::array<double, 6> moved{};  ///< change of its coordinates from those that were stated
    StationGeometry geometry;
};

struct NetworkSetup {
    std::vector<Sensor> sensors;
    std::vector<StationGeometry> geometry = {};  ///< places of the stations as stated
    /// Stations of all sensors, set-up by set-up; empty: they are taken where they were stated.
    std::vector<FoundStation> found = {};
    std::vector<Target> targets;
    std::vector<Eigen::Vector3d> stated = {};  ///< coordinates of the targets, as they were typed
    std::vector<JointSetUp> set_ups;           ///< in the order of the targets
    std::size_t stations = 1;                  ///< number of set-ups: how often the sensors were located
    std::vector<Distance> distances;
    std::vector<ScaleBar> bars;
    std::vector<Angle> angles;
    std::vector<TargetFrame> frames;
    Estimator estimator = Estimator::nonlinear;
    Weights weights = Weights::with_stations;
    bool measured = false;  ///< readings were given

    /// Number of output quantities.
    std::size_t outputs() const {
        return 3 * targets.size() + distances.size() + angles.size() + 6 * frames.size() + bars.size();
    }

    /// Place of a sensor while a set-up is measured.
    const StationGeometry& station(std::size_t set_up, std::size_t sensor) const {
        return found.empty() ? geometry[sensor] : found[set_up * sensors.size() + sensor].geometry;
    }
    const StationGeometry& station(const Target& target, const Sight& sight) const {
        return station(target.set_up, sight.sensor);
    }

    /// Index of the first of six input quantities of a station.
    std::size_t station_input(std::size_t set_up, std::size_t sensor) const {
        return 6 * (set_up * sensors.size() + sensor);
    }
};

/// X_WF of a frame on targets at their nominal coordinates.
Eigen::Isometry3d frame_of(const NetworkSetup& setup, const TargetFrame& frame);

/// The set-up, checked and completed with predicted or given readings. Empty if `problems` got an error.
std::optional<NetworkSetup> network_setup(const StatedNetwork& stated, Problems& problems);
/// The same from a set-up that is still to be read.
std::optional<NetworkSetup> read_network_setup(const SetupReader& setup, const AssetLibrary& assets,
                                               Problems& problems);

/// Derivatives of the readings of a sight of the target, where it is now.
LinearReading sensitivity_of(const NetworkSetup& setup, const Target& target, const Sight& sight);
/// Sets what the sights of all targets take from the present places of target and station: uncertainties of
/// the readings for the weights, which are overhead, and by how much the residuals are raised.
void linearise_sights(NetworkSetup& setup);
/// Reading minus what the sensor would read of the target at p; of an azimuth overhead in m across it.
double residual_of(const NetworkSetup& setup, const Target& target, const Sight& sight, std::size_t i,
                   const Eigen::Vector3d& p);

/// Readings of the target at p: by Observable, in SI.
std::array<double, 3> readings_of(const StationGeometry& station, const Eigen::Vector3d& p);

/// Derivatives of the readings of a target, to first order; azimuths of overhead sights as their effect in m.
struct Sensitivities {
    Eigen::MatrixXd to_point;  ///< rows x 3: design matrix
    Eigen::MatrixXd
        shared;  ///< F, rows x m: the covariance of what targets share is F Fᵀ (same columns for all)
    Eigen::VectorXd u;  ///< standard uncertainties of the readings alone, rows
};
Sensitivities sensitivities_at(const NetworkSetup& setup, const Target& target);
/// The same for all targets of a set-up, one after the other, then its scale bars; `to_point` has three
/// columns for each target.
Sensitivities sensitivities_of(const NetworkSetup& setup, const JointSetUp& joint);
/// Residuals of the readings in the same order, at the targets and stations as they are now.
Eigen::VectorXd residuals_of(const NetworkSetup& setup, const JointSetUp& joint);

/// Metres per unit of each reading in its linearised equation: 1, horizontal distance, distance; 0: it has
/// none.
Eigen::VectorXd linear_scales(const NetworkSetup& setup, const Target& target);

/// Finds which scale bars constrain the targets of which set-up, and divides what is too large to be weighed.
void divide_set_ups(NetworkSetup& setup, Problems& problems);
/// Fills weights, anew where they were filled; errors where a target cannot be localised, warnings where it
/// hardly can.
void find_weights(NetworkSetup& setup, Problems& problems);

/// Numbers the input quantities: says of sights and scale bars which are theirs.
void number_inputs(NetworkSetup& setup);
/// The input quantities of a set-up whose inputs are numbered.
InputSet network_inputs(const NetworkSetup& setup);

/// Puts targets and stations where given readings find them, and fills the weights there, as `find_weights`:
/// what is estimated and its uncertainty do not depend on the nominal coordinates, which are where the search
/// begins. Expects set-ups that are divided and numbered inputs.
void locate(NetworkSetup& setup, Problems& problems);

/// Tables about the network: precision by observations alone and in total; with given readings residuals,
/// redundancy, outliers, chi-square test.
std::vector<Table> network_evaluation(const NetworkSetup& setup);

/// Warns of given readings that contradict each other more than their uncertainties allow.
void check_residuals(const NetworkSetup& setup, Problems& problems);

Layout network_layout(const NetworkSetup& setup, std::span<const double> x);

}  // namespace covaria::network
