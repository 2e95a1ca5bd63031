// Input quantities of "TCP from ballbars": lengths between supports, readings, the robot's deviations.
#include <map>

#include "core/base/name.h"
#include "core/kinds/ballbar/setup.h"
#include "core/quantity/input_quantity.h"

namespace covaria::tcp {

namespace {

class InputBuilder {
public:
    explicit InputBuilder(const TcpSetup& setup) : setup_(setup) {}

    TcpInputs build() {
        for (const SupportLength& length : setup_.ballbars->support_lengths()) add_support_length(length);
        for (std::size_t k = 0; k < setup_.ballbars->heights().size(); ++k) add_height(k);
        std::vector<PointInputs> of_points;
        for (const Point& point : setup_.points) {
            PointInputs& places = of_points.emplace_back();
            places.reading = inputs_.quantities.size();
            for (std::size_t bar = 0; bar < setup_.supports.size(); ++bar) add_reading(point, bar);
            if (setup_.robot) add_robot(point, places);
        }
        return {std::move(inputs_), std::move(of_points)};
    }

private:
    struct Owner {
        std::string id, name;
    };
    Owner instrument() const { return {setup_.ballbars.id, setup_.ballbars.name}; }

    std::size_t add_component(UncertaintyComponent component, const std::string& id, const Owner& owner) {
        component.id = id;
        component.origin = tell<"%1 (%2)">(owner.name, component.origin);
        component.contributor = owner.id;
        component.contributor_name = owner.name;
        return inputs_.add(std::move(component));
    }

    void add_quantity(InputQuantity quantity, const UncertaintyComponent& component, const std::string& id,
                      const Owner& owner) {
        quantity.unit = component.unit;
        const auto& shares = quantity.shares;
        quantity.shares.insert(shares.begin(), {add_component(component, id, owner), 1.0});
        inputs_.quantities.push_back(std::move(quantity));
    }

    /// Shares of what other lengths share with this one; `bar` is one past the last for a support length.
    std::vector<Share> shared_of(std::size_t bar, double length) {
        std::vector<Share> shares;
        for (const SharedLengthDeviation& deviation : setup_.ballbars->shared()) {
            if (!deviation.is_scale && deviation.bar != bar) continue;
            const std::string id = setup_.ballbars.id + "." + deviation.component.id;
            const auto known = shared_.find(id);
            const std::size_t component =
                known != shared_.end() ? known->second : add_component(deviation.component, id, instrument());
            shared_[id] = component;
            inputs_.components[component].identity = id;
            shares.push_back({component, deviation.is_scale ? length : 1.0});
        }
        return shares;
    }

    void add_support_length(const SupportLength& length) {
        InputQuantity quantity;
        quantity.symbol = "L_" + std::to_string(length.from + 1) + "-" + std::to_string(length.to + 1);
        quantity.name = length.component.name;
        quantity.offset = length.length;
        quantity.group = own_name<"supports">();
        quantity.shares = shared_of(setup_.supports.size(), length.length);
        add_quantity(std::move(quantity), length.component, setup_.ballbars.id + "." + length.component.id,
                     instrument());
        inputs_.quantities.back().unit = Unit::of("mm");
        inputs_.components.back().identity = inputs_.components.back().id;
    }

    void add_height(std::size_t k) {
        const SupportHeight& height = setup_.ballbars->heights()[k];
        InputQuantity quantity;
        quantity.symbol = height.component.id;
        quantity.name = height.component.name;
        quantity.offset = height.z;
        quantity.group = own_name<"supports">();
        add_quantity(std::move(quantity), height.component, setup_.ballbars.id + "." + height.component.id,
                     instrument());
        inputs_.quantities.back().unit = Unit::of("mm");
        inputs_.components.back().identity = inputs_.components.back().id;
    }

    void add_reading(const Point& point, std::size_t bar) {
        const double length = point.length[bar];
        const UncertaintyComponent component = setup_.ballbars->reading(bar, length);
        InputQuantity quantity;
        quantity.symbol = component.id + "_" + point.label;
        quantity.name = tell<"%1, point %2">(component.name, point.name);
        quantity.offset = length + point.misfit[bar];
        quantity.group = point.name;
        quantity.source = point.source;
        quantity.shares = shared_of(bar, length);
        add_quantity(std::move(quantity), component, point.label + "." + component.id, instrument());
        inputs_.quantities.back().unit = Unit::of("mm");
    }

    void add_robot(const Point& point, PointInputs& places) {
        static const char* const position_symbols[] = {"e_x", "e_y", "e_z"};
        static const char* const rotation_symbols[] = {"omega_x", "omega_y", "omega_z"};
        places.position = add_deviations(point, setup_.robot->position(), position_symbols);
        const std::size_t first = inputs_.components.size() - 3;
        inputs_.vectors.push_back({{first, first + 1, first + 2}});
        if (setup_.turns)
            places.orientation = add_deviations(point, *setup_.robot->orientation(), rotation_symbols);
    }

    std::size_t add_deviations(const Point& point, const std::array<UncertaintyComponent, 3>& components,
                               const char* const* symbols) {
        const std::size_t first = inputs_.quantities.size();
        for (std::size_t c = 0; c < 3; ++c) {
            InputQuantity quantity;
            quantity.symbol = std::string(symbols[c]) + "_" + point.label;
            quantity.name = tell<"%1, point %2">(components[c].name, point.name);
            quantity.group = point.name;
            quantity.source = point.source;
            add_quantity(std::move(quantity), components[c], point.label + "." + components[c].id,
                         {setup_.robot.id, setup_.robot.name});
        }
        return first;
    }

    const TcpSetup& setup_;
    InputSet inputs_;
    std::map<std::string, std::size_t> shared_;
};

}  // namespace

TcpInputs tcp_inputs(const TcpSetup& setup) {
    return InputBuilder(setup).build();
}

}  // namespace covaria::tcp
