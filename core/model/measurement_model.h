// The interface between measurement models and the engine: y = f(x), one method wide; the rest has defaults.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/model/layout.h"
#include "core/model/output_quantity.h"
#include "core/quantity/input_quantity.h"
#include "core/text/formula.h"
#include "core/text/plot_specification.h"
#include "core/text/table.h"

namespace covaria {

class Asset;  // core/model/asset.h
namespace evidence {
struct RedundantReadings;  // core/evidence/redundant_readings.h
}

/// A block of trials, structure of arrays: quantity i of trial t is inputs[i * stride + t], output j is
/// outputs[j * stride + t]. `stride` is a multiple of 8 and all rows are 64-byte aligned; lanes from `trials`
/// to the next multiple of 8 may be read and written (the engine fills them with copies of a valid trial).
struct TrialBlock {
    const double* inputs = nullptr;
    double* outputs = nullptr;
    std::uint8_t* valid = nullptr;  ///< set to 1 or 0 for each trial
    std::size_t stride = 0;
    std::size_t trials = 0;
};

/// dy/dx_i of one output quantity.
struct Sensitivity {
    std::size_t input = 0;
    double coefficient = 0.0;
};
/// [output]: by rising input; inputs that are left out have no effect.
using SensitivityRows = std::vector<std::vector<Sensitivity>>;

/// Sensitivity coefficients at one place, an output at a time: for models whose rows together do not fit into
/// memory. Safe to use from many threads at once; the model outlives it.
class SensitivitySource {
public:
    virtual ~SensitivitySource() = default;
    /// The row of an output, by rising input, in place of what `row` holds. false: it has none.
    virtual bool row(std::size_t output, std::vector<Sensitivity>& row) const = 0;
};

struct ModelEquation {
    Message text;          ///< Unicode: "o_p^b = R_bᵀ (o_p − o_b)"; words in it are told
    Message source;        ///< "Porath et al., Eq. 19, corrected"
    Formula formula = {};  ///< the same as a formula, where there is one
};

/// Immutable after construction and safe to use from many threads at once. Everything is SI.
class MeasurementModel {
public:
    virtual ~MeasurementModel() = default;

    /// Input quantities with their default components.
    virtual const InputSet& inputs() const = 0;
    virtual const std::vector<OutputQuantity>& outputs() const = 0;

    /// y = f(x) for one trial. false: this trial has no value (negative root, singular geometry); y is then
    /// unspecified. Never leaves NaN behind a `true`.
    virtual bool evaluate(std::span<const double> x, std::span<double> y) const = 0;

    /// Many trials at once, without allocation. Default: `evaluate` for each.
    virtual void evaluate_block(const TrialBlock& block) const;

    /// Sensitivity coefficients: jacobian(j, i) = dy_j/dx_i at x (outputs x inputs). Default: central
    /// differences with Richardson extrapolation. false: no value at x.
    virtual bool jacobian(std::span<const double> x, Eigen::MatrixXd& jacobian) const;

    /// The same without what is zero, for models with so many quantities that the matrix does not fit into
    /// memory. Default: from `jacobian`.
    virtual bool sensitivities(std::span<const double> x, SensitivityRows& rows) const;

    /// The same row by row; null where the model can only make all of them, or has no value at x.
    virtual std::unique_ptr<const SensitivitySource> sensitivity_source(std::span<const double> /*x*/) const {
        return nullptr;
    }

    /// Layout of things when the inputs are x, in metrology words; see layout.h.
    virtual Layout layout(std::span<const double> x) const = 0;

    /// The model's own equations, where they are not those of its descriptor.
    virtual std::vector<ModelEquation> formulas() const { return {}; }

    /// Tables about the set-up beside the outputs (residuals, redundancy ...).
    virtual std::vector<Table> evaluation() const { return {}; }
    /// Charts of the same; ids are unique in the model.
    virtual std::vector<PlotSpecification> figures() const { return {}; }

    /// Readings that are more than its unknowns need: evidence for or against what is stated of them.
    /// Null: it has none.
    virtual std::shared_ptr<const evidence::RedundantReadings> redundant_readings() const { return nullptr; }

    /// The asset that stands for an analysis of this model (`id`) where a set-up asks for one: its outputs as
    /// points, or as a robot. Null: nothing does.
    virtual std::shared_ptr<const Asset> as_asset(const std::string& /*id*/) const { return nullptr; }

    MeasurementModel() = default;
    MeasurementModel(const MeasurementModel&) = delete;
    MeasurementModel& operator=(const MeasurementModel&) = delete;
};

}  // namespace covaria
