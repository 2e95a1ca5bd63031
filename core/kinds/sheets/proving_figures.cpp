#include "core/kinds/sheets/proving_figures.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace covaria::sheets {

namespace {

using std::numbers::sqrt3;

/// Least squares of a polynomial over (F/F_N): rows are the coefficients, columns the steps.
Eigen::MatrixXd polynomial_gain(const ProvingSetup& setup, std::size_t first_power, std::size_t count) {
    Eigen::MatrixXd design(Eigen::Index(setup.steps.size()), Eigen::Index(count));
    for (Eigen::Index i = 0; i < design.rows(); ++i)
        for (Eigen::Index k = 0; k < design.cols(); ++k)
            design(i, k) = std::pow(setup.steps[std::size_t(i)].force / setup.largest_force(),
                                    double(k) + double(first_power));
    return design.colPivHouseholderQr().solve(Eigen::MatrixXd::Identity(design.rows(), design.rows()));
}

/// Both differences, relative, of the decreasing forces that were read.
std::optional<double> reversibility(const ForceStep& step) {
    double sum = 0.0;
    int count = 0;
    const auto add = [&](const std::optional<double>& falling, double rising) {
        if (!falling) return;
        sum += std::abs((*falling - rising) / rising);
        ++count;
    };
    add(step.falling_3, step.rising[2]);
    add(step.falling_5, step.rising[3]);
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

StepFigures errors_of(const ForceStep& step) {
    const auto [x1, x2, x3, x5] = step.rising;
    StepFigures figures;
    figures.mean = step.mean();
    figures.b = (std::max({x1, x3, x5}) - std::min({x1, x3, x5})) / std::abs(figures.mean);
    figures.b_same = std::abs((x2 - x1) / (0.5 * (x1 + x2)));
    figures.v = reversibility(step);
    // Their squares have the sum of sum (X_i - mean)^2/6: the variance of the mean of three rotations.
    figures.turned = {(x1 - x3) / std::sqrt(12.0), (x1 + x3 - 2.0 * x5) / 6.0};
    return figures;
}

void add_common(const ProvingSetup& setup, ProvingFigures& figures) {
    const double largest = setup.largest_deflection();
    for (const UnloadedReadings& u : setup.unloaded) {
        const double f_0 = (u.after - u.before) / largest;
        if (!figures.f_0 || std::abs(f_0) > std::abs(*figures.f_0)) figures.f_0 = f_0;
    }
    if (setup.creep_30) figures.c = std::abs((*setup.creep_300 - *setup.creep_30) / largest);
}

void fit_curve(const ProvingSetup& setup, ProvingFigures& figures) {
    const auto n = Eigen::Index(setup.steps.size());
    Eigen::VectorXd mean(n);
    for (Eigen::Index i = 0; i < n; ++i) mean[i] = figures.steps[std::size_t(i)].mean;
    figures.gain = polynomial_gain(setup, setup.first_power(), setup.coefficients());
    figures.coefficients = figures.gain * mean;
    double squares = 0.0;
    for (std::size_t i = 0; i < setup.steps.size(); ++i) {
        StepFigures& step = figures.steps[i];
        step.fitted = polynomial_at(figures.coefficients, setup.first_power(),
                                    setup.steps[i].force / setup.largest_force());
        step.f_c = (step.mean - step.fitted) / step.fitted;
        squares += (step.mean - step.fitted) * (step.mean - step.fitted);
    }
    figures.s_fit = std::sqrt(squares / setup.degrees_of_freedom());
}

void add_parts(const ProvingSetup& setup, ProvingFigures& figures) {
    for (std::size_t i = 0; i < setup.steps.size(); ++i) {
        StepFigures& step = figures.steps[i];
        const double deflection = std::abs(step.mean);
        const auto put = [&](ForcePart part, double u) { step.parts[std::size_t(part)] = u; };
        put(ForcePart::machine, setup.u_machine(setup.steps[i]));
        put(ForcePart::reproducibility, std::hypot(step.turned[0], step.turned[1]) / deflection);
        put(ForcePart::repeatability, step.b_same / sqrt3);
        put(ForcePart::resolution, setup.resolution / deflection / std::sqrt(6.0));
        put(ForcePart::creep, figures.c.value_or(0.0) / sqrt3);
        put(ForcePart::zero, std::abs(figures.f_0.value_or(0.0)));
        put(ForcePart::temperature, setup.temperature_coefficient * setup.temperature_half_width / sqrt3);
        put(ForcePart::interpolation,
            figures.s_fit / (setup.residual_of_largest ? std::abs(setup.largest_deflection()) : deflection));
        if (setup.decreasing)
            put(ForcePart::reversibility, step.v.value_or(0.0) / setup.reversibility_divisor);
    }
}

/// The polynomial through W of the steps, raised until none lies above it.
void fit_uncertainty(const ProvingSetup& setup, ProvingFigures& figures) {
    const auto n = Eigen::Index(setup.steps.size());
    Eigen::VectorXd w(n);
    for (Eigen::Index i = 0; i < n; ++i) w[i] = setup.k * figures.steps[std::size_t(i)].combined();
    figures.uncertainty_curve = polynomial_gain(setup, 0, std::size_t(setup.uncertainty_degree) + 1) * w;
    for (Eigen::Index i = 0; i < n; ++i)
        figures.raised = std::max(
            figures.raised, w[i] - polynomial_at(figures.uncertainty_curve, 0,
                                                 setup.steps[std::size_t(i)].force / setup.largest_force()));
    figures.uncertainty_curve[0] += figures.raised;
}

bool is_within(const ClassLimits& limits, const ProvingSetup& setup, const ProvingFigures& figures,
               std::size_t i) {
    const StepFigures& step = figures.steps[i];
    const auto holds = [](const std::optional<double>& limit, const std::optional<double>& error) {
        return !limit || !error || std::abs(*error) <= *limit * (1.0 + 1e-12);
    };
    return holds(limits.b, step.b) && holds(limits.b_same, step.b_same) && holds(limits.f_c, step.f_c) &&
           holds(limits.f_0, figures.f_0) && holds(limits.v, step.v) && holds(limits.c, figures.c) &&
           holds(limits.machine_U, 2.0 * setup.u_machine(setup.steps[i]));
}

void find_classes(const ProvingSetup& setup, ProvingFigures& figures) {
    for (std::size_t i = 0; i < setup.steps.size(); ++i)
        for (const ClassLimits& limits : setup.classes)
            figures.steps[i].is_of_class.push_back(is_within(limits, setup, figures, i));
}

}  // namespace

std::optional<std::size_t> StepFigures::first_class() const {
    const auto found = std::ranges::find(is_of_class, true);
    return found == is_of_class.end() ? std::nullopt
                                      : std::optional(std::size_t(found - is_of_class.begin()));
}

double StepFigures::combined() const {
    double squares = 0.0;
    for (const double u : parts) squares += u * u;
    return std::sqrt(squares);
}

double polynomial_at(const Eigen::VectorXd& coefficients, std::size_t first_power, double t) {
    double sum = 0.0;
    for (Eigen::Index k = coefficients.size(); k-- > 0;) sum = sum * t + coefficients[k];
    return sum * std::pow(t, double(first_power));
}

ProvingFigures figures_of(const ProvingSetup& setup) {
    ProvingFigures figures;
    for (const ForceStep& step : setup.steps) figures.steps.push_back(errors_of(step));
    add_common(setup, figures);
    fit_curve(setup, figures);
    add_parts(setup, figures);
    fit_uncertainty(setup, figures);
    find_classes(setup, figures);
    return figures;
}

}  // namespace covaria::sheets
