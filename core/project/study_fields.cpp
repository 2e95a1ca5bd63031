#include "core/project/study_fields.h"

namespace covaria {

using Style = JsonWriter::Style;

const JsonFields<StudyAxis>& varied_number_fields() {
    static const auto fields = JsonFields<StudyAxis>(tell<"a number that varies">(), Style::one_line)
                                   .add("asset", &StudyAxis::asset)
                                   .required("target", &StudyAxis::target)
                                   .add("change", &StudyAxis::change,
                                        OneOf<StudyChange>{{{StudyChange::value, "value"},
                                                            {StudyChange::factor, "factor"},
                                                            {StudyChange::added, "added"}}})
                                   .required("from", &StudyAxis::from)
                                   .required("to", &StudyAxis::to)
                                   .add("unit", &StudyAxis::unit);
    return fields;
}

const JsonFields<StudyAxis>& axis_fields() {
    static const auto fields = JsonFields<StudyAxis>(tell<"an axis of a study">(), Style::one_line)
                                   .all_of(varied_number_fields())
                                   .written("values", &StudyAxis::values)
                                   .add("spacing", &StudyAxis::spacing,
                                        OneOf<StudySpacing>{{{StudySpacing::linear, "linear"},
                                                             {StudySpacing::logarithmic, "logarithmic"}}});
    return fields;
}

const JsonFields<StudyOutput>& study_output_fields() {
    static const auto fields = JsonFields<StudyOutput>(tell<"an output of a study">(), Style::one_line)
                                   .add("group", &StudyOutput::group)
                                   .required("symbol", &StudyOutput::symbol);
    return fields;
}

const JsonFields<Study>& study_fields() {
    static const auto fields =
        JsonFields<Study>(tell<"a study">())
            .required("id", &Study::id)
            .add("name", &Study::name)
            .required("axes", &Study::axes, ListOf{axis_fields()})
            .add("outputs", &Study::outputs, ListOf{study_output_fields()})
            .add("method", &Study::method,
                 OneOf<Method>{{{Method::first_order, "first-order"}, {Method::monte_carlo, "monte-carlo"}}})
            .add("trials", &Study::trials);
    return fields;
}

}  // namespace covaria
