// Fields of "force-moment loads".
#include "core/kinds/force/loads_setup.h"

namespace covaria::force_loads {

namespace {

using Given = LoadsSetup::Given;

Columns<Given> case_columns(const std::array<ColumnSpec, most_channels>& figures) {
    return Columns<Given>()
        .add(&Given::name, "name", "name", "Names the case in results.")
        .each(&Given::figures, figures);
}

void add_cases(Fields<LoadsSetup>& fields) {
    auto loads = axis_columns({}, "Load on this axis.");
    for (std::size_t i = 0; i < most_channels; ++i) loads[i].unit = Unit::of(force_axes[i].unit);
    fields.section("Cases")
        .choice(&LoadsSetup::by_loads, "given", "Cases are given by",
                "Readings that were taken, or loads whose uncertainty is wanted.",
                {{false, "readings", "readings"}, {true, "loads", "loads"}}, true)
        .table(&LoadsSetup::readings, "readings", "Readings",
               "Net readings of all channels, the unloaded readings subtracted.",
               case_columns(axis_columns(Unit::of("mV/V"), "Net reading of this channel.")),
               {.optional = true, .measured = true})
        .table(&LoadsSetup::loads, "loads", "Loads",
               "Forces and moments that act together; the readings follow from the calibration "
               "matrix. An empty cell is zero.",
               case_columns(loads), {.optional = true})
        .shown_where(&LoadsSetup::by_loads, {false}, &LoadsSetup::readings)
        .shown_where(&LoadsSetup::by_loads, {true}, &LoadsSetup::loads);
}

void add_method(Fields<LoadsSetup>& fields) {
    fields.section("Method")
        .choice(&LoadsSetup::quadratic, "matrix", "Calibration matrix",
                "Least squares through zero over the increasing readings: slopes alone, or with the "
                "squares of the loads.",
                {{false, "linear", "linear"}, {true, "quadratic", "with quadratic terms"}}, false)
        .choice(&LoadsSetup::pooled, "repeatability", "Repeatability of a reading",
                "The largest standard deviation of all steps, or that pooled over the steps.",
                {{false, "largest", "largest of the steps"}, {true, "pooled", "pooled over the steps"}},
                false)
        .choice(&LoadsSetup::student_t, "type_a", "Type A in Monte Carlo",
                "Normal, with its degrees of freedom in the law of propagation, or a t-distribution "
                "(JCGM 101 6.4.9), which has no standard deviation with n = 3.",
                {{false, "normal", "normal"}, {true, "student-t", "scaled and shifted t"}}, false)
        .choice(&LoadsSetup::full_hysteresis, "hysteresis", "Hysteresis of a reading",
                "Rectangular over the width of the loop: in proportion to the load on the "
                "channel's axis, or the full width at any load.",
                {{false, "proportional", "in proportion to the load"}, {true, "full", "full at any load"}},
                false);
}

}  // namespace

const Fields<LoadsSetup>& fields() {
    static const auto fields = [] {
        Fields<LoadsSetup> made;
        made.section("Sensor").add(&LoadsSetup::sensor, "sensor", "Sensor",
                                   "The calibrated multi-axis sensor.");
        add_cases(made);
        add_method(made);
        return made;
    }();
    return fields;
}

}  // namespace covaria::force_loads
