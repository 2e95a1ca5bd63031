#include "core/kinds/sheets/scatter.h"

namespace covaria::sheets {

UncertaintyComponent residual_component(std::string id, const Unit& unit, double u, double degrees_of_freedom,
                                        Message name, Message origin) {
    UncertaintyComponent component;
    component.id = std::move(id);
    component.name = std::move(name);
    component.unit = unit;
    component.distribution = Distribution::of(StudentT{0.0, u, degrees_of_freedom});
    component.type = EvaluationType::type_a;
    component.degrees_of_freedom = degrees_of_freedom;
    component.origin = std::move(origin);
    return component;
}

UncertaintyComponent deviation_component(std::string id, const Unit& unit, double s,
                                         double degrees_of_freedom, Message origin) {
    UncertaintyComponent component;
    component.id = std::move(id);
    component.name = tell<"few degrees of freedom of s">();
    component.unit = unit;
    component.distribution = Distribution::normal(u_of_deviation(s, degrees_of_freedom));
    component.type = EvaluationType::type_a;
    component.origin = std::move(origin);
    return component;
}

}  // namespace covaria::sheets
