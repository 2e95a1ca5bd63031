// Results stated of a feature, from its parameters and points, once for every number type.
#pragma once

#include <span>
#include <vector>

#include "core/kinds/geometry/setup.h"
#include "core/model/output_quantity.h"

namespace covaria::geometry {

/// Outputs in their order: place, direction, diameter, angle of a cone; form deviations; apex.
std::vector<OutputQuantity> outputs_of(const Feature& feature);

/// Their indices, from the first of the feature on.
struct ResultPlaces {
    std::size_t direction, diameter, angle, form, apex, count;
};
inline ResultPlaces places_of(const Feature& feature) {
    const FormFacts facts = facts_of(feature.form());
    const std::size_t c = feature.coordinates();
    const bool is_cone = feature.form() == Form::cone;
    ResultPlaces at{};
    at.direction = c;
    at.diameter = at.direction + (facts.has_direction ? c : 0);
    at.angle = at.diameter + (facts.has_diameter ? 1 : 0);
    at.form = at.angle + (is_cone ? 1 : 0);
    at.apex = at.form + (feature.has_form ? 2 : 0);
    at.count = at.apex + (is_cone ? 3 : 0);
    return at;
}

/// Sets all but the form deviations by set(index, value). `mean`: that of the points, in local axes.
template <class Real, class Set>
void set_results(const Feature& feature, const Parameters<Real>& v, const Vector3<Real>& mean,
                 const Set& set) {
    const FittedForm& fitted = feature.fitted;
    const FormFacts facts = facts_of(fitted.form);
    const ResultPlaces at = places_of(feature);
    const Shape<Real> shape(fitted.form, v);
    const auto set_vector = [&](std::size_t first, const Vector3<Real>& of) {
        for (std::size_t c = 0; c < feature.coordinates(); ++c) set(first + c, of[Eigen::Index(c)]);
    };
    set_vector(0, fitted.to_world<Real>(shape.place(mean)));
    if (facts.has_direction)
        set_vector(at.direction, fitted.turned<Real>(shape.direction() * Real(fitted.sign)));
    if (facts.has_diameter) set(at.diameter, Real(Real(2.0) * shape.radius(mean)));
    if (fitted.form != Form::cone) return;
    set(at.angle, Real(Real(2.0) * v[5]));
    set_vector(at.apex, fitted.to_world<Real>(shape.apex()));
}

/// The points of a feature in its local axes: the room of one thread, kept between trials.
template <class Real>
std::vector<Vector3<Real>>& points_of_thread() {
    static thread_local std::vector<Vector3<Real>> points;
    return points;
}

/// Peak to valley: of lines in space twice the largest distance, the diameter of the cylinder around.
template <class Real>
void set_form(const Feature& feature, const Parameters<Real>& v, const std::vector<Vector3<Real>>& q,
              std::size_t first, auto&& set) {
    using namespace real_functions;
    const Form form = feature.form();
    const Shape<Real> shape(form, v);
    Rows<Real> rows;
    Real high(0.0), low(0.0), squares(0.0);
    for (std::size_t i = 0; i < feature.points.size(); ++i) {
        shape.rows(q[i], rows);
        const Real d = deviation_of<Real>(form, rows);
        high = i == 0 ? d : Real(max(high, d));
        low = i == 0 ? d : Real(min(low, d));
        squares = squares + square_of<Real>(form, rows);
    }
    set(first, form == Form::line ? Real(Real(2.0) * high) : Real(high - low));
    set(first + 1, Real(sqrt(Real(squares / Real(double(feature.points.size()))))));
}

template <class Real, class In, class Out>
mask_of<Real> evaluate_feature(const Feature& feature, const In& x, std::size_t first_output, Out& y) {
    const std::size_t n = feature.points.size();
    std::vector<Vector3<Real>>& q = points_of_thread<Real>();
    if (q.size() < n) q.resize(n);
    Vector3<Real> mean(Real(0.0), Real(0.0), Real(0.0));
    for (std::size_t i = 0; i < n; ++i) {
        Vector3<Real> p(Real(0.0), Real(0.0), Real(feature.fitted.origin.z()));
        for (std::size_t c = 0; c < feature.coordinates(); ++c)
            p[Eigen::Index(c)] = x[feature.points[i].first_input + c];
        q[i] = feature.fitted.to_local<Real>(p);
        mean += q[i];
    }
    mean = (mean * Real(1.0 / double(n))).eval();
    Parameters<Real> v;
    v.fill(Real(0.0));
    const mask_of<Real> settled = fit<Real>(
        feature.fitted, [&](std::size_t i) -> const Vector3<Real>& { return q[i]; }, n, v);
    const auto set = [&](std::size_t j, const Real& value) { y.set(first_output + j, value); };
    set_results<Real>(feature, v, mean, set);
    if (feature.has_form) set_form<Real>(feature, v, q, places_of(feature).form, set);
    return settled;
}

/// Derivatives of a feature's outputs by the coordinates of its points: outputs x (coordinates of point 0,
/// of point 1 ...), by the implicit function theorem from the equations that the parameters satisfy at x.
/// Empty: there is no value at x.
Eigen::MatrixXd derivatives_of(const Feature& feature, std::span<const double> x);

}  // namespace covaria::geometry
