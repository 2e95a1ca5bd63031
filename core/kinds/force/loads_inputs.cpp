// Input quantities of "force-moment loads": elements of the calibration matrix, readings of the cases.
#include <cmath>

#include "core/base/name.h"
#include "core/kinds/force/loads_setup.h"
#include "core/quantity/input_quantity.h"

namespace covaria::force_loads {

namespace {

class InputBuilder {
public:
    explicit InputBuilder(LoadsSetup& setup) : setup_(setup), n_(setup.size()) {}

    InputSet build() {
        for (const ForceChannel& channel : setup_.channels()) add_machine(channel);
        setup_.first_element = 0;
        for (std::size_t i = 0; i < n_ * n_; ++i) add_element(i / n_, i % n_);
        for (std::size_t i = 0; setup_.quadratic && i < n_ * n_; ++i) add_square(i / n_, i % n_);
        setup_.first_reading = inputs_.quantities.size();
        for (std::size_t k = 0; k < setup_.cases.size(); ++k)
            for (std::size_t h = 0; h < n_; ++h) add_reading(k, h);
        return std::move(inputs_);
    }

private:
    std::string key(std::size_t channel) const { return setup_.channels()[channel].kind().key; }
    std::string pair(std::size_t h, std::size_t c) const { return key(h) + "," + key(c); }

    UncertaintyComponent component(std::string id, Message name, const Unit& unit, Distribution distribution,
                                   Message origin) const {
        return {.id = std::move(id),
                .name = std::move(name),
                .unit = unit,
                .distribution = std::move(distribution),
                .origin = tell<"%1: %2">(setup_.sensor.name, std::move(origin))};
    }

    /// The machine's load deviates alike in all readings under it: a whole column.
    void add_machine(const ForceChannel& channel) {
        const std::string axis = channel.kind().key;
        UncertaintyComponent machine =
            component("machine." + axis, tell<"calibration machine, %1">(axis), Unit::of("%"),
                      Distribution::normal(channel.u_calibrator), tell<"calibration machine, Eq 5">());
        machine.tags = {{"source", own_name<"calibration machine">()}};
        inputs_.add(std::move(machine));
    }

    Unit element_unit(std::size_t c, bool square) const {
        const bool moment = setup_.channels()[c].kind().is_moment;
        if (square) return Unit::of(moment ? "mV/V/N^2/m^2" : "mV/V/N^2");
        return Unit::of(moment ? "mV/V/N/m" : "mV/V/N");
    }

    UncertaintyComponent regression(const std::string& symbol, const Element& element, const Unit& unit,
                                    double u) const {
        UncertaintyComponent fit = component(symbol + ".regression", tell<"regression of %1">(symbol), unit,
                                             Distribution::normal(std::abs(u)), tell<"least squares">());
        fit.type = EvaluationType::type_a;
        if (element.degrees_of_freedom > 0.0) fit.degrees_of_freedom = element.degrees_of_freedom;
        fit.normal_draws = !setup_.student_t;
        fit.tags = {{"source", own_name<"regression">()}};
        return fit;
    }

    /// Both coefficients of an element rest on the residuals of one fit; without readings on the
    /// repeatability that the channel states.
    void rest_on_residuals(std::size_t component, std::size_t h, std::size_t c) {
        if (std::isinf(inputs_.components[component].degrees_of_freedom)) return;
        const bool stated = setup_.sensor->increasing().empty();
        inputs_.rest_on_estimate(stated ? (setup_.pooled ? "largest " : "repeatability of ") + key(h)
                                        : "residuals of " + pair(h, c),
                                 component);
    }

    void add_element(std::size_t h, std::size_t c) {
        const Element& element = setup_.element(h, c);
        const double scale = setup_.scale(h, c);
        const std::string symbol = "S_" + pair(h, c);
        first_.push_back(
            inputs_.add(regression(symbol, element, element_unit(c, false), element.aa * scale)));
        rest_on_residuals(first_.back(), h, c);
        inputs_.quantities.push_back({.symbol = symbol,
                                      .name = tell<"reading of %1 by load %2">(key(h), key(c)),
                                      .unit = element_unit(c, false),
                                      .offset = element.a * scale,
                                      .shares = {{first_.back(), 1.0}, {c, element.a * scale}},
                                      .group = own_name<"calibration matrix">()});
    }

