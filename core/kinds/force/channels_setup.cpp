// Fields of "force-moment channels", the GUM's combination of its components, its input quantities.
#include "core/kinds/force/channels_setup.h"

#include <cmath>

#include "core/base/name.h"
#include "core/kinds/force/force_sensor.h"
#include "core/math/special_quantiles.h"
#include "core/quantity/input_quantity.h"

namespace covaria::force_channels {

const Fields<ChannelSetup>& fields() {
    static const auto fields =
        Fields<ChannelSetup>()
            .section("Sensor")
            .add(&ChannelSetup::sensor, "sensor", "Sensor", "The calibrated multi-axis sensor.")
            .section("Use")
            .choice(
                &ChannelSetup::others, "other_loads", "Loads on the other axes",
                "What acts on the other axes while a channel is read. Unknown loads are "
                "rectangular between minus and plus the rated load, one and the same for all "
                "channels.",
                {{OtherLoads::none, "none", "none: one component alone"},
                 {OtherLoads::largest, "largest", "unknown on one axis, that with the largest interference"},
                 {OtherLoads::all, "all", "unknown on all other axes"}},
                OtherLoads::all)
            .section("Method")
            .choice(&ChannelSetup::pooled, "repeatability", "Repeatability",
                    "The largest standard deviation of all steps, as in the paper, or that pooled "
                    "over the steps, which has more degrees of freedom.",
                    {{false, "largest", "largest of the steps"}, {true, "pooled", "pooled over the steps"}},
                    false)
            .choice(&ChannelSetup::student_t, "type_a", "Type A in Monte Carlo",
                    "Normal, with its degrees of freedom in the law of propagation, or a "
                    "t-distribution (JCGM 101 6.4.9). With n = 3 the latter has no standard "
                    "deviation: only coverage intervals then mean something.",
                    {{false, "normal", "normal"}, {true, "student-t", "scaled and shifted t"}}, false)
            .add(&ChannelSetup::k, "coverage_factor", "Coverage factor of the comparison",
                 "k of the GUM's columns in the table beside the paper's.",
                 {.range = {.low = 0.0, .high = 10.0, .low_open = true},
                  .default_value = Quantity{2.0, Unit()}});
    return fields;
}

std::optional<ChannelSetup> read(const SetupReader& setup, const AssetLibrary& assets, Problems& problems) {
    ChannelSetup read = fields().read(setup, assets, problems);
    if (!read.sensor) return {};
    if (read.pooled && !(read.channels()[0].pooled_degrees_of_freedom > 0.0))
        problems.warning(fields().place(&ChannelSetup::pooled),
                         tell<"the sensor's calibration is a summary: there are no steps to pool over, so "
                              "the largest standard deviation is taken">());
    return read;
}

std::size_t ChannelSetup::strongest(std::size_t h) const {
    std::size_t found = h;
    for (std::size_t c = 0; c < size(); ++c)
        if (c != h && (found == h || std::abs(e(h, c)) > std::abs(e(h, found)))) found = c;
    return found;
}

bool ChannelSetup::interferes(std::size_t h, std::size_t c) const {
    if (c == h || others == OtherLoads::none) return false;
    return others == OtherLoads::all || c == strongest(h);
}

namespace {

double u_repeatability(const ChannelSetup& setup, const ForceChannel& channel) {
    return setup.pooled ? channel.s_single(true) / std::sqrt(channel.runs) : channel.u_a;
}

double square(double x) {
    return x * x;
}

}  // namespace

Single single_component(const ChannelSetup& setup, std::size_t h) {
    const ForceChannel& channel = setup.channels()[h];
    const double u_a = u_repeatability(setup, channel);
    const double variance =
        square(u_a) + square(channel.u_calibrator * channel.rated_output) +
        (square(setup.sensor->resolution()) + square(channel.zero) + square(channel.hysteresis)) / 12.0;
    Single single{std::sqrt(variance), infinity};
    if (u_a > 0.0)
        single.degrees_of_freedom =
            channel.s_degrees_of_freedom(setup.pooled) * square(variance / square(u_a));
    return single;
}

double combined(const ChannelSetup& setup, std::size_t h, OtherLoads others) {
    ChannelSetup other = setup;
    other.others = others;
    double variance = square(single_component(setup, h).u);
    for (std::size_t c = 0; c < setup.size(); ++c)
        if (other.interferes(h, c)) variance += square(setup.e(h, c)) / 3.0;
    return std::sqrt(variance);
}

double worst_case(const ChannelSetup& setup, std::size_t h) {
    double sum = 0.0;
    for (std::size_t c = 0; c < setup.size(); ++c)
        if (c != h) sum += std::abs(setup.e(h, c));
    return sum;
}

namespace {

class InputBuilder {
public:
    explicit InputBuilder(const ChannelSetup& setup) : setup_(setup) {}

