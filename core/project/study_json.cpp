// Studies to and from JSON.
#include "core/project/study_json.h"

#include <algorithm>
#include <array>

#include "core/setup/message_text.h"

namespace covaria {

namespace {

using Style = JsonWriter::Style;

template <class T>
struct Word {
    T value;
    const char* key;
};
constexpr std::array<Word<StudyChange>, 3> changes{
    {{StudyChange::value, "value"}, {StudyChange::factor, "factor"}, {StudyChange::added, "added"}}};
constexpr std::array<Word<StudySpacing>, 2> spacings{
    {{StudySpacing::linear, "linear"}, {StudySpacing::logarithmic, "logarithmic"}}};
constexpr std::array<Word<Method>, 2> study_methods{
    {{Method::first_order, "first-order"}, {Method::monte_carlo, "monte-carlo"}}};

template <class T, std::size_t N>
const char* key_of(const std::array<Word<T>, N>& words, T value) {
    for (const Word<T>& word : words)
        if (word.value == value) return word.key;
    return "";
}

template <class T, std::size_t N>
void read_word(ObjectReader& reader, const std::string& key, const std::array<Word<T>, N>& words, T& out) {
    const std::string text = reader.text(key);
    if (text.empty()) return;
    std::vector<std::string> known;
    for (const Word<T>& word : words) {
        if (text == word.key) out = word.value;
        known.emplace_back(word.key);
    }
    if (std::find(known.begin(), known.end(), text) == known.end())
        reader.problems().error(reader.path_of(key), "'" + key + "' must be one of " + listed(known) +
                                                         "; it is '" + text + "'" +
                                                         did_you_mean(text, known));
}

template <class Count>
void read_count(ObjectReader& reader, const std::string& key, Count& out) {
    const auto number = reader.number(key);
    if (!number) return;
    if (*number >= 0 && *number <= 1e15 && *number == static_cast<double>(static_cast<Count>(*number)))
        out = static_cast<Count>(*number);
    else
        reader.problems().error(
            reader.path_of(key),
            "'" + key + "' must be a whole number that is not negative; it is " + readable_number(*number));
}

StudyAxis read_axis(const Json& value, const std::string& path, Problems& problems) {
    ObjectReader reader(value, path, "an axis of a study", problems);
    StudyAxis axis;
    axis.asset = reader.text("asset");
    axis.target = reader.text("target", true);
    read_word(reader, "change", changes, axis.change);
    axis.from = reader.number("from", true).value_or(0.0);
    axis.to = reader.number("to", true).value_or(1.0);
    const std::string unit = reader.text("unit");
    if (!unit.empty()) axis.unit = unit_from(unit, reader.path_of("unit"), problems);
    read_count(reader, "values", axis.values);
    read_word(reader, "spacing", spacings, axis.spacing);
    reader.refuse_unknown_keys();
    return axis;
}

StudyOutput read_output(const Json& value, const std::string& path, Problems& problems) {
    ObjectReader reader(value, path, "an output of a study", problems);
    StudyOutput output{reader.text("group"), reader.text("symbol", true)};
    reader.refuse_unknown_keys();
    return output;
}

void write_axis(JsonWriter& out, const StudyAxis& axis) {
    out.begin_object(Style::one_line);
    if (!axis.asset.empty()) out.member("asset", axis.asset);
    out.member("target", axis.target);
    if (axis.change != StudyChange::value) out.member("change", key_of(changes, axis.change));
    out.key("from");
    out.finite_number(axis.from);
    out.key("to");
    out.finite_number(axis.to);
    if (!(axis.unit == Unit{})) out.member("unit", axis.unit.text());
    out.key("values");
    out.integer(axis.values);
    if (axis.spacing != StudySpacing::linear) out.member("spacing", key_of(spacings, axis.spacing));
    out.end();
}

void write_output(JsonWriter& out, const StudyOutput& output) {
    out.begin_object(Style::one_line);
    if (!output.group.empty()) out.member("group", output.group);
    out.member("symbol", output.symbol);
    out.end();
}

}  // namespace

Study study_from_json(const Json& value, const std::string& path, Problems& problems) {
    ObjectReader reader(value, path, "a study", problems);
    Study study;
    study.id = reader.text("id", true);
    study.name = reader.text("name");
    const Json* axes = reader.list("axes");
    if (!axes && value.is_object() && !reader.has("axes"))
        problems.error(reader.path_of("axes"), "'axes' is missing in a study");
    for (std::size_t i = 0; axes && i < axes->size(); ++i)
        study.axes.push_back(
            read_axis((*axes)[i], reader.path_of("axes") + "/" + std::to_string(i), problems));
    const Json* outputs = reader.list("outputs");
    for (std::size_t i = 0; outputs && i < outputs->size(); ++i)
        study.outputs.push_back(
            read_output((*outputs)[i], reader.path_of("outputs") + "/" + std::to_string(i), problems));
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
    if (!study.outputs.empty()) {
        out.key("outputs");
        out.begin_list();
        for (const StudyOutput& output : study.outputs) write_output(out, output);
        out.end();
    }
    if (study.method != defaults.method) out.member("method", key_of(study_methods, study.method));
    if (study.trials != defaults.trials) {
        out.key("trials");
        out.integer(study.trials);
    }
    out.end();
}

}  // namespace covaria
