#include "core/project/edit_fields.h"

#include <cmath>
#include <span>

namespace covaria {

namespace {

using Style = JsonWriter::Style;

constexpr const char* probabilities_key = "probabilities";

std::vector<std::string> distribution_keys() {
    std::vector<std::string> keys;
    for (const DistributionKindInfo& kind : distribution_kinds()) keys.emplace_back(kind.key);
    return keys;
}

// The infinity that null means, on the side that the parameter bounds.
double infinite_parameter(std::string_view key) {
    return key == "low" ? -infinity : infinity;
}

void read_lists(ObjectReader& reader, const DistributionKindInfo& kind, std::vector<double>& parameters) {
    for (const std::string& key : {std::string(kind.list), std::string(probabilities_key)}) {
        const Json* list = reader.list(key, true);
        for (std::size_t i = 0; list && i < list->size(); ++i) {
            if ((*list)[i].is_number())
                parameters.push_back((*list)[i].get<double>());
            else
                reader.problems().error(reader.path_of(key), tell<"'%1' must be a list of numbers">(key));
        }
    }
}

std::vector<double> read_parameters(const Json& value, const DistributionKindInfo& kind,
                                    const std::string& path, Problems& problems) {
    std::vector<double> parameters;
    ObjectReader reader(value, path, tell<"the parameters of '%1'">(kind.key), problems);
    if (kind.parameters.empty()) read_lists(reader, kind, parameters);
    for (const DistributionParameterInfo& parameter : kind.parameters) {
        const std::string key(parameter.key);
        const bool infinite = reader.has(key) && value.at(key).is_null();
        const auto number = infinite ? reader.number_or_infinity(key) : reader.number(key, true);
        if (number) parameters.push_back(infinite ? infinite_parameter(key) : *number);
    }
    reader.refuse_unknown_keys();
    return parameters;
}

void write_number_list(JsonWriter& out, const char* key, std::span<const double> numbers) {
    out.key(key);
    JsonValue<std::vector<double>>::write(out, {numbers.begin(), numbers.end()});
}

void write_parameters(JsonWriter& out, const ComponentEdit& component) {
    const DistributionKindInfo* kind = find_distribution_kind(component.distribution);
    const std::span<const double> numbers(component.parameters);
    out.begin_object(Style::one_line);
    if (kind && kind->parameters.empty()) {
        const std::size_t first = first_list_size(numbers.size());
        write_number_list(out, std::string(kind->list).c_str(), numbers.first(first));
        write_number_list(out, probabilities_key, numbers.subspan(first));
    } else if (kind && kind->parameters.size() == numbers.size()) {
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const std::string_view key = kind->parameters[i].key;
            if (std::isinf(numbers[i]) && numbers[i] != infinite_parameter(key)) out.note_unwritable();
            out.key(key);
            out.number(numbers[i]);
        }
    } else {
        out.note_unwritable();
    }
    out.end();
}

/// The fields of a distribution: its key, and its parameters, whose keys follow from it.
JsonFields<ComponentEdit> stated_distribution() {
    return JsonFields<ComponentEdit>(tell<"a distribution">())
        .required("distribution", &ComponentEdit::distribution)
        .by_hand(
            "parameters", &ComponentEdit::parameters,
            [](ObjectReader& reader, const std::string& key, ComponentEdit& to) {
                const Json* parameters = reader.find(key);
                const DistributionKindInfo* kind = find_distribution_kind(to.distribution);
                if (!kind && !to.distribution.empty())
                    reader.problems().error(
                        reader.path_of("distribution"),
                        tell<"there is no distribution '%1'%2; known are %3">(
                            to.distribution, did_you_mean(to.distribution, distribution_keys()),
                            listed(distribution_keys())));
                if (kind && !parameters)
                    reader.problems().error(reader.path_of(key), tell<"'%1' is missing in a component">(key));
                if (kind && parameters)
                    to.parameters =
                        read_parameters(*parameters, *kind, reader.path_of(key), reader.problems());
            },
            write_parameters);
}

/// A number that may be infinite, or not given.
struct OptionalInfinity {
    void read(ObjectReader& reader, const std::string& key, bool, std::optional<double>& member) const {
        member = reader.number_or_infinity(key);
    }
    void write(JsonWriter& out, const std::optional<double>& member) const { out.number(*member); }
};

}  // namespace

const JsonFields<ComponentEdit>& component_fields() {
    static const auto fields =
        JsonFields<ComponentEdit>(tell<"a component">(), Style::one_line)
            .add("name", &ComponentEdit::name)
            .all_of(stated_distribution())
            .required("unit", &ComponentEdit::unit)
            .add("type", &ComponentEdit::type,
                 OneOf<EvaluationType>{{{EvaluationType::type_a, "A"}, {EvaluationType::type_b, "B"}}})
            .add("degreesOfFreedom", &ComponentEdit::degrees_of_freedom, OptionalInfinity{})
            .add("origin", &ComponentEdit::origin);
    return fields;
}

const JsonFields<InputEdit>& input_edit_fields() {
    static const auto fields =
        JsonFields<InputEdit>(tell<"the edit of an input quantity">(),
                              [](const InputEdit& edit) {
                                  return edit.components && !edit.components->empty() ? Style::spread
                                                                                      : Style::one_line;
                              })
            .required("symbol", &InputEdit::symbol)
            .add("estimate", &InputEdit::estimate)
            .add("components", &InputEdit::components, Optional{ListOf{component_fields()}})
            .add("combination", &InputEdit::combination,
                 Optional{OneOf<Combination>{
                     {{Combination::quadrature, "quadrature"}, {Combination::arithmetic, "arithmetic"}}}})
            .add("held", &InputEdit::held);
    return fields;
}

const JsonFields<QuantityNotes>& quantity_notes_fields() {
    static const auto fields = JsonFields<QuantityNotes>(tell<"the notes of a quantity">(), Style::one_line)
                                   .required("symbol", &QuantityNotes::symbol)
                                   .required("notes", &QuantityNotes::notes);
    return fields;
}

const JsonFields<OutputReference>& output_reference_fields() {
    static const auto fields = JsonFields<OutputReference>(tell<"an output of an analysis">())
                                   .required("analysis", &OutputReference::analysis)
                                   .add("group", &OutputReference::group)
                                   .required("output", &OutputReference::symbol);
    return fields;
}

const JsonFields<InputLink>& link_fields() {
    static const auto fields = JsonFields<InputLink>(tell<"a link">(), Style::one_line)
                                   .required("input", &InputLink::input)
                                   .part(&InputLink::output, output_reference_fields())
                                   .add("linearised", &InputLink::linearised);
    return fields;
}

const JsonFields<CorrelationEdit>& correlation_fields() {
    static const auto fields = JsonFields<CorrelationEdit>(tell<"a correlation">(), Style::one_line)
                                   .required("first", &CorrelationEdit::first)
                                   .required("second", &CorrelationEdit::second)
                                   .required("coefficient", &CorrelationEdit::coefficient);
    return fields;
}

}  // namespace covaria
