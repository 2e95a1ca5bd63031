// Components of uncertainty keep their SI values whatever unit they are shown in: all units, all kinds.
#include "core/project/component_edit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/unit_table.h"

namespace covaria::component_edit_test {
namespace {

/// Some parameters that are possible for the kind, in its own unit.
std::vector<double> parameters_of(const DistributionKindInfo& kind) {
    if (kind.key == "histogram") return {-1.5, 0.5, 2.0, 0.25, 0.75};
    if (kind.parameters.empty()) return {-1.5, 2.0, 0.25, 0.75};
    std::vector<double> parameters;
    for (const DistributionParameterInfo& info : kind.parameters)
        parameters.push_back(info.key == "low"           ? -1.25
                             : info.key == "mean"        ? 0.75
                             : info.key == "beta"        ? 0.5
                             : info.key == "high"        ? 2.5
                             : info.key == "inexactness" ? 0.1
                             : info.key == "trials"      ? 7.0
                             : info.key == "probability" ? 0.3
                                                         : 1.5);
    return parameters;
}

void expect_same(const ComponentEdit& before, const ComponentEdit& after) {
    const auto a = distribution_of(before), b = distribution_of(after);
    ASSERT_TRUE(a) << before.distribution << ": " << a.error().message.english();
    ASSERT_TRUE(b) << before.distribution << " in " << after.unit.text() << ": "
                   << b.error().message.english();
    const double tolerance = 1e-13 * (std::abs(a->mean()) + a->standard_uncertainty());
    EXPECT_NEAR(b->mean(), a->mean(), tolerance) << before.distribution << " in " << after.unit.text();
    EXPECT_NEAR(b->standard_uncertainty(), a->standard_uncertainty(), tolerance) << after.unit.text();
}

TEST(ComponentEdit, NoUnitChangesTheQuantity) {
    const std::vector<detail::KnownUnit> units = detail::all_units();
    for (const auto& from : units)
        for (const auto& to : units) {
            if (!(from.dimension == to.dimension) || (&from - &to) % 5 != 0) continue;
            const ComponentEdit edit{"", "normal", {0.75, 1.5}, Unit::of(from.name)};
            expect_same(edit, in_unit(edit, Unit::of(to.name)));
        }
}

TEST(ComponentEdit, NoScaleOfTemperatureMovesAnyKind) {
    for (const DistributionKindInfo& kind : distribution_kinds())
        for (const char* from : {"K", "mK", "degC"})
            for (const char* to : {"K", "mK", "degC"}) {
                const ComponentEdit edit{"", std::string(kind.key), parameters_of(kind), Unit::of(from)};
                const ComponentEdit changed = in_unit(edit, Unit::of(to));
                expect_same(edit, changed);
                expect_same(edit, in_unit(changed, Unit::of(from)));
                UncertaintyComponent component;
                component.unit = Unit::of(to);
                component.distribution = *distribution_of(edit);
                expect_same(edit, to_edit(component));
            }
}

}  // namespace
}  // namespace covaria::component_edit_test
