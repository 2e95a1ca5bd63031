// Eqs 1-6 of Porath et al. on numbers: statistics of errors of indication and their combination.
#include "core/kinds/points/error_budget.h"

#include <cmath>
#include <numbers>

#include "core/kinds/points/point_uncertainty.h"
#include "core/quantity/input_quantity.h"
#include "core/quantity/type_a.h"

namespace covaria {

double ErrorBudget::u_bias(BiasTreatment treatment) const {
    switch (treatment) {
        case BiasTreatment::as_uncertainty:
            return std::abs(bias);
        case BiasTreatment::corrected:
            return u_variability / std::sqrt(observations);
        case BiasTreatment::ignored:
            break;
    }
    return 0.0;
}

double ErrorBudget::combined(BiasTreatment treatment) const {
    return std::hypot(std::hypot(u_calibration, u_temperature), std::hypot(u_variability, u_bias(treatment)));
}

double ErrorBudget::degrees_of_freedom(BiasTreatment treatment) const {
    if (u_variability == 0.0 || std::isinf(observations)) return infinity;
    // The uncertainty of a correction by the mean comes from the same n observations as the variability.
    const double from_correction = treatment == BiasTreatment::corrected ? u_bias(treatment) : 0.0;
    const double u2 = u_variability * u_variability + from_correction * from_correction;
    return (observations - 1.0) * std::pow(combined(treatment), 4) / (u2 * u2);
}

Result<ErrorBudget> budget_of_errors(const std::string& coordinate, const std::vector<double>& errors) {
    const Result<TypeA> statistics = type_a_evaluation(errors);
    if (!statistics) return fail(statistics.error());
    ErrorBudget budget;
    budget.coordinate = coordinate;
    budget.bias = statistics->mean;
    budget.u_variability = statistics->standard_deviation;
    budget.observations = static_cast<double>(errors.size());
    return budget;
}

double temperature_uncertainty(double length, double expansion, double temperature_deviation) {
    return std::abs(length * expansion * temperature_deviation) / std::numbers::sqrt3;
}

namespace {

UncertaintyComponent component(const std::string& id, const Message& name, double u, const Message& origin) {
    return {.id = id,
            .name = name,
            .unit = Unit::of("mm"),
            .distribution = Distribution::normal(u),
            .type = EvaluationType::type_b,
            .origin = origin};
}

/// The standard deviation of the errors of indication, one for all points measured so.
void rest_on_observations(const ErrorBudget& budget, PointDeviation& deviation) {
    if (std::isinf(budget.observations)) return;
    deviation.component.degrees_of_freedom = budget.observations - 1.0;
    deviation.component.type = EvaluationType::type_a;
    deviation.estimate = budget.coordinate;
}

std::vector<PointDeviation> common_parts(const ErrorBudget& budget, const std::string& coordinate,
                                         const Eigen::Vector3d& direction, const DeviationRule& rule) {
    const auto part = [&](const char* word, const Message& name, double u) {
        return PointDeviation{coordinate + "." + word, tell<"%1, coordinate %2">(name, coordinate), direction,
                              component(word, name, rule.factor * u, rule.origin), true};
    };
    std::vector<PointDeviation> parts{
        part("calibration", tell<"calibration of the artefact">(), budget.u_calibration),
        part("temperature", tell<"temperature of the artefact">(), budget.u_temperature),
        part("bias", tell<"systematic error of indication">(), budget.u_bias(rule.bias))};
    const double half_width = std::numbers::sqrt3 * rule.factor * budget.u_temperature;
    parts[1].component.distribution = Distribution::of(Rectangular{-half_width, half_width});
    if (rule.bias == BiasTreatment::corrected) rest_on_observations(budget, parts[2]);
    return parts;
}

}  // namespace

std::vector<PointDeviation> deviations_of(const ErrorBudget& budget, const std::string& coordinate,
                                          const Eigen::Vector3d& direction, const DeviationRule& rule) {
    PointDeviation own{coordinate, tell<"coordinate %1">(coordinate), direction, {}, false};
    own.component = component(coordinate, own.name, rule.factor * budget.combined(rule.bias), rule.origin);
    own.component.degrees_of_freedom = budget.degrees_of_freedom(rule.bias);
    if (std::isfinite(own.component.degrees_of_freedom)) own.estimate = budget.coordinate;
    if (!rule.systematic_common) return {own};
    own.component.distribution = Distribution::normal(rule.factor * budget.u_variability);
    rest_on_observations(budget, own);
    own.component.type = EvaluationType::type_a;
    std::vector<PointDeviation> all{own};
    for (PointDeviation& part : common_parts(budget, coordinate, direction, rule)) all.push_back(part);
    return all;
}

Table budget_table(const std::vector<ErrorBudget>& budgets, BiasTreatment treatment) {
    const Unit mm = Unit::of("mm");
    Table table{"point-budget", "Uncertainty budget of a measured point"};
    table.add("coordinate");
    table.add("u_cal").in(mm).symbol().figure(2);
    table.add("u_T").in(mm).symbol().figure(2);
    table.add("u_var").in(mm).symbol().figure(3);
    table.add("b").in(mm).symbol().figure(3);
    table.add("n").symbol();
    table.add("u_c").in(mm).symbol().figure(3);
    for (const ErrorBudget& b : budgets) {
        Cell n;
        if (std::isfinite(b.observations)) n = b.observations;
        table.row({b.coordinate, b.u_calibration, b.u_temperature, b.u_variability, b.bias, n,
                   b.combined(treatment)});
    }
    if (treatment == BiasTreatment::as_uncertainty)
        table.notes.push_back(
            tell<"The bias b is not corrected; |b| counts as a standard uncertainty (against JCGM 100 "
                 "3.2.4).">());
    if (treatment == BiasTreatment::ignored) table.notes.push_back(tell<"The bias b is not part of u_c.">());
    if (treatment == BiasTreatment::corrected)
        table.notes.push_back(
            tell<"Measured values are taken as corrected by -b; u_var/sqrt(n) of the correction is part of "
                 "u_c.">());
    return table;
}

}  // namespace covaria
