// Measurement model "calibration curve": the model class and its descriptor.
#include "core/models/calibration_curve.h"

#include <cmath>
#include <cstdio>

#include "core/model/equation_model.h"
#include "core/models/curve_equations.h"

namespace covaria {

namespace {

using curve::CurveSetup;
using curve::Fit;

class CalibrationCurve : public EquationModel<CalibrationCurve> {
public:
    CalibrationCurve(CurveSetup setup, Fit fit) : setup_(std::move(setup)), fit_(std::move(fit)) {
        if (setup_.from_residuals)
            add_coefficients_as_inputs();
        else
            add_points_as_inputs();
        for (std::size_t k = 0; k < setup_.coefficients; ++k)
            outputs_.push_back({.symbol = symbol(k),
                                .name = k == 0 ? "value of the curve at the origin"
                                               : "coefficient of the power " + std::to_string(k),
                                .unit = curve::coefficient_unit(setup_, k),
                                .group = "curve",
                                .role = OutputRole::intermediate});
        for (std::size_t i = 0; i < setup_.predictions.size(); ++i) add_prediction(i);
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    Layout layout(std::span<const double>) const override { return {}; }
    std::vector<DataTable> evaluation() const override { return curve::curve_evaluation(setup_, fit_); }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        const std::size_t n = setup_.coefficients;
        curve::Coefficients<Real> a;
        if (setup_.from_residuals) {
            for (std::size_t k = 0; k < n; ++k) a[k] = x[k] * Real(std::pow(setup_.scale, double(k)));
        } else {
            const std::size_t points = setup_.points.size();
            a = curve::weighted_curve<Real>(
                setup_,
                [&](std::size_t i) {
                    return of_x_[i] == InputSet::npos ? Real(setup_.points[i].x) : Real(x[of_x_[i]]);
                },
                [&](std::size_t i) { return Real(x[i < points ? i : 0]); });
        }
        for (std::size_t k = 0; k < n; ++k) y.set(k, a[k] * Real(std::pow(setup_.scale, -double(k))));
        for (std::size_t i = 0; i < setup_.predictions.size(); ++i) {
            const double t = (setup_.predictions[i].x - setup_.origin) / setup_.scale;
            y.set(n + i, curve::polynomial_at(a, n, Real(t)));
        }
        return Real(0.0) == Real(0.0);
    }

private:
    static std::string symbol(std::size_t k) { return "y_" + std::to_string(k + 1); }

    /// As JCGM 100 H.3: the coefficients, correlated, with the degrees of freedom of the residuals.
    void add_coefficients_as_inputs() {
        const double nu = setup_.degrees_of_freedom();
        for (std::size_t k = 0; k < setup_.coefficients; ++k) {
            const auto i = static_cast<Eigen::Index>(k);
            UncertaintyComponent component;
            component.id = "a_" + std::to_string(k) + ".residuals";
            component.name = "scatter of the points about the curve";
            component.unit = curve::coefficient_unit(setup_, k);
            component.distribution = Distribution::of(StudentT{0.0, std::sqrt(fit_.covariance(i, i)), nu});
            component.type = EvaluationType::type_a;
            component.degrees_of_freedom = nu;
            component.origin =
                "least squares, residuals of " + std::to_string(setup_.points.size()) + " points";
            inputs_.add({.symbol = "a_" + std::to_string(k),
                         .name = "coefficient of the power " + std::to_string(k),
                         .unit = component.unit,
                         .offset = fit_.coefficients[i],
                         .group = "curve"},
                        {component});
        }
        for (Eigen::Index i = 0; i < fit_.covariance.rows(); ++i)
            for (Eigen::Index j = i + 1; j < fit_.covariance.cols(); ++j)
                inputs_.correlations.push_back(
                    {static_cast<std::size_t>(i), static_cast<std::size_t>(j),
                     fit_.covariance(i, j) / std::sqrt(fit_.covariance(i, i) * fit_.covariance(j, j))});
    }

