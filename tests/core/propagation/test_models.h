// Small hand-written measurement models for tests of the engine.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/model/measurement_model.h"

namespace covaria::test {

/// A model of a plain function. Derivatives are those of the interface's default unless `derivatives` is set.
class FunctionModel : public MeasurementModel {
public:
    using Function = std::function<bool(std::span<const double>, std::span<double>)>;
    using Derivatives = std::function<bool(std::span<const double>, Eigen::MatrixXd&)>;

    FunctionModel(InputSet inputs, std::vector<OutputQuantity> outputs, Function function,
                  Derivatives derivatives = {})
        : inputs_(std::move(inputs)),
          outputs_(std::move(outputs)),
          function_(std::move(function)),
          derivatives_(std::move(derivatives)) {}

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    bool evaluate(std::span<const double> x, std::span<double> y) const override { return function_(x, y); }
    /// Gathers and scatters on the stack: no allocation, so that the engine's own can be counted.
    void evaluate_block(const TrialBlock& block) const override {
        double x[64], y[64];
        for (std::size_t t = 0; t < block.trials; ++t) {
            for (std::size_t i = 0; i < inputs_.quantities.size(); ++i)
                x[i] = block.inputs[i * block.stride + t];
            block.valid[t] = function_({x, inputs_.quantities.size()}, {y, outputs_.size()});
            for (std::size_t j = 0; j < outputs_.size(); ++j) block.outputs[j * block.stride + t] = y[j];
        }
    }
    bool jacobian(std::span<const double> x, Eigen::MatrixXd& jacobian) const override {
        return derivatives_ ? derivatives_(x, jacobian) : central_differences(x, jacobian);
    }
    Layout layout(std::span<const double>) const override { return {}; }

private:
    /// Steps of a small part of u, with one Richardson extrapolation.
    bool central_differences(std::span<const double> x, Eigen::MatrixXd& jacobian) const {
        std::vector<double> at(x.begin(), x.end()), above(outputs_.size()), below(outputs_.size());
        jacobian.resize(static_cast<Eigen::Index>(outputs_.size()), static_cast<Eigen::Index>(x.size()));
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double u = standard_uncertainty_of(inputs_, i);
            const double h = u > 0 ? 0.01 * u : 1e-6 * std::max(1.0, std::abs(x[i]));
            Eigen::VectorXd slopes[2];
            for (int k = 0; k < 2; ++k) {
                const double step = k == 0 ? h : 2 * h;
                at[i] = x[i] + step;
                if (!function_(at, above)) return false;
                at[i] = x[i] - step;
                if (!function_(at, below)) return false;
                at[i] = x[i];
                const Eigen::Map<Eigen::VectorXd> a(above.data(), jacobian.rows()),
                    b(below.data(), jacobian.rows());
                slopes[k] = (a - b) / (2 * step);
            }
            jacobian.col(static_cast<Eigen::Index>(i)) = (4 * slopes[0] - slopes[1]) / 3;
        }
        return true;
    }

    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
    Function function_;
    Derivatives derivatives_;
};

inline std::vector<OutputQuantity> outputs_named(const std::vector<std::string>& symbols) {
    std::vector<OutputQuantity> outputs;
    for (const std::string& symbol : symbols) {
        OutputQuantity output;
        output.symbol = symbol;
        output.name = symbol;
        outputs.push_back(output);
    }
    return outputs;
}

/// A quantity with one component of its own, whose distribution has the estimate as its mean.
inline void add_quantity(InputSet& inputs, const std::string& symbol, const Distribution& distribution,
                         double degrees_of_freedom = infinity) {
    UncertaintyComponent component;
    component.id = symbol;
    component.name = symbol;
    component.distribution = distribution;
    component.degrees_of_freedom = degrees_of_freedom;
    const std::size_t index = inputs.components.size();
    inputs.components.push_back(component);
    InputQuantity quantity;
    quantity.symbol = symbol;
    quantity.name = symbol;
    quantity.shares = {{index, 1.0}};
    inputs.quantities.push_back(quantity);
}

inline InputSet normal_inputs(const std::vector<std::pair<double, double>>& mean_and_u) {
    InputSet inputs;
    for (std::size_t i = 0; i < mean_and_u.size(); ++i)
        add_quantity(inputs, "x" + std::to_string(i + 1),
                     Distribution::of(Normal{mean_and_u[i].first, mean_and_u[i].second}));
    return inputs;
}

/// y = x1 + x2 + ...
inline FunctionModel sum_model(InputSet inputs) {
    return FunctionModel(
        std::move(inputs), outputs_named({"y"}),
        [](std::span<const double> x, std::span<double> y) {
            y[0] = 0;
            for (double v : x) y[0] += v;
            return true;
        },
        [](std::span<const double>, Eigen::MatrixXd& jacobian) {
            jacobian.setOnes();
            return true;
        });
}

/// JCGM 102 9.3: polar coordinates; the angle is periodic.
inline FunctionModel polar_model(InputSet inputs) {
    auto outputs = outputs_named({"r", "theta"});
    outputs[1].periodic = true;
    return FunctionModel(
        std::move(inputs), std::move(outputs),
        [](std::span<const double> x, std::span<double> y) {
            y[0] = std::hypot(x[0], x[1]);
            y[1] = std::atan2(x[1], x[0]);
            return true;
        },
        [](std::span<const double> x, Eigen::MatrixXd& jacobian) {
            const double r = std::hypot(x[0], x[1]);
            jacobian << x[0] / r, x[1] / r, -x[1] / (r * r), x[0] / (r * r);
            return r > 0;
        });
}

}  // namespace covaria::test