    InputSet build() {
        for (std::size_t h = 0; h < setup_.size(); ++h) add_reading(h);
        if (setup_.others != OtherLoads::none && setup_.size() > 1)
            for (std::size_t c = 0; c < setup_.size(); ++c) add_load(c);
        return std::move(inputs_);
    }

private:
    UncertaintyComponent component(const ForceChannel& channel, const std::string& id, const Message& name,
                                   Distribution distribution, const Message& origin) const {
        const std::string key = channel.kind().key;
        return {.id = key + "." + id,
                .name = tell<"%1 of %2">(name, key),
                .unit = Unit::of("mV/V"),
                .distribution = std::move(distribution),
                .origin = tell<"%1: %2">(setup_.sensor.name, origin),
                .contributor = setup_.sensor.id,
                .contributor_name = setup_.sensor.name,
                .tags = {{"source", Name::of(name)}}};
    }

    UncertaintyComponent repeatability(const ForceChannel& channel) const {
        const double u = u_repeatability(setup_, channel);
        const double freedom = channel.s_degrees_of_freedom(setup_.pooled);
        UncertaintyComponent a = component(channel, "repeatability", tell<"repeatability">(),
                                           Distribution::normal(u), tell<"Eqs 3, 4">());
        a.normal_draws = !setup_.student_t;
        a.type = EvaluationType::type_a;
        a.degrees_of_freedom = freedom;
        return a;
    }

    void add_reading(std::size_t h) {
        const ForceChannel& channel = setup_.channels()[h];
        const auto limits = [](double width) {
            return Distribution::of(Rectangular{-0.5 * width, 0.5 * width});
        };
        const std::string key = channel.kind().key;
        inputs_.add(InputQuantity{.symbol = std::string("d_") + key,
                                  .name = tell<"net reading of %1 at rated load">(key),
                                  .unit = Unit::of("mV/V"),
                                  .offset = channel.rated_output,
                                  .group = key},
                    {repeatability(channel),
                     component(channel, "machine", tell<"calibration machine">(),
                               Distribution::normal(channel.u_calibrator * std::abs(channel.rated_output)),
                               tell<"Eq 5">()),
                     component(channel, "resolution", tell<"resolution">(),
                               limits(setup_.sensor->resolution()), tell<"Eq 6">()),
                     component(channel, "zero", tell<"non-zero">(), limits(channel.zero), tell<"Eq 7">()),
                     component(channel, "hysteresis", tell<"hysteresis">(), limits(channel.hysteresis),
                               tell<"Eq 10, as a rectangular distribution over the loop">())});
    }

    void add_load(std::size_t c) {
        const ForceChannel& channel = setup_.channels()[c];
        const std::string key = channel.kind().key;
        UncertaintyComponent load{.id = key + ".load",
                                  .name = tell<"unknown load on %1">(key),
                                  .unit = Unit::of("%"),
                                  .distribution = Distribution::of(Rectangular{-1.0, 1.0}),
                                  .origin = tell<"set-up: unknown between minus and plus the rated load">(),
                                  .contributor = own_name<"loads on other axes">(),
                                  .tags = {{"source", own_name<"interference">()}}};
        inputs_.add(InputQuantity{.symbol = std::string("q_") + key,
                                  .name = tell<"load on %1 by its rated load">(key),
                                  .unit = Unit::of("%"),
                                  .offset = 0.0,
                                  .group = own_name<"loads">()},
                    {std::move(load)});
    }

    const ChannelSetup& setup_;
    InputSet inputs_;
};

}  // namespace

InputSet inputs(const ChannelSetup& setup) {
    return InputBuilder(setup).build();
}

}  // namespace covaria::force_channels
