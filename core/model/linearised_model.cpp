#include "core/model/linearised_model.h"

#include <algorithm>
#include <utility>

namespace covaria {

namespace {

class LinearisedModel : public MeasurementModel {
public:
    LinearisedModel(std::shared_ptr<const MeasurementModel> model, InputSet inputs)
        : model_(std::move(model)), inputs_(std::move(inputs)), y_0_(model_->outputs().size()) {
        for (std::size_t i = 0; i < inputs_.quantities.size(); ++i) x_0_.push_back(estimate_of(inputs_, i));
    }

    bool has_value() { return model_->evaluate(x_0_, y_0_) && model_->sensitivities(x_0_, rows_); }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return model_->outputs(); }

    bool evaluate(std::span<const double> x, std::span<double> y) const override {
        for (std::size_t j = 0; j < rows_.size(); ++j) {
            y[j] = y_0_[j];
            for (const Sensitivity& s : rows_[j]) y[j] += s.coefficient * (x[s.input] - x_0_[s.input]);
        }
        return true;
    }

    void evaluate_block(const TrialBlock& block) const override {
        std::fill_n(block.valid, block.trials, std::uint8_t{1});
        for (std::size_t j = 0; j < rows_.size(); ++j) {
            double* const y = block.outputs + j * block.stride;
            std::fill_n(y, block.trials, y_0_[j]);
            for (const Sensitivity& s : rows_[j]) {
                const double* const x = block.inputs + s.input * block.stride;
                for (std::size_t t = 0; t < block.trials; ++t) y[t] += s.coefficient * (x[t] - x_0_[s.input]);
            }
        }
    }

    bool sensitivities(std::span<const double>, SensitivityRows& rows) const override {
        rows = rows_;
        return true;
    }

    Layout layout(std::span<const double> x) const override { return model_->layout(x); }

private:
    std::shared_ptr<const MeasurementModel> model_;
    InputSet inputs_;
    std::vector<double> x_0_, y_0_;
    SensitivityRows rows_;
};

}  // namespace

std::shared_ptr<const MeasurementModel> linearised(std::shared_ptr<const MeasurementModel> model,
                                                   const InputSet& inputs) {
    auto made = std::make_shared<LinearisedModel>(std::move(model), inputs);
    return made->has_value() ? made : nullptr;
}

bool is_linearised(const MeasurementModel& model) {
    return dynamic_cast<const LinearisedModel*>(&model) != nullptr;
}

}  // namespace covaria
