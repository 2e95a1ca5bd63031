// The kinds of statements, one function each.
#include "core/quantity/statement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/temperature.h"
#include "core/math/special_quantiles.h"

namespace covaria {

namespace {

using Made = Result<StatedComponent>;

tl::unexpected<Error> refused(Message message) {
    return fail(ErrorCode::bad_input, std::move(message));
}

double degrees_of(const Statement& s) {
    if (s.degrees_of_freedom) return *s.degrees_of_freedom;
    if (s.relative_uncertainty_of_u && *s.relative_uncertainty_of_u > 0.0)
        return 0.5 / (*s.relative_uncertainty_of_u * *s.relative_uncertainty_of_u);
    return infinity;
}

Made of_distribution(const Statement& s, DistributionParameters parameters) {
    return Distribution::make(std::move(parameters)).map([&](const Distribution& d) {
        return StatedComponent{.distribution = d, .degrees_of_freedom = degrees_of(s)};
    });
}

/// Student t where the degrees of freedom are finite (JCGM 101 6.4.9), else normal.
Made of_standard_uncertainty(const Statement& s, double u) {
    const double nu = degrees_of(s);
    if (std::isinf(nu)) return of_distribution(s, Normal{0.0, u});
    return of_distribution(s, StudentT{0.0, u, nu});
}

/// s is that of one observation, s/sqrt(n) that of the mean (JCGM 100 4.2.3, 4.2.4).
Made earlier_standard_deviation(const Statement& s) {
    const double n = s.b.value_or(1.0);
    if (!(n >= 1.0)) return refused(tell<"the number of observations in the mean must be at least one">());
    Made made = of_distribution(s, Normal{0.0, *s.a / std::sqrt(n)});
    if (made) made->type = EvaluationType::type_a;
    return made;
}

Made certificate_with_k(const Statement& s) {
    if (!(*s.b > 0.0)) return refused(tell<"the coverage factor k must be greater than zero">());
    return of_standard_uncertainty(s, *s.a / *s.b);
}

Made certificate_with_p(const Statement& s) {
    const double p = *s.b / 100.0;
    if (!(p > 0.0 && p < 1.0))
        return refused(tell<"the coverage probability must lie between 0 and 100 %">());
    const double nu = degrees_of(s);
    const double q = 0.5 * (1.0 + p);
    return of_standard_uncertainty(s, *s.a / t_quantile(q, nu));
}

Made rectangular_limits(const Statement& s) {
    if (s.estimate)
        return refused(tell<"the limits give the estimate: leave the value empty, or state a half-width">());
    const double middle = 0.5 * (*s.a + *s.b), half = 0.5 * (*s.b - *s.a);
    if (half < 0.0) return refused(tell<"the lower limit is above the upper limit">());
    Made made = of_distribution(s, Rectangular{-half, half});
    if (made) made->estimate = middle;
    return made;
}

Made maximum_permissible_error(const Statement& s) {
    const double relative = s.b.value_or(0.0) / 100.0;
    if (const Message objection = part_objection(s.unit); relative != 0.0 && !objection.empty())
        return refused(objection);
    if (relative != 0.0 && !s.estimate)
        return refused(tell<"a relative part of the permissible error needs the value of the quantity">());
    const double half = *s.a + std::abs(relative * s.estimate.value_or(0.0));
    return of_distribution(s, Rectangular{-half, half});
}

Made exponential(const Statement& s) {
    if (!s.estimate || !(*s.estimate > 0.0))
        return refused(tell<"an exponential distribution needs an estimate greater than zero">());
    return of_distribution(s, Exponential{*s.estimate}).map([&](StatedComponent c) {
        c.distribution = c.distribution.shifted(-*s.estimate);
        return c;
    });
}

Made counts(const Statement& s) {
    if (!(*s.a >= 0.0) || *s.a != std::round(*s.a))
        return refused(tell<"the number of counts must be whole">());
    if (s.estimate) return refused(tell<"the counts give the estimate: leave the value empty">());
    const double shape = *s.a + 1.0;
    return of_distribution(s, Gamma{shape, 1.0}).map([&](StatedComponent c) {
        c.distribution = c.distribution.shifted(-shape);
        c.estimate = shape;
        return c;
    });
}

/// About the estimate, which is that of the distribution where none is typed.
Made about_its_mean(const Statement& s, DistributionParameters parameters) {
    return of_distribution(s, std::move(parameters)).map([](StatedComponent c) {
        c.estimate = c.distribution.mean();
        c.distribution = c.distribution.shifted(-*c.estimate);
        return c;
    });
}

/// The number that is expected is stated, or is the value.
Made poisson(const Statement& s) {
    if (s.a && s.estimate)
        return refused(
            tell<"the expected number of events gives the estimate: leave the value empty, or the number">());
    const std::optional<double> number = s.a ? s.a : s.estimate;
    if (!number) return refused(tell<"the expected number of events is missing: state it, or the value">());
    return about_its_mean(s, Poisson{*number, 1.0, 0.0});
}

Made binomial(const Statement& s) {
    if (s.b && s.estimate)
        return refused(
            tell<"trials and probability give the estimate: leave the value empty, or the probability">());
    if (!s.b && !s.estimate)
        return refused(tell<"the probability of each trial is missing: state it, or the value">());
    if (!(*s.a >= 1.0)) return refused(tell<"the number of trials must be at least one">());
    const double probability = s.b ? *s.b / 100.0 : *s.estimate / *s.a;
    if (!(probability >= 0.0 && probability <= 1.0))
        return refused(s.b ? tell<"the probability of each trial must lie between 0 and 100 %">()
                           : tell<"the value must lie between 0 and the number of trials">());
    return about_its_mean(s, Binomial{*s.a, probability, 1.0, 0.0});
}

Made weibull(const Statement& s) {
    if (s.estimate)
        return refused(tell<"scale and shape give the estimate: leave the value empty, or state the standard "
                            "deviation alone">());
    return about_its_mean(s, Weibull{0.0, *s.a, *s.b});
}

/// Weibull distribution by the value, its mean, and a standard deviation: their ratio r gives the shape k by
/// 1 + r^2 = Gamma(1 + 2/k)/Gamma(1 + 1/k)^2, which falls with k.
Made weibull_of_deviation(const Statement& s) {
    if (!s.estimate || !(*s.estimate > 0.0))
        return refused(tell<"a Weibull distribution needs a value greater than zero, which is its mean">());
    if (*s.a == 0.0) return of_distribution(s, Normal{0.0, 0.0});
    const double wanted = std::log1p((*s.a / *s.estimate) * (*s.a / *s.estimate));
    double low = std::log(0.1), high = std::log(1e6);
    const auto excess = [&](double log_shape) {
        const double v = std::exp(-log_shape);
        return std::lgamma(1.0 + 2.0 * v) - 2.0 * std::lgamma(1.0 + v) - wanted;
    };
    if (excess(low) < 0.0 || excess(high) > 0.0)
        return refused(
            tell<"no Weibull distribution has such a ratio of standard deviation to mean: it must lie "
                 "between 0.000002 and 429">());
    for (int step = 0; step < 200; ++step) {
        const double middle = 0.5 * (low + high);
        (excess(middle) > 0.0 ? low : high) = middle;
    }
    const double shape = std::exp(0.5 * (low + high));
    const double scale = *s.estimate / std::exp(std::lgamma(1.0 + 1.0 / shape));
    return of_distribution(s, Weibull{-*s.estimate, scale, shape});
}

/// Whether the distribution begins at the zero of the quantity, which a temperature in degC does not have.
bool begins_at_zero(std::string_view kind) {
    return kind == "exponential" || kind == "weibull" || kind == "weibull-deviation" || kind == "poisson" ||
           kind == "binomial" || kind == "counts";
}

Made make(const Statement& s) {
    const double a = s.a.value_or(0.0), b = s.b.value_or(0.0);
    if (s.kind == "standard") return of_standard_uncertainty(s, a);
    if (s.kind == "standard-deviation") return earlier_standard_deviation(s);
    if (s.kind == "certificate-k") return certificate_with_k(s);
    if (s.kind == "certificate-p") return certificate_with_p(s);
    if (s.kind == "limits") return rectangular_limits(s);
    if (s.kind == "resolution") return of_distribution(s, Rectangular{-0.5 * a, 0.5 * a});
    if (s.kind == "mpe") return maximum_permissible_error(s);
    if (s.kind == "rectangular") return of_distribution(s, Rectangular{-a, a});
    if (s.kind == "curvilinear-trapezoid") return of_distribution(s, CurvilinearTrapezoid{-a, a, b});
    if (s.kind == "trapezoidal") return of_distribution(s, Trapezoidal{-a, a, b});
    if (s.kind == "triangular") return of_distribution(s, Triangular{-a, a});
    if (s.kind == "arcsine") return of_distribution(s, Arcsine{-a, a});
    if (s.kind == "exponential") return exponential(s);
    if (s.kind == "laplace") return of_distribution(s, Laplace{0.0, a / std::numbers::sqrt2});
    if (s.kind == "laplace-scale") return of_distribution(s, Laplace{0.0, a});
    if (s.kind == "weibull") return weibull(s);
    if (s.kind == "weibull-deviation") return weibull_of_deviation(s);
    if (s.kind == "poisson") return poisson(s);
    if (s.kind == "binomial") return binomial(s);
    return counts(s);
}

Message figure_problem(std::string_view name, const std::optional<double>& figure, std::string_view meaning,
                       bool optional) {
    if (meaning.empty())
        return figure ? tell<"'%1' is not used by this statement: leave it empty">(name) : Message{};
    if (figure || optional) return {};
    return tell<"'%1' is missing: %2">(name, Message::declared(meaning));
}

Message problem_of(const Statement& s, const StatementKind& kind) {
    for (const Message& problem : {figure_problem("a", s.a, kind.a, kind.a_optional),
                                   figure_problem("b", s.b, kind.b, kind.b_optional)})
        if (!problem.empty()) return problem;
    if (s.a && kind.key != "limits" && *s.a < 0.0) return tell<"'a' must not be negative">();
    if (s.degrees_of_freedom && s.relative_uncertainty_of_u)
        return tell<"give the degrees of freedom or the relative uncertainty of u, not both">();
    if (s.degrees_of_freedom && !(*s.degrees_of_freedom > 0.0))
        return tell<"the degrees of freedom must be greater than zero">();
    if (s.relative_uncertainty_of_u && !(*s.relative_uncertainty_of_u >= 0.0))
        return tell<"the relative uncertainty of u must not be negative">();
    return {};
}

}  // namespace

const std::vector<StatementKind>& statement_kinds() {
    static const std::vector<StatementKind> kinds{
        {"standard", "standard uncertainty", "standard uncertainty u", ""},
        {"standard-deviation", "standard deviation known before (Type A)",
         "standard deviation s of one observation", "number n of observations in the mean", true, false,
         true},
        {"certificate-k", "certificate, U and k", "expanded uncertainty U", "coverage factor k", true, false},
        {"certificate-p", "certificate, U and p", "expanded uncertainty U", "coverage probability in %", true,
         false},
        {"rectangular", "rectangular", "half-width", ""},
        {"limits", "limits from a to b", "lower limit", "upper limit"},
        {"curvilinear-trapezoid", "limits inexactly known", "half-width", "inexactness of the limits"},
        {"trapezoidal", "trapezoidal", "half-width", "ratio of top to base", true, false},
        {"triangular", "triangular", "half-width", ""},
        {"arcsine", "arc sine", "half-width", ""},
        {"resolution", "resolution", "step of the indication", ""},
        {"mpe", "maximum permissible error", "permissible error", "further part in % of the value", true,
         false, true},
        {"exponential", "exponential", "", ""},
        {"counts", "counts", "number of counts", "", false},
        {"laplace", "Laplace, standard deviation", "standard deviation", ""},
        {"laplace-scale", "Laplace, scale", "scale", ""},
        {"weibull", "Weibull, scale and shape", "scale", "shape", true, false},
        {"weibull-deviation", "Weibull, standard deviation", "standard deviation", ""},
        {"poisson", "Poisson", "expected number of events", "", false, false, false, true},
        {"binomial", "binomial", "number of trials", "probability in % of each trial", false, false, true},
    };
    return kinds;
}

const StatementKind* find_statement(std::string_view key) {
    const auto& kinds = statement_kinds();
    const auto found =
        std::find_if(kinds.begin(), kinds.end(), [&](const StatementKind& k) { return k.key == key; });
    return found == kinds.end() ? nullptr : &*found;
}

bool is_part_of_estimate(const Unit& stated, const Unit& of_quantity) {
    return stated.dimension().is_one() && !of_quantity.dimension().is_one();
}

Result<double> figure_in_si(double figure, const Unit& stated, const Unit& of_quantity, bool on_scale,
                            std::optional<double> estimate) {
    if (stated.dimension() == of_quantity.dimension()) {
        if (!on_scale) return stated.interval_to_si(figure);
        if (const Message objection = reading_objection(stated, of_quantity); !objection.empty())
            return refused(objection);
        return stated.to_si(figure);
    }
    if (on_scale || !is_part_of_estimate(stated, of_quantity))
        return refused(tell<"%1 is no unit for a quantity in %2">(stated.display(), of_quantity.display()));
    if (const Message objection = part_objection(of_quantity); !objection.empty()) return refused(objection);
    if (!estimate) return refused(tell<"a part of the value needs the value">());
    return std::abs(*estimate) * stated.interval_to_si(figure);
}

Result<StatedComponent> stated_component(const Statement& statement) {
    const StatementKind* kind = find_statement(statement.kind);
    if (!kind) return refused(tell<"there is no statement '%1'">(statement.kind));
    if (const Message problem = problem_of(statement, *kind); !problem.empty()) return refused(problem);
    if (const Message objection = part_objection(statement.unit);
        begins_at_zero(kind->key) && !objection.empty())
        return refused(objection);
    Made made = make(statement);
    if (made) made->words = std::string(kind->title);
    return made;
}

}  // namespace covaria
