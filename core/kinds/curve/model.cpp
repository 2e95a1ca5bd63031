// Measurement model "calibration curve": the model class and its descriptor.
#include "core/kinds/curve/model.h"

#include <cmath>

#include "core/base/name.h"
#include "core/kinds/curve/covariance.h"
#include "core/kinds/curve/evidence.h"
#include "core/model/equation_model.h"
#include "core/quantity/input_quantity.h"
#include "core/text/numbers.h"

namespace covaria {

namespace {

using curve::CurveSetup;
using curve::Fit;
using curve::InversePlace;

/// A share of the one s of the residuals.
UncertaintyComponent scatter(const CurveSetup& setup, std::string id, double u) {
    UncertaintyComponent component;
    component.id = std::move(id);
    component.name = tell<"scatter of the points about the curve">();
    component.unit = setup.y_unit.interval();
    component.distribution = Distribution::of(StudentT{0.0, u, setup.degrees_of_freedom()});
    component.type = EvaluationType::type_a;
    component.degrees_of_freedom = setup.degrees_of_freedom();
    component.origin = tell<"least squares, residuals of %1 points">(setup.points.size());
    return component;
}

UncertaintyComponent stated(std::string id, Message name, const Unit& unit, double u, Message origin) {
    UncertaintyComponent component;
    component.id = std::move(id);
    component.name = std::move(name);
    component.unit = unit.interval();
    component.distribution = Distribution::normal(u);
    component.origin = std::move(origin);
    return component;
}

/// The curve, and what is least for it: by the residuals, or by what is stated of the points.
const std::vector<ModelEquation>& curve_equations() {
    static const std::vector<ModelEquation> all{
        {"b(x) = y₁ + y₂ (x − x₀) + y₃ (x − x₀)² + …", tell<"JCGM 100, Eq H.12">()},
        {"min Σ (y_i − b(x_i))²", tell<"from the residuals, JCGM 100 H.3.2">()},
        {"min Σ (y_i − b(ξ_i))²/u²(y_i) + (x_i − ξ_i)²/u²(x_i)", tell<"as stated, York et al. 2004">()},
        {"min vᵀ V⁻¹ v, v = (x − ξ, y − b(ξ))", tell<"as stated with correlations, ISO/TS 28037, 10">()}};
    return all;
}

/// The curve with the terms that it has: "b(x) = y₁ + y₂ (x − x₀)".
ModelEquation curve_equation(const CurveSetup& setup) {
    std::string sum;
    for (std::size_t power = setup.first_power(); power <= setup.degree; ++power) {
        if (!sum.empty()) sum += " + ";
        sum += symbol_to_unicode("y_" + std::to_string(power + 1));
        if (power > 0) sum += " (x − x₀)";
        if (power > 1) sum += unicode_superscripts(std::to_string(power)).value_or("");
    }
    return {"b(x) = " + sum, curve_equations().front().source};
}

class CalibrationCurve : public EquationModel<CalibrationCurve> {
public:
    CalibrationCurve(CurveSetup setup, Fit fit, std::vector<InversePlace> inverse,
                     std::shared_ptr<const evidence::RedundantReadings> evidence)
        : setup_(std::move(setup)),
          fit_(std::move(fit)),
          inverse_(std::move(inverse)),
          evidence_(std::move(evidence)) {
        if (setup_.from_residuals)
            add_terms_as_inputs();
        else
            add_points_as_inputs();
        for (std::size_t i = 0; i < setup_.observations.size(); ++i) add_observation(i);
        if (estimate_.components.size() > 1) inputs_.variance_estimates.push_back(estimate_);
        for (std::size_t power = setup_.first_power(); power <= setup_.degree; ++power)
            outputs_.push_back({.symbol = "y_" + std::to_string(power + 1),
                                .name = power == 0 ? tell<"value of the curve at the origin">()
                                                   : tell<"coefficient of the power %1">(power),
                                .unit = power == 0 ? setup_.y_unit : curve::coefficient_unit(setup_, power),
                                .group = own_name<"curve">(),
                                .role = OutputRole::intermediate});
        for (std::size_t i = 0; i < setup_.predictions.size(); ++i) add_prediction(i);
        for (std::size_t i = 0; i < setup_.observations.size(); ++i) add_inverse(i);
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    Layout layout(std::span<const double>) const override { return {}; }
    std::vector<ModelEquation> formulas() const override {
        const std::vector<ModelEquation>& all = curve_equations();
        return {curve_equation(setup_), all[setup_.from_residuals ? 1 : setup_.has_covariance() ? 3 : 2]};
    }
    std::vector<Table> evaluation() const override { return curve::curve_evaluation(setup_, fit_, inverse_); }
    std::shared_ptr<const evidence::RedundantReadings> redundant_readings() const override {
        return evidence_;
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        const std::size_t n = setup_.coefficients();
        curve::Values<Real> change;  // change of the q from their estimates
        mask_of<Real> valid = changes(x, change);
        const auto linear = [&](const Eigen::MatrixXd& rows, std::size_t row, double estimate) {
            Real sum(estimate);
            for (std::size_t j = 0; j < n; ++j)
                sum = sum + Real(rows(Eigen::Index(row), Eigen::Index(j))) * change[j];
            return sum;
        };
        std::size_t output = 0;
        for (std::size_t c = 0; c < n; ++c) y.set(output++, linear(fit_.powers, c, fit_.coefficients[c]));
        for (std::size_t i = 0; i < setup_.predictions.size(); ++i)
            y.set(output++, linear(fit_.at_predictions, i, fit_.predicted[i]));
        for (std::size_t j = 0; j < n; ++j) change[j] = Real(fit_.q[j]) + change[j];
        const curve::Polynomials& polynomials = fit_.polynomials;
        for (std::size_t i = 0; i < inverse_.size(); ++i) {
            Real t;
            valid = curve::place_of(polynomials, change, Real(x[first_observation_ + i]), inverse_[i], t) &&
                    valid;
            y.set(output++, Real(polynomials.centre) + Real(polynomials.half_width) * t);
        }
        return valid;
    }

private:
    template <class Real>
    mask_of<Real> changes(const Inputs<Real>& x, curve::Values<Real>& change) const {
        const std::size_t n = setup_.coefficients(), points = setup_.points.size();
        change.fill(Real(0.0));
        if (setup_.from_residuals) {
            for (std::size_t j = 0; j < n; ++j) change[j] = x[j] - Real(fit_.q[j]);
        } else if (!setup_.has_u_x()) {
            for (std::size_t i = 0; i < points; ++i) {
                const Real moved = x[i] - Real(setup_.points[i].y);
                for (std::size_t j = 0; j < n; ++j)
                    change[j] = change[j] + Real(fit_.gain(Eigen::Index(j), Eigen::Index(i))) * moved;
            }
        } else {
            return changes_with_both(x, change);
        }
        return Real(0.0) == Real(0.0);
    }

    template <class Real>
    mask_of<Real> changes_with_both(const Inputs<Real>& x, curve::Values<Real>& change) const {
        const std::size_t n = setup_.coefficients();
        for (std::size_t j = 0; j < n; ++j) change[j] = Real(fit_.q[j]);
        const auto place = [&](std::size_t i) {
            return of_x_[i] == InputSet::npos ? Real(setup_.points[i].x) : Real(x[of_x_[i]]);
        };
        const auto height = [&](std::size_t i) { return Real(x[i]); };
        Real squares(0.0);
        const mask_of<Real> settled =
            covariance_
                ? curve::fit_with_covariance<Real>(*covariance_, fit_.polynomials, setup_.points.size(),
                                                   place, height, change, squares)
                : curve::fit_with_both<Real>(setup_, fit_.polynomials, place, height, change);
        for (std::size_t j = 0; j < n; ++j) change[j] = change[j] - Real(fit_.q[j]);
        return settled;
    }

    /// Makes the terms inputs, which are uncorrelated (JCGM 100 H.3.5); all have the one s of the residuals.
    void add_terms_as_inputs() {
        for (std::size_t j = 0; j < fit_.q.size(); ++j) {
            const std::string symbol = "q_" + std::to_string(j + 1);
            const bool is_mean = j == 0 && !setup_.through_origin;
            InputQuantity quantity{.symbol = symbol,
                                   .name = is_mean ? tell<"mean of y">()
                                                   : tell<"term of degree %1 (orthonormal polynomial)">(
                                                         j + setup_.first_power()),
                                   .unit = is_mean ? setup_.y_unit : setup_.y_unit.interval(),
                                   .offset = fit_.q[j],
                                   .group = own_name<"curve">()};
            share_of_scatter(quantity, symbol + ".residuals", fit_.u_of_q);
            inputs_.quantities.push_back(std::move(quantity));
        }
    }

    void share_of_scatter(InputQuantity& quantity, std::string id, double u) {
        if (!(u > 0.0)) return;
        const std::size_t component = inputs_.add(scatter(setup_, std::move(id), u));
        quantity.shares.push_back({component, 1.0});
        estimate_.components.push_back(component);
    }

    void add_coordinate(std::size_t i, const char* axis, double value, double u, const Unit& unit) {
        const bool is_x = axis == std::string("x");
        const evidence::TakenFactor& seen = is_x ? setup_.seen_x : setup_.seen_y;
        const std::string symbol = std::string(axis) + "_" + std::to_string(i + 1);
        inputs_.add({.symbol = symbol,
                     .name = tell<"%1 of point %2">(axis, i + 1),
                     .unit = unit,
                     .offset = value,
                     .group = is_x ? own_name<"points, x">() : own_name<"points, y">(),
                     .source = curve::curve_fields().place(&CurveSetup::stated_points, i)},
                    {stated(symbol + ".stated", tell<"stated uncertainty of %1">(axis), unit, u,
                            tell<"table of points">())});
        if (!seen.is_seen()) return;
        UncertaintyComponent& component = inputs_.components.back();
        component.type = EvaluationType::type_a;
        component.degrees_of_freedom = seen.degrees_of_freedom;
        component.origin =
            tell<"as seen: %1 times what was stated">(Message::number(format_significant(seen.factor, 3)));
        const bool one = setup_.uncertainties == evidence::UncertaintiesFrom::one_factor;
        inputs_.rest_on_estimate(one || !is_x ? "seen.y" : "seen.x", inputs_.components.size() - 1);
    }

    void add_points_as_inputs() {
        for (std::size_t i = 0; i < setup_.points.size(); ++i)
            add_coordinate(i, "y", setup_.points[i].y, setup_.points[i].u_y, setup_.y_unit);
        for (std::size_t i = 0; i < setup_.points.size(); ++i) {
            const bool uncertain = setup_.points[i].u_x > 0.0 || setup_.common_u_x > 0.0;
            of_x_.push_back(uncertain ? inputs_.quantities.size() : InputSet::npos);
            if (uncertain) add_coordinate(i, "x", setup_.points[i].x, setup_.points[i].u_x, setup_.x_unit);
        }
        if (setup_.common_u_x > 0.0) add_common("x", setup_.common_u_x, setup_.x_unit);
        if (setup_.common_u_y > 0.0) add_common("y", setup_.common_u_y, setup_.y_unit);
        for (const curve::StatedCorrelation& stated : setup_.correlations)
            inputs_.correlations.push_back(
                {component_of(stated.first), component_of(stated.second), stated.coefficient});
        if (setup_.has_covariance() && setup_.has_u_x()) covariance_.emplace(setup_, fit_.polynomials);
    }

    /// Adds one component that all coordinates of an axis have.
    void add_common(const char* axis, double u, const Unit& unit) {
        const std::size_t component =
            inputs_.add(stated(std::string(axis) + ".common", tell<"common deviation of all %1">(axis), unit,
                               u, tell<"stated for all points">()));
        for (InputQuantity& quantity : inputs_.quantities)
            if (quantity.symbol.starts_with(std::string(axis) + "_"))
                quantity.shares.push_back({component, 1.0});
    }

    std::size_t component_of(const std::string& coordinate) const {
        return inputs_.quantities[inputs_.find(coordinate)].shares.front().component;
    }

    void add_observation(std::size_t i) {
        if (i == 0) first_observation_ = inputs_.quantities.size();
        const curve::Observation& o = setup_.observations[i];
        const std::string symbol = "Y_" + std::to_string(i + 1);
        InputQuantity quantity{
            .symbol = symbol,
            .name = o.name.empty() ? tell<"observed y">() : tell<"%1, observed y">(o.name),
            .unit = setup_.y_unit,
            .offset = o.y,
            .group = own_name<"inverse use">(),
            .source = curve::curve_fields().place(&CurveSetup::observations, i, &curve::Observation::y)};
        if (o.u_y > 0.0)
            quantity.shares.push_back(
                {inputs_.add(stated(symbol + ".stated", tell<"stated uncertainty of %1">("y"), setup_.y_unit,
                                    o.u_y, tell<"table of the inverse use">())),
                 1.0});
        if (o.readings > 0)
            share_of_scatter(quantity, symbol + ".readings", fit_.standard_deviation / std::sqrt(o.readings));
        inputs_.quantities.push_back(std::move(quantity));
    }

    void add_prediction(std::size_t i) {
        const curve::Prediction& p = setup_.predictions[i];
        const Message where = tell<"value of the curve at %1">(curve::place_text(setup_.x_unit, p.x));
        outputs_.push_back({.symbol = "b_" + std::to_string(i + 1),
                            .name = p.name.empty() ? where : tell<"%1, %2">(p.name, where),
                            .unit = setup_.y_unit,
                            .group = own_name<"use">()});
    }

    void add_inverse(std::size_t i) {
        const curve::Observation& o = setup_.observations[i];
        const Message where = tell<"x where the curve is %1">(curve::place_text(setup_.y_unit, o.y));
        outputs_.push_back({.symbol = "X_" + std::to_string(i + 1),
                            .name = o.name.empty() ? where : tell<"%1, %2">(o.name, where),
                            .unit = setup_.x_unit,
                            .group = own_name<"inverse use">()});
    }

    CurveSetup setup_;
    Fit fit_;
    std::vector<InversePlace> inverse_;
    std::shared_ptr<const evidence::RedundantReadings> evidence_;  ///< evidence about what was stated
    InputSet inputs_;
    VarianceEstimate estimate_;  ///< the residuals' s
    std::vector<OutputQuantity> outputs_;
    std::optional<curve::PointCovariance> covariance_;  ///< set with uncertainties in x
    std::vector<std::size_t> of_x_;                     ///< input of each point's x; npos: a constant
    std::size_t first_observation_ = 0;
};

std::unique_ptr<MeasurementModel> create_curve_model(const SetupReader& reader, const AssetLibrary& assets,
                                                     Problems& problems) {
    auto setup = curve::read_curve_setup(reader, assets, problems);
    if (!setup) return nullptr;
    auto fit = curve::fit_of(*setup);
    const auto evidence = fit ? curve::redundant_readings(*setup, *fit) : nullptr;
    if (fit) curve::take_as_seen(*setup, evidence.get(), problems);
    if (setup->seen_x.is_seen() || setup->seen_y.is_seen()) fit = curve::fit_of(*setup);
    if (!fit) {
        problems.error(curve::curve_fields().place(&CurveSetup::stated_points),
                       setup->has_u_x() ? tell<"no curve of this degree was found: the iteration for the "
                                               "uncertainties of x does not settle on these points">()
                                        : tell<"the points do not determine a curve of this degree">());
        return nullptr;
    }
    std::vector<InversePlace> inverse;
    for (std::size_t i = 0; i < setup->observations.size(); ++i) {
        const std::string place =
            curve::curve_fields().place(&CurveSetup::observations, i, &curve::Observation::y);
        const auto found = curve::inverse_place(*setup, *fit, setup->observations[i]);
        if (!found) {
            problems.error(place, found.error().message);
            continue;
        }
        if (found->outside)
            problems.warning(place, tell<"the x of y = %1 lies outside of the points of the calibration">(
                                        curve::place_text(setup->y_unit, setup->observations[i].y)));
        inverse.push_back(*found);
    }
    if (problems.has_errors()) return nullptr;
    return std::make_unique<CalibrationCurve>(std::move(*setup), std::move(*fit), std::move(inverse),
                                              evidence);
}

}  // namespace

ModelDescriptor calibration_curve_model() {
    ModelDescriptor d;
    d.id = "calibration-curve";
    d.title = "Calibration curve";
    d.summary =
        "A straight line or polynomial through the points of a calibration by least squares, with "
        "uncertainties in y and in x: the covariance of its coefficients, its values, and the x that belong "
        "to observed y, with their uncertainties.";
    d.references = {
        {"JCGM 100:2008 (GUM), H.3"},
        {"D. York, N. M. Evensen, M. L. Martínez, J. De Basabe Delgado: Unified equations for the slope, "
         "intercept, and standard errors of the best straight line, Am. J. Phys. 72 (2004) 367"},
        {"ISO/TS 28037:2010"}};
    d.equations = curve_equations();
    d.notes = {
        "Computed with polynomials that are orthonormal over the points, so results do not depend on the "
        "origin, up to degree 10. From the residuals their coefficients are drawn from a multivariate t "
        "distribution: one estimate of the scatter, n - p degrees of freedom for every result.",
        "JCGM 100 H.3, published y₁ = −0.1712 °C, y₂ = 0.002 18, u(y₁) = 0.0029 °C, u(y₂) = 0.000 67, b(30 "
        "°C) = "
        "−0.1494 °C with u = 0.0041 °C: reproduces.",
        "The uncertainty of b(x) is that of the curve: the scatter of a further observation is not part of "
        "it."};
    d.help_page = "calibration-curve.md";
    d.example = "gum/h3-thermometer.covaria";
    d.schema = curve::curve_fields().schema();
    d.create = create_curve_model;
    return d;
}

}  // namespace covaria