    void add_coordinate(std::size_t i, const char* axis, double value, double u, const Unit& unit) {
        const std::string name = std::string(axis) + "_" + std::to_string(i + 1);
        UncertaintyComponent component;
        component.id = name + ".stated";
        component.name = std::string("stated uncertainty of ") + axis;
        component.unit = unit.to_si(0.0) == 0.0 ? unit : Unit::of("K");
        component.distribution = Distribution::normal(u);
        component.origin = "table of points";
        inputs_.add({.symbol = name,
                     .name = std::string(axis) + " of point " + std::to_string(i + 1),
                     .unit = unit,
                     .offset = value,
                     .group = std::string("points, ") + axis,
                     .source = "/points/rows/" + std::to_string(i)},
                    {component});
    }

    void add_points_as_inputs() {
        for (std::size_t i = 0; i < setup_.points.size(); ++i)
            add_coordinate(i, "y", setup_.points[i].y, setup_.points[i].u_y, setup_.y_unit);
        for (std::size_t i = 0; i < setup_.points.size(); ++i) {
            of_x_.push_back(setup_.points[i].u_x > 0.0 ? inputs_.quantities.size() : InputSet::npos);
            if (setup_.points[i].u_x > 0.0)
                add_coordinate(i, "x", setup_.points[i].x, setup_.points[i].u_x, setup_.x_unit);
        }
    }

    void add_prediction(std::size_t i) {
        const curve::Prediction& p = setup_.predictions[i];
        char place[64];
        std::snprintf(place, sizeof place, "%.12g", setup_.x_unit.from_si(p.x));
        const std::string where = std::string("value of the curve at ") + place +
                                  (setup_.x_unit == Unit{} ? "" : " " + setup_.x_unit.display());
        outputs_.push_back({.symbol = "b_" + std::to_string(i + 1),
                            .name = p.name.empty() ? where : p.name + ", " + where,
                            .unit = setup_.y_unit,
                            .group = "use"});
    }

    CurveSetup setup_;
    Fit fit_;
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
    std::vector<std::size_t> of_x_;  ///< input of each point's x; npos: a constant
};

std::unique_ptr<MeasurementModel> create_curve_model(const SetupReader& reader, const AssetLibrary&,
                                                     Problems& problems) {
    auto setup = curve::read_curve_setup(reader, problems);
    if (!setup) return nullptr;
    Fit fit = curve::fit_of(*setup);
    if (!fit.coefficients.allFinite() || !fit.covariance.allFinite()) {
        problems.error("/points", "the points do not determine a curve of this degree");
        return nullptr;
    }
    return std::make_unique<CalibrationCurve>(std::move(*setup), std::move(fit));
}

}  // namespace

ModelDescriptor calibration_curve_model() {
    ModelDescriptor d;
    d.id = "calibration-curve";
    d.title = "Calibration curve";
    d.summary =
        "A straight line or polynomial through the points of a calibration by least squares, with "
        "uncertainties in "
        "y and in x, the covariance of its coefficients, and its values with their uncertainties.";
    d.references = {
        {"JCGM 100:2008 (GUM), H.3"},
        {"D. York, N. M. Evensen, M. L. Martínez, J. De Basabe Delgado: Unified equations for the slope, "
         "intercept, and standard errors of the best straight line, Am. J. Phys. 72 (2004) 367"},
        {"ISO/TS 28037:2010"}};
    d.equations = {{"b(x) = y₁ + y₂ (x − x₀) + y₃ (x − x₀)² + …", "JCGM 100, Eq H.12"},
                   {"min Σ (y_i − b(x_i))²", "from the residuals, JCGM 100 H.3.2"},
                   {"min Σ (y_i − b(ξ_i))²/u²(y_i) + (x_i − ξ_i)²/u²(x_i)", "as stated, York et al. 2004"}};
    d.notes = {
        "From the residuals the coefficients are drawn from t distributions with n − p degrees of freedom, "
        "correlated "
        "by a Gaussian copula.",
        "JCGM 100 H.3, published y₁ = −0.1712 °C, y₂ = 0.002 18, u(y₁) = 0.0029 °C, u(y₂) = 0.000 67, b(30 "
        "°C) = "
        "−0.1494 °C with u = 0.0041 °C: reproduces.",
        "The uncertainty of b(x) is that of the curve: the scatter of a further observation is not part of "
        "it."};
    d.help_page = "calibration-curve.md";
    d.example = "gum/h3-thermometer.covaria";
    d.schema = curve::curve_schema();
    d.create = create_curve_model;
    return d;
}

}  // namespace covaria
