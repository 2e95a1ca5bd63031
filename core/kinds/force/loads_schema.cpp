// Fields of "force-moment loads".
#include "core/kinds/force/force_sensor.h"
#include "core/kinds/force/loads_setup.h"

namespace covaria::force_loads {

namespace {

FieldSpec case_table(const char* key, const char* title, const char* help, const Condition& condition) {
    FieldSpec table{.key = key,
                    .title = title,
                    .kind = FieldKind::table,
                    .help = help,
                    .optional = true,
                    .shown_if = condition,
                    .section = "Cases"};
    table.columns = {
        {.key = "name", .title = "name", .kind = FieldKind::text, .help = "Names the case in results."}};
    return table;
}

std::vector<FieldSpec> case_fields() {
    const Condition by_readings{"given", {"readings"}}, by_loads{"given", {"loads"}};
    FieldSpec readings =
        case_table("readings", "Readings", "Net readings of all channels, the unloaded readings subtracted.",
                   by_readings);
    FieldSpec loads = case_table("loads", "Loads",
                                 "Forces and moments that act together; the readings follow from the "
                                 "calibration matrix. An empty cell is zero.",
                                 by_loads);
    for (const ForceAxis& axis : force_axes) {
        readings.columns.push_back({.key = axis.key,
                                    .title = axis.key,
                                    .unit = Unit::of("mV/V"),
                                    .optional = true,
                                    .help = "Net reading of this channel."});
        loads.columns.push_back({.key = axis.key,
                                 .title = axis.key,
                                 .unit = Unit::of(axis.unit),
                                 .optional = true,
                                 .help = "Load on this axis."});
    }
    return {{.key = "given",
             .title = "Cases are given by",
             .kind = FieldKind::choice,
             .help = "Readings that were taken, or loads whose uncertainty is wanted.",
             .default_value = std::string("loads"),
             .choices = {{"readings", "readings"}, {"loads", "loads"}},
             .section = "Cases"},
            readings,
            loads};
}

std::vector<FieldSpec> method_fields() {
    return {
        {.key = "matrix",
         .title = "Calibration matrix",
         .kind = FieldKind::choice,
         .help = "Least squares through zero over the increasing readings: slopes alone, or with the "
                 "squares of the loads.",
         .default_value = std::string("linear"),
         .choices = {{"linear", "linear"}, {"quadratic", "with quadratic terms"}},
         .section = "Method"},
        {.key = "repeatability",
         .title = "Repeatability of a reading",
         .kind = FieldKind::choice,
         .help = "The largest standard deviation of all steps, or that pooled over the steps.",
         .default_value = std::string("largest"),
         .choices = {{"largest", "largest of the steps"}, {"pooled", "pooled over the steps"}},
         .section = "Method"},
        {.key = "type_a",
         .title = "Type A in Monte Carlo",
         .kind = FieldKind::choice,
         .help = "Normal, with its degrees of freedom in the law of propagation, or a t-distribution "
                 "(JCGM 101 6.4.9), which has no standard deviation with n = 3.",
         .default_value = std::string("normal"),
         .choices = {{"normal", "normal"}, {"student-t", "scaled and shifted t"}},
         .section = "Method"},
        {.key = "hysteresis",
         .title = "Hysteresis of a reading",
         .kind = FieldKind::choice,
         .help = "Rectangular over the width of the loop: in proportion to the load on the channel's axis, "
                 "or the full width at any load.",
         .default_value = std::string("proportional"),
         .choices = {{"proportional", "in proportion to the load"}, {"full", "full at any load"}},
         .section = "Method"}};
}

}  // namespace

SetupSchema schema() {
    std::vector<FieldSpec> fields{{.key = "sensor",
                                   .title = "Sensor",
                                   .kind = FieldKind::reference,
                                   .help = "The calibrated multi-axis sensor.",
                                   .capabilities = {ForceSensorSource::capability},
                                   .section = "Sensor"}};
    for (const std::vector<FieldSpec>& part : {case_fields(), method_fields()})
        fields.insert(fields.end(), part.begin(), part.end());
    return SetupSchema(std::move(fields));
}

}  // namespace covaria::force_loads
