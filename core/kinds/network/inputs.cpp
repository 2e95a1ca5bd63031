// Input quantities of "points from sensors": stations of every set-up, then the readings.
#include <cctype>
#include <map>

#include "core/base/name.h"
#include "core/kinds/network/setup.h"
#include "core/kinds/points/stated_figure.h"
#include "core/quantity/input_quantity.h"

namespace covaria::network {

namespace {

/// Part of a symbol that stands for a target or sensor: letters and digits of the name, else the number.
std::string label_of(const std::string& name, std::size_t index) {
    std::string label;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c))) label += c;
    return label.empty() || label.size() > 6 ? std::to_string(index + 1) : label;
}

class InputBuilder {
public:
    explicit InputBuilder(const NetworkSetup& setup) : setup_(setup) {}

    InputSet build() {
        for (std::size_t k = 0; k < setup_.stations; ++k)
            for (std::size_t s = 0; s < setup_.sensors.size(); ++s) add_station(k, s);
        for (std::size_t t = 0; t < setup_.targets.size(); ++t)
            for (std::size_t i = 0; i < setup_.targets[t].sights.size(); ++i) add_sight(t, i);
        for (const ScaleBar& bar : setup_.bars) add_scale_bar(bar);
        return std::move(inputs_);
    }

private:
    std::string sensor_label(std::size_t s) const { return label_of(setup_.sensors[s].name, s); }

    void add_station(std::size_t set_up, std::size_t s) {
        static const char* const symbols[] = {"x", "y", "z", "omega", "phi", "kappa"};
        const Sensor& sensor = setup_.sensors[s];
        const std::string again = set_up == 0 ? "" : "_" + std::to_string(set_up + 1);
        const std::size_t first = inputs_.components.size();
        for (std::size_t i = 0; i < 6; ++i) {
            UncertaintyComponent component = sensor->station_components()[i];
            InputQuantity quantity;
            quantity.symbol = std::string(symbols[i]) + "_" + sensor_label(s) + again;
            quantity.name = set_up == 0 ? tell<"%1, %2">(sensor.name, component.name)
                                        : tell<"%1, %2, set-up %3">(sensor.name, component.name, set_up + 1);
            quantity.unit = component.unit;
            quantity.offset = sensor->station().coordinates[i];
            quantity.group = sensor.name;
            component.id = sensor.id + "." + component.id + again;
            component.origin = tell<"%1 (%2)">(sensor.name, std::move(component.origin));
            component.contributor = sensor.id;
            component.contributor_name = sensor.name;
            if (set_up == 0) component.identity = component.id;  // later ones stand somewhere else
            quantity.shares.push_back({inputs_.add(std::move(component)), 1.0});
            inputs_.quantities.push_back(std::move(quantity));
        }
        for (const StationCorrelation& c : sensor->station_correlations())
            inputs_.correlations.push_back({first + c.first, first + c.second, c.coefficient});
    }

    void add_sight(std::size_t t, std::size_t i) {
        static const char* const symbols[] = {"d", "theta", "phi"};
        constexpr const char* across_symbol = "q";
        const Target& target = setup_.targets[t];
        const Sight& sight = target.sights[i];
        const Sensor& sensor = setup_.sensors[sight.sensor];
        const LinearReading reading = sensitivity_of(setup_, target, sight);
        const std::string suffix = label_of(target.name, t) + "_" + sensor_label(sight.sensor);
        const std::string again = repeats_[{t, sight.sensor}]++ == 0 ? "" : "_" + std::to_string(i + 1);
        for (std::size_t o = 0; o < 3; ++o) {
            if (!sight.has[o]) continue;
            const bool across = sight.overhead && observables[o] == Observable::azimuth;
            UncertaintyComponent component = sensor->reading(observables[o], reading.v);
            InputQuantity quantity;
            quantity.symbol = std::string(across ? across_symbol : symbols[o]) + "_" + suffix + again;
            quantity.name =
                tell<"%1 to %2, %3">(sensor.name, target.name,
                                     across ? tell<"displacement across the azimuth">() : component.name);
            quantity.unit = o == 0 || across ? Unit::of("mm") : Unit::of("deg");
            quantity.offset = across ? 0.0 : sight.reading[o];
            quantity.group = target.name;
            quantity.source = sight.source[o];
            component.id = target.name + "." + sensor.id + "." + component.id + again;
            component.origin = tell<"%1 (%2)">(sensor.name, std::move(component.origin));
            component.contributor = sensor.id;
            component.contributor_name = sensor.name;
            quantity.shares.push_back({inputs_.add(std::move(component)), reading.scale(observables[o])});
            add_systematic(sensor, observables[o], reading, quantity);
            inputs_.quantities.push_back(std::move(quantity));
        }
    }

    void add_scale_bar(const ScaleBar& bar) {
        const std::string ends =
            label_of(setup_.targets[bar.from].name, bar.from) + label_of(setup_.targets[bar.to].name, bar.to);
        const std::string again = bars_[ends]++ == 0 ? "" : "_" + std::to_string(bars_[ends]);
        UncertaintyComponent component{.id = "bar." + ends + again,
                                       .name = tell<"calibrated length">(),
                                       .unit = Unit::of("mm"),
                                       .distribution = distribution_of_shape(bar.distribution, bar.u),
                                       .origin = tell<"calibration of the %1">(bar.name),
                                       .contributor = "bar of length " + bar.name.english(),
                                       .contributor_name = Name::of(bar.name)};
        InputQuantity quantity;
        quantity.symbol = "L_" + ends + again;
        quantity.name = tell<"%1, calibrated length">(bar.name);
        quantity.unit = Unit::of("mm");
        quantity.offset = bar.length;
        quantity.group = own_name<"calibrated lengths">();
        quantity.source = bar.source;
        quantity.shares.push_back({inputs_.add(std::move(component)), 1.0});
        inputs_.quantities.push_back(std::move(quantity));
    }

    void add_systematic(const Sensor& sensor, Observable o, const LinearReading& reading,
                        InputQuantity& quantity) {
        for (const SystematicDeviation& deviation : sensor->systematic()) {
            const double factor = reading.effect_of(deviation, o);
            if (factor == 0.0) continue;
            const std::string id = sensor.id + "." + deviation.component.id;
            const auto [known, is_new] = shared_.try_emplace(id, inputs_.components.size());
            if (is_new) {
                UncertaintyComponent component = deviation.component;
                component.id = component.identity = id;
                component.origin = tell<"%1 (%2)">(sensor.name, std::move(component.origin));
                component.contributor = sensor.id;
                component.contributor_name = sensor.name;
                inputs_.add(std::move(component));
            }
            quantity.shares.push_back({known->second, factor});
        }
    }

    const NetworkSetup& setup_;
    InputSet inputs_;
    std::map<std::string, std::size_t> shared_;
    std::map<std::pair<std::size_t, std::size_t>, int> repeats_;
    std::map<std::string, int> bars_;
};

}  // namespace

void number_inputs(NetworkSetup& setup) {
    std::size_t number = setup.station_input(setup.stations, 0);
    for (Target& target : setup.targets)
        for (Sight& sight : target.sights)
            for (std::size_t o = 0; o < 3; ++o)
                if (sight.has[o]) sight.input[o] = number++;
    for (ScaleBar& bar : setup.bars) bar.input = number++;
}

InputSet network_inputs(const NetworkSetup& setup) {
    return InputBuilder(setup).build();
}

}  // namespace covaria::network
