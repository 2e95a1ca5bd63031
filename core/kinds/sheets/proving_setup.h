// The set-up of "force-proving instrument" (ISO 376): indications under known forces, what else enters its
// uncertainty, limits of classes.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/kinds/force/force_sensor.h"
#include "core/model/offered.h"
#include "core/setup/fields.h"

namespace covaria::sheets {

/// Series with increasing forces. Decreasing forces follow upon the third and the fourth of them.
enum class ProvingSeries { first, again, turned, turned_again };
inline constexpr std::size_t proving_series = 4;
inline constexpr std::array<const char*, proving_series> series_symbols{"X1", "X2", "X3", "X5"};

/// Indications (V/V) under one force (N), as read; after `read_proving_setup` deflections: less that without
/// load before the series.
struct ForceStep {
    double force = 0.0;
    std::optional<double> machine_U;              ///< relative expanded uncertainty of the force, k = 2
    std::array<double, proving_series> rising{};  ///< X1, X2, X3, X5
    std::optional<double> falling_3, falling_5;   ///< X4', X6': decreasing, after X3 and X5

    /// Mean of the rotations X1, X3, X5.
    double mean() const { return (rising[0] + rising[2] + rising[3]) / 3.0; }
};

/// Indications without load.
struct UnloadedReadings {
    ProvingSeries series = ProvingSeries::first;
    double before = 0.0, after = 0.0;
};

/// Largest errors of a class, relative; an empty one is held against nothing.
struct ClassLimits {
    std::string name;
    std::optional<double> b, b_same, f_c, f_0, v, c, machine_U;
};

struct ProvingSetup {
    std::vector<ForceStep> steps;  ///< by rising force
    std::vector<UnloadedReadings> unloaded;
    Offered<ForceCalibratorSource> machine;
    std::size_t axis = 2;                       ///< of the machine, index in force_axes
    double resolution = 0.0;                    ///< V/V
    std::optional<double> creep_30, creep_300;  ///< indications 30 s and 300 s after the load was taken off
    double temperature_coefficient = 0.0;       ///< relative, 1/K
    double temperature_half_width = 0.0;        ///< K
    bool decreasing = false;                    ///< the instrument is used with decreasing forces too
    double reversibility_divisor = 3.0;         ///< v over it is a standard uncertainty
    int degree = 3;                             ///< of the deflection over the force
    bool with_constant = true;
    bool residual_of_largest = true;  ///< residuals count relative to the largest deflection
    bool student_t = false;           ///< Type A draws
    double k = 2.0;
    int uncertainty_degree = 2;        ///< of W over the force
    std::vector<ClassLimits> classes;  ///< the strictest first

    Unit force_unit;  ///< as typed
    double largest_force() const { return steps.back().force; }
    double largest_deflection() const { return steps.back().mean(); }
    std::size_t coefficients() const { return std::size_t(degree) + (with_constant ? 1 : 0); }
    std::size_t first_power() const { return with_constant ? 0 : 1; }
    double degrees_of_freedom() const { return double(steps.size()) - double(coefficients()); }
    /// Relative standard uncertainty of the machine's force at a step.
    double u_machine(const ForceStep& step) const;
    std::string label(const ForceStep& step) const;  ///< "10 kN"
};

const Fields<ProvingSetup>& proving_fields();
std::optional<ProvingSetup> read_proving_setup(const SetupReader& reader, const AssetLibrary& assets,
                                               Problems& problems);

}  // namespace covaria::sheets