    void add_square(std::size_t h, std::size_t c) {
        const Element& element = setup_.element(h, c);
        const double scale = setup_.scale(h, c, 2);
        const std::string symbol = "Q_" + pair(h, c);
        const std::size_t own =
            inputs_.add(regression(symbol, element, element_unit(c, true), element.bb * scale));
        rest_on_residuals(own, h, c);
        std::vector<Share> shares{{own, 1.0}, {c, 2.0 * element.b * scale}};
        if (element.aa > 0.0) {
            const double sign = setup_.scale(h, c) < 0.0 ? -1.0 : 1.0;  // the component is |aa scale|
            shares.push_back(
                {first_[h * n_ + c], sign * element.ba * scale / std::abs(element.aa * setup_.scale(h, c))});
        }
        inputs_.quantities.push_back({.symbol = symbol,
                                      .name = tell<"quadratic term of %1 by load %2">(key(h), key(c)),
                                      .unit = element_unit(c, true),
                                      .offset = element.b * scale,
                                      .shares = std::move(shares),
                                      .group = own_name<"calibration matrix">()});
    }

    UncertaintyComponent of_reading(std::size_t k, std::size_t h, const std::string& id, const Message& name,
                                    Distribution distribution, const Message& origin) const {
        UncertaintyComponent c = component(std::to_string(k + 1) + "." + key(h) + "." + id,
                                           tell<"%1 of %2, %3">(name, key(h), setup_.cases[k].name),
                                           Unit::of("mV/V"), std::move(distribution), origin);
        c.tags = {{"source", Name::of(name)}};
        return c;
    }

    UncertaintyComponent repeatability(std::size_t k, std::size_t h) const {
        const ForceChannel& channel = setup_.channels()[h];
        const double s = channel.s_single(setup_.pooled);
        const double freedom = channel.s_degrees_of_freedom(setup_.pooled);
        UncertaintyComponent c =
            of_reading(k, h, "repeatability", tell<"repeatability">(), Distribution::normal(s),
                       tell<"standard deviation of one reading, Eq 3">());
        c.normal_draws = !setup_.student_t;
        c.type = EvaluationType::type_a;
        c.degrees_of_freedom = freedom;
        return c;
    }

    void add_reading(std::size_t k, std::size_t h) {
        const Case& one = setup_.cases[k];
        const ForceChannel& channel = setup_.channels()[h];
        const auto i = static_cast<Eigen::Index>(h);
        const auto limits = [](double width) {
            return Distribution::of(Rectangular{-0.5 * width, 0.5 * width});
        };
        const double part = setup_.full_hysteresis ? 1.0 : std::min(1.0, std::abs(one.l[i]));
        const std::size_t first = inputs_.components.size();
        inputs_.add(InputQuantity{.symbol = "V_" + key(h) + "," + std::to_string(k + 1),
                                  .name = tell<"net reading of %1, %2">(key(h), one.name),
                                  .unit = Unit::of("mV/V"),
                                  .offset = one.v[i] * channel.rated_output,
                                  .group = one.name,
                                  .source = one.source},
                    {repeatability(k, h),
                     of_reading(k, h, "resolution", tell<"resolution">(), limits(setup_.sensor->resolution()),
                                tell<"Eq 6">()),
                     of_reading(k, h, "zero", tell<"non-zero">(), limits(channel.zero), tell<"Eq 7">()),
                     of_reading(k, h, "hysteresis", tell<"hysteresis">(), limits(part * channel.hysteresis),
                                setup_.full_hysteresis ? tell<"Eq 10, full width of the loop">()
                                                       : tell<"Eq 10, in proportion to the load">())});
        if (std::isfinite(inputs_.components[first].degrees_of_freedom))
            inputs_.rest_on_estimate("repeatability of " + key(h), first);
    }

    LoadsSetup& setup_;
    std::size_t n_;
    InputSet inputs_;
    std::vector<std::size_t> first_;  ///< component of the regression of each element
};

}  // namespace

InputSet inputs(LoadsSetup& setup) {
    return InputBuilder(setup).build();
}

}  // namespace covaria::force_loads
