// Studies to and from JSON.
#include "core/project/study_json.h"

#include "core/project/study_json_parts.h"

namespace covaria {

namespace {

using Style = JsonWriter::Style;

constexpr std::array<Word<StudyChange>, 3> changes{
    {{StudyChange::value, "value"}, {StudyChange::factor, "factor"}, {StudyChange::added, "added"}}};
constexpr std::array<Word<StudySpacing>, 2> spacings{
    {{StudySpacing::linear, "linear"}, {StudySpacing::logarithmic, "logarithmic"}}};
constexpr std::array<Word<Method>, 2> study_methods{
    {{Method::first_order, "first-order"}, {Method::monte_carlo, "monte-carlo"}}};

StudyAxis read_axis(const Json& value, const std::string& path, Problems& problems) {
    ObjectReader reader(value, path, "an axis of a study", problems);
    StudyAxis axis;
    read_varied_number(reader, axis);
    read_count(reader, "values", axis.values);
    read_word(reader, "spacing", spacings, axis.spacing);
    reader.refuse_unknown_keys();
    return axis;
}

void write_axis(JsonWriter& out, const StudyAxis& axis) {
    out.begin_object(Style::one_line);
    write_varied_number(out, axis);
    out.key("values");
    out.integer(axis.values);
    if (axis.spacing != StudySpacing::linear) out.member("spacing", key_of(spacings, axis.spacing));
    out.end();
}

}  // namespace

void read_varied_number(ObjectReader& reader, StudyAxis& axis) {
    axis.asset = reader.text("asset");
    axis.target = reader.text("target", true);
    read_word(reader, "change", changes, axis.change);
    axis.from = reader.number("from", true).value_or(0.0);
    axis.to = reader.number("to", true).value_or(1.0);
    const std::string unit = reader.text("unit");
    if (!unit.empty()) axis.unit = unit_from(unit, reader.path_of("unit"), reader.problems());
}

void write_varied_number(JsonWriter& out, const StudyAxis& axis) {
    if (!axis.asset.empty()) out.member("asset", axis.asset);
    out.member("target", axis.target);
    if (axis.change != StudyChange::value) out.member("change", key_of(changes, axis.change));
    out.key("from");
    out.finite_number(axis.from);
    out.key("to");
    out.finite_number(axis.to);
    if (!(axis.unit == Unit{})) out.member("unit", axis.unit.text());
}

StudyOutput read_study_output(const Json& value, const std::string& path, Problems& problems) {
    ObjectReader reader(value, path, "an output of a study", problems);
    StudyOutput output{reader.text("group"), reader.text("symbol", true)};
    reader.refuse_unknown_keys();
    return output;
}

void write_study_output(JsonWriter& out, const StudyOutput& output) {
    out.begin_object(Style::one_line);
    if (!output.group.empty()) out.member("group", output.group);
    out.member("symbol", output.symbol);
    out.end();
}

Study study_from_json(const Json& value, const std::string& path, Problems& problems) {
    ObjectReader reader(value, path, "a study", problems);
    Study study;
    study.id = reader.text("id", true);
    study.name = reader.text("name");
    read_list(reader, "axes", study.axes, read_axis);
    if (value.is_object() && !reader.has("axes"))
        problems.error(reader.path_of("axes"), "'axes' is missing in a study");
    read_list(reader, "outputs", study.outputs, read_study_output);
    read_word(reader, "method", study_methods, study.method);
    read_count(reader, "trials", study.trials);
    reader.refuse_unknown_keys();
    return study;
}

void write_study(JsonWriter& out, const Study& study) {
    const Study defaults;
    out.begin_object();
    out.member("id", study.id);
    if (!study.name.empty()) out.member("name", study.name);
    out.key("axes");
    out.begin_list();
    for (const StudyAxis& axis : study.axes) write_axis(out, axis);
    out.end();
    write_list(out, "outputs", study.outputs, write_study_output);
    if (study.method != defaults.method) out.member("method", key_of(study_methods, study.method));
    if (study.trials != defaults.trials) {
        out.key("trials");
        out.integer(study.trials);
    }
    out.end();
}

}  // namespace covaria
