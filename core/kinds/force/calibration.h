// A multi-axis force/moment sensor and its calibration (Kim): readings, what follows from them, tables and
// charts.
//
// Readings are ratios (V/V), loads are N or N m; lists over channels follow the table of channels. Equation
// numbers are those of G.-S. Kim, Uncertainty evaluation of a multi-axis force/moment sensor.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/kinds/force/axis_fields.h"
#include "core/kinds/force/force_sensor.h"
#include "core/model/offered.h"
#include "core/text/plot_specification.h"
#include "core/text/table.h"

namespace covaria::force {

using Readings = std::array<double, most_channels>;

struct StepReading {
    int step = 0;
    double load = 0.0;
    Readings net{};  ///< Eq 1
    double time = 0.0;
};

struct Run {
    int number = 0;
    std::optional<Readings> zero_before, zero_after;  ///< unloaded readings, as indicated
    std::vector<StepReading> increasing, decreasing;  ///< readings by load, rising
    double time_before = 0.0, time_after = 0.0;       ///< times of the unloaded readings, s; NaN: not known
    const StepReading* decreasing_at(int step) const;
};

/// The readings of all channels while one axis is loaded.
struct Series {
    std::vector<Run> preloads;  ///< runs with one increasing reading each
    std::vector<Run> runs;
};

/// The plan of the calibration (Kim, section 3 and Fig. 2). Times in s.
struct Plan {
    int preloads = 3, runs = 3, steps = 5;
    bool decreasing = true;
    double free_time = 120.0, load_time = 30.0;
};

/// A step of one series, on the channel that is loaded.
struct StepStatistics {
    int step = 0;
    double load = 0.0;
    double mean = 0.0;             ///< Eq 2
    double s = 0.0;                ///< Eq 3; 0 with fewer than two runs
    double n = 0.0;                ///< runs
    double decreasing_mean = 0.0;  ///< NaN where there is none
};

/// Quantities that a certificate states of a channel, in the order of the table's columns.
enum class Figure {
    rated_output,
    zero_error,
    u_A,
    u_B,
    hysteresis,
    interference,
    u_c,
    U,
    U_relative,  ///< U over the rated output (Eq 12b)
    U_load,      ///< U as a load (Eq 12c), without unit
    count
};

/// Figures stated of the channel or load of an axis; empty where there is none.
template <std::size_t N>
struct AxisRow {
    std::size_t axis = 0;
    std::array<std::optional<double>, N> figures;
};
using Interference = AxisRow<most_channels>;
using StatedFigures = AxisRow<static_cast<std::size_t>(Figure::count)>;
using StatedInterference = AxisRow<most_channels + 1>;  ///< the last: largest of the row

/// The set-up as typed, SI.
struct StatedSensor {
    struct Channel {
        std::size_t axis = 0;
        std::optional<double> rated_force, rated_moment;
    };
    enum class Phase { zero_before, load, increasing, decreasing, zero_after };
    struct Reading {
        std::size_t loaded_axis = 0;
        bool preload = false;
        int run = 0;
        Phase phase = Phase::load;
        int step = 0;
        double load = 0.0;  ///< in load_unit
        std::string load_unit;
        std::optional<double> time;
        AxisFigures indicated;
    };
    struct Summary {
        std::size_t axis = 0;
        double rated_output = 0.0, zero_error = 0.0, u_A = 0.0, hysteresis = 0.0;
        std::optional<double> u_B;
    };
    std::vector<Channel> stated_channels;
    Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
    double diameter = 0.0, height = 0.0;  ///< of the housing, m
    double resolution = 0.0;
    std::optional<double> range;  ///< range of the indicator
    Offered<ForceCalibratorSource> calibrator;
    bool from_readings = true;
    std::vector<Reading> readings;
    std::vector<Summary> summary;
    std::vector<Interference> interference;
    bool has_signs = true;
    Plan plan;
    double k = 2.0;                     ///< coverage factor of Eq 12
    bool rows_are_loads = false;        ///< rows of Tables 2 and 4 are loads; else sensors
    std::vector<StatedFigures> stated;  ///< figures to be compared
    std::vector<StatedInterference> stated_interference;
};
const Fields<StatedSensor>& sensor_fields();

struct Calibration : StatedSensor {
    std::vector<ForceChannel> channels;
    std::vector<std::optional<double>> stated_u_b;  ///< taken instead of Eq 8, where given
    Eigen::MatrixXd rated_outputs;                  ///< rows: channels, columns: loads
    std::vector<Series> series;
    std::vector<std::vector<StepStatistics>> steps;

    std::size_t size() const { return channels.size(); }
    std::optional<std::size_t> channel_of(std::size_t axis) const;
    double u_calibrator(std::size_t h) const;          ///< Eq 5
    double u_resolution() const;                       ///< Eq 6
    double u_zero(std::size_t h) const;                ///< Eq 7
    double u_b_computed(std::size_t h) const;          ///< Eq 8
    double u_b(std::size_t h) const;                   ///< the stated one, else Eq 8
    double u_c(std::size_t h) const;                   ///< Eq 9
    double largest_interference(std::size_t h) const;  ///< Eq 11, of the channel's outputs
    double U(std::size_t h) const;                     ///< Eq 12a
};

/// The readings of the table, by channel and run; `problems` gets what is missing or cannot be.
void read_series(Calibration& calibration, Problems& problems);
/// Eqs 1 to 4, 7, 10, 11 and what they need.
void evaluate_series(Calibration& calibration, Problems& problems);
/// Rated outputs, zero errors ... as typed.
void read_summary(Calibration& calibration, Problems& problems);

std::vector<Table> calibration_tables(const Calibration& calibration);
Table stated_table(const Calibration& calibration);
std::vector<PlotSpecification> calibration_figures(const Calibration& calibration);

}  // namespace covaria::force
