// Measurement model "history of an instrument": the model class and its descriptor.
#include "core/kinds/sheets/history_model.h"

#include "core/kinds/sheets/history_fit.h"
#include "core/model/equation_model.h"

namespace covaria {

namespace {

using sheets::HistoryFit;
using sheets::HistorySetup;

const std::vector<ModelEquation>& history_equations() {
    static const std::vector<ModelEquation> all{
        {"v_i = A + D_a (t_i − t_m) + e_i,  min Σ w_i e_i²",
         tell<"values found, without the adjustments; t in years, t_m their weighted mean">()},
        {"d = D_a (t − t_n)", tell<"drift since the last calibration, on the date of use">()},
        {"V = A + D_a (t − t_m) + e + c", tell<"value on the date of use; c is what all values share">()}};
    return all;
}

/// Level and rate of the line are its input quantities; about the mean of the dates they are not correlated.
class InstrumentHistory : public EquationModel<InstrumentHistory> {
public:
    InstrumentHistory(HistorySetup setup, HistoryFit fit) : setup_(std::move(setup)), fit_(std::move(fit)) {
        add_inputs();
        if (setup_.use) {
            const Days first = setup_.values.front().day, last = setup_.values.back().day;
            since_last_ = sheets::years_between(last, *setup_.use);
            arm_ = sheets::years_between(first, *setup_.use) - fit_.middle;
        }
        add_outputs();
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    Layout layout(std::span<const double>) const override { return {}; }
    std::vector<Table> evaluation() const override { return sheets::history_tables(setup_, fit_); }
    std::vector<PlotSpecification> figures() const override { return sheets::history_figures(setup_, fit_); }
    std::vector<ModelEquation> formulas() const override {
        const auto& all = history_equations();
        return setup_.use ? all : std::vector<ModelEquation>{all.front()};
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        y.set(0, x[1]);
        if (setup_.use) {
            y.set(1, Real(since_last_) * x[1]);
            y.set(2, x[0] + Real(arm_) * x[1] + x[2] + x[3]);
        }
        return Real(0.0) == Real(0.0);
    }

private:
    void add(InputQuantity quantity, const Message& of_component, double u) {
        std::vector<UncertaintyComponent> own;
        if (u > 0.0) {
            UncertaintyComponent component;
            component.id = quantity.symbol + (setup_.from_residuals ? ".residuals" : ".stated");
            component.name = of_component;
            component.unit = setup_.unit.interval();
            if (setup_.from_residuals) {
                component.distribution = Distribution::of(StudentT{0.0, u, fit_.degrees_of_freedom});
                component.type = EvaluationType::type_a;
                component.degrees_of_freedom = fit_.degrees_of_freedom;
            } else {
                component.distribution = Distribution::normal(u);
            }
            component.origin = tell<"least squares, %1 calibrations">(setup_.values.size());
            own.push_back(std::move(component));
        }
        inputs_.add(std::move(quantity), std::move(own));
        if (setup_.from_residuals && u > 0.0) estimate_.components.push_back(inputs_.components.size() - 1);
    }

    void add_inputs() {
        const Unit difference = setup_.unit.interval();
        add({.symbol = "A",
             .name = tell<"level of the line, at the mean of the dates">(),
             .unit = setup_.unit,
             .offset = setup_.reference + setup_.adjusted + fit_.level},
            tell<"scatter about the line">(), fit_.u_level);
        add({.symbol = "D_a", .name = tell<"drift in a year">(), .unit = difference, .offset = fit_.rate},
            tell<"scatter about the line">(), fit_.u_rate);
        if (!setup_.use) return finish();
        add({.symbol = "e", .name = tell<"scatter of one value about the line">(), .unit = difference},
            tell<"scatter about the line">(), fit_.s);
        UncertaintyComponent common;
        common.id = "c.common";
        common.name = tell<"deviation that all values share">();
        common.unit = difference;
        common.distribution = Distribution::normal(setup_.common_u);
        common.origin = tell<"typed standard uncertainty">();
        std::vector<UncertaintyComponent> own;
        if (setup_.common_u > 0.0) own.push_back(std::move(common));
        inputs_.add({.symbol = "c", .name = tell<"deviation that all values share">(), .unit = difference},
                    std::move(own));
        finish();
    }

    /// All components of the scatter have the one s of the residuals.
    void finish() {
        if (!estimate_.components.empty()) inputs_.variance_estimates.push_back(std::move(estimate_));
    }

    void add_outputs() {
        const Unit difference = setup_.unit.interval();
        outputs_.push_back({.symbol = "D_a", .name = tell<"drift in a year">(), .unit = difference});
        if (!setup_.use) return;
        outputs_.push_back({.symbol = "d",
                            .name = tell<"drift since the last calibration, %1">(setup_.used_on),
                            .unit = difference});
        outputs_.push_back({.symbol = setup_.symbol, .name = setup_.name, .unit = setup_.unit});
    }

    HistorySetup setup_;
    HistoryFit fit_;
    InputSet inputs_;
    VarianceEstimate estimate_{"history", {}};
    std::vector<OutputQuantity> outputs_;
    double since_last_ = 0.0, arm_ = 0.0;  ///< years from the last calibration, and from the mean, to the use
};

std::unique_ptr<MeasurementModel> create_history(const SetupReader& reader, const AssetLibrary& assets,
                                                 Problems& problems) {
    auto setup = sheets::read_history_setup(reader, assets, problems);
    if (!setup) return nullptr;
    HistoryFit fit = sheets::fit_of(*setup);
    if (const auto due = sheets::due_day(*setup, fit); due && due->at_once)
        problems.warning(sheets::history_fields().place(&sheets::StatedHistory::limit),
                         tell<"the limit is not kept even on the day of the last calibration">());
    return std::make_unique<InstrumentHistory>(std::move(*setup), std::move(fit));
}

}  // namespace

ModelDescriptor history_model() {
    ModelDescriptor d;
    d.id = "instrument-history";
    d.title = "History of an instrument";
    d.summary =
        "The drift of an instrument or standard from what its calibrations found, with its uncertainty: the "
        "component for its next use, and the day on which its next calibration is due.";
    d.references = {{"JCGM 100:2008 (GUM), 4.3.7, F.2.4.5, H.3"},
                    {"ILAC-G24:2022 / OIML D 10:2022, Guidelines for the determination of recalibration "
                     "intervals"}};
    d.equations = history_equations();
    d.notes = {
        "The drift is taken as linear. Residuals in the evaluation show whether it is.",
        "Adjustments are taken out of the series by their differences as left less as found; these count as "
        "exact, because both are values of one calibration.",
        "What all calibrations share has no part in the drift. The scatter about the line is part of the "
        "value on a date of use: the instrument may lie off its line as it did before.",
        "A year has 365.25 days."};
    d.help_page = "instrument-history.md";
    d.example = "gauge-block-history.covaria";
    d.schema = sheets::history_fields().schema();
    d.create = create_history;
    return d;
}

}  // namespace covaria
