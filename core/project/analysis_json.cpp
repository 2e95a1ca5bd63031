#include "core/project/analysis_json.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/project/design_json.h"
#include "core/project/json_lists.h"
#include "core/project/json_location.h"
#include "core/project/options_json.h"
#include "core/project/requirement_fields.h"
#include "core/project/setup_json.h"
#include "core/project/study_json.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

using Style = JsonWriter::Style;

constexpr std::array<const char*, 2> discrete_keys{"values", "probabilities"};

std::vector<std::string> distribution_keys() {
    std::vector<std::string> keys;
    for (const DistributionKindInfo& kind : distribution_kinds()) keys.emplace_back(kind.key);
    return keys;
}

// null is the infinity on the side that the parameter bounds.
double infinite_parameter(std::string_view key) {
    return key == "low" ? -infinity : infinity;
}

void read_lists(ObjectReader& reader, std::vector<double>& parameters) {
    for (const char* key : discrete_keys) {
        const Json* list = reader.list(key);
        if (!list) {
            if (!reader.has(key))
                reader.problems().error(reader.path_of(key), std::string("'") + key + "' is missing");
            continue;
        }
        for (const Json& number : *list) {
            if (number.is_number())
                parameters.push_back(number.get<double>());
            else
                reader.problems().error(reader.path_of(key),
                                        std::string("'") + key + "' must be a list of numbers");
        }
    }
}

std::vector<double> read_parameters(const Json& value, const DistributionKindInfo& kind,
                                    const std::string& path, Problems& problems) {
    std::vector<double> parameters;
    ObjectReader reader(value, path, "the parameters of '" + std::string(kind.key) + "'", problems);
    if (kind.parameters.empty()) read_lists(reader, parameters);
    for (const DistributionParameterInfo& parameter : kind.parameters) {
        const std::string key(parameter.key);
        const bool infinite = reader.has(key) && value.at(key).is_null();
        const auto number = infinite ? reader.number_or_infinity(key) : reader.number(key, true);
        if (number) parameters.push_back(infinite ? infinite_parameter(key) : *number);
    }
    reader.refuse_unknown_keys();
    return parameters;
}

EvaluationType read_type(ObjectReader& reader) {
    const std::string type = reader.text("type");
    if (!type.empty() && type != "A" && type != "B")
        reader.problems().error(reader.path_of("type"), "'type' must be 'A' or 'B'; it is '" + type + "'");
    return type == "A" ? EvaluationType::type_a : EvaluationType::type_b;
}

ComponentEdit read_component(const Json& value, const std::string& path, Problems& problems) {
    ObjectReader reader(value, path, "a component", problems);
    ComponentEdit component;
    component.name = reader.text("name");
    component.distribution = reader.text("distribution", true);
    const Json* parameters = reader.find("parameters");
    const std::string unit = reader.text("unit", true);
    if (!unit.empty()) component.unit = unit_from(unit, reader.path_of("unit"), problems);
    component.type = read_type(reader);
    component.degrees_of_freedom = reader.number_or_infinity("degreesOfFreedom");
    component.origin = reader.text("origin");
    reader.refuse_unknown_keys();
    const DistributionKindInfo* kind = find_distribution_kind(component.distribution);
    if (!kind && !component.distribution.empty())
        problems.error(reader.path_of("distribution"),
                       "there is no distribution '" + component.distribution + "'" +
                           did_you_mean(component.distribution, distribution_keys()) + "; known are " +
                           listed(distribution_keys()));
    if (kind && !parameters && value.is_object())
        problems.error(reader.path_of("parameters"), "'parameters' is missing in a component");
    if (kind && parameters)
        component.parameters = read_parameters(*parameters, *kind, reader.path_of("parameters"), problems);
    return component;
}

void read_combination(ObjectReader& reader, InputEdit& edit) {
    const std::string rule = reader.text("combination");
    if (rule == "quadrature") edit.combination = Combination::quadrature;
    if (rule == "arithmetic") edit.combination = Combination::arithmetic;
    if (!rule.empty() && !edit.combination)
        reader.problems().error(reader.path_of("combination"),
                                "'combination' must be 'quadrature' or 'arithmetic'; it is '" + rule + "'");
}

InputEdit read_input(const Json& value, const std::string& path, Problems& problems) {
    ObjectReader reader(value, path, "the edit of an input quantity", problems);
    InputEdit edit;
    edit.symbol = reader.text("symbol", true);
    edit.estimate = reader.quantity("estimate");
    if (const Json* list = reader.list("components")) {
        edit.components.emplace();
        for (std::size_t i = 0; i < list->size(); ++i)
            edit.components->push_back(
                read_component((*list)[i], reader.path_of("components") + "/" + std::to_string(i), problems));
    }
    read_combination(reader, edit);
    edit.held = reader.flag("held").value_or(false);
    reader.refuse_unknown_keys();
    return edit;
}

InputLink read_link(const Json& value, const std::string& path, Problems& problems) {
    ObjectReader reader(value, path, "a link", problems);
    InputLink link;
    link.input = reader.text("input", true);
    link.output.analysis = reader.text("analysis", true);
    link.output.group = reader.text("group");
    link.output.symbol = reader.text("output", true);
    link.linearised = reader.flag("linearised").value_or(false);
    reader.refuse_unknown_keys();
    return link;
}

CorrelationEdit read_correlation(const Json& value, const std::string& path, Problems& problems) {
    ObjectReader reader(value, path, "a correlation", problems);
    CorrelationEdit edit;
    edit.first = reader.text("first", true);
    edit.second = reader.text("second", true);
    edit.coefficient = reader.number("coefficient", true).value_or(0.0);
    reader.refuse_unknown_keys();
    return edit;
}

Requirement read_requirement(const Json& value, const std::string& path, Problems& problems) {
    ObjectReader reader(value, path, "a requirement", problems);
    Requirement requirement;
    requirement.group = reader.text("group");
    requirement.symbol = reader.text("symbol", true);
    for (const RequirementField& field : requirement_fields()) {
        if (const auto* number = std::get_if<double Requirement::*>(&field.member))
            requirement.** number = reader.number(field.key).value_or(requirement.**number);
        else
            set_value(requirement, field, reader.quantity(field.key));
    }
    reader.refuse_unknown_keys();
    return requirement;
}

void text_if_given(JsonWriter& out, const char* key, const std::string& text) {
    if (text.empty()) return;
    out.key(key);
    out.text(text);
}

void quantity_if_given(JsonWriter& out, const char* key, const std::optional<Quantity>& quantity) {
    if (!quantity) return;
    out.key(key);
    write_quantity(out, *quantity);
}

void write_number_list(JsonWriter& out, const char* key, std::span<const double> numbers) {
    out.key(key);
    out.begin_list();
    for (const double number : numbers) out.finite_number(number);
    out.end();
}

void write_parameters(JsonWriter& out, const ComponentEdit& component) {
    const DistributionKindInfo* kind = find_distribution_kind(component.distribution);
    const std::span<const double> numbers(component.parameters);
    out.begin_object(Style::one_line);
    if (kind && kind->parameters.empty()) {
        write_number_list(out, discrete_keys[0], numbers.first(numbers.size() / 2));
        write_number_list(out, discrete_keys[1], numbers.subspan(numbers.size() / 2));
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

void write_component(JsonWriter& out, const ComponentEdit& component) {
    out.begin_object(Style::one_line);
    text_if_given(out, "name", component.name);
    out.key("distribution");
    out.text(component.distribution);
    out.key("parameters");
    write_parameters(out, component);
    out.key("unit");
    out.text(component.unit.text());
    if (component.type == EvaluationType::type_a) {
        out.key("type");
        out.text("A");
    }
    if (component.degrees_of_freedom) {
        out.key("degreesOfFreedom");
        out.number(*component.degrees_of_freedom);
    }
    text_if_given(out, "origin", component.origin);
    out.end();
}

void write_input(JsonWriter& out, const InputEdit& edit) {
    out.begin_object(edit.components && !edit.components->empty() ? Style::spread : Style::one_line);
    out.key("symbol");
    out.text(edit.symbol);
    if (edit.estimate) {
        out.key("estimate");
        write_quantity(out, *edit.estimate);
    }
    if (edit.components) {
        out.key("components");
        out.begin_list();
        for (const ComponentEdit& component : *edit.components) write_component(out, component);
        out.end();
    }
    if (edit.combination)
        text_if_given(out, "combination",
                      *edit.combination == Combination::arithmetic ? "arithmetic" : "quadrature");
    if (edit.held) {
        out.key("held");
        out.boolean(true);
    }
    out.end();
}

void write_link(JsonWriter& out, const InputLink& link) {
    out.begin_object(Style::one_line);
    out.key("input");
    out.text(link.input);
    out.key("analysis");
    out.text(link.output.analysis);
    text_if_given(out, "group", link.output.group);
    out.key("output");
    out.text(link.output.symbol);
    if (link.linearised) {
        out.key("linearised");
        out.boolean(true);
    }
    out.end();
}

void write_correlation(JsonWriter& out, const CorrelationEdit& edit) {
    out.begin_object(Style::one_line);
    out.key("first");
    out.text(edit.first);
    out.key("second");
    out.text(edit.second);
    out.key("coefficient");
    out.finite_number(edit.coefficient);
    out.end();
}

void write_requirement(JsonWriter& out, const Requirement& requirement) {
    out.begin_object(Style::one_line);
    text_if_given(out, "group", requirement.group);
    out.key("symbol");
    out.text(requirement.symbol);
    for (const RequirementField& field : requirement_fields()) {
        const auto* number = std::get_if<double Requirement::*>(&field.member);
        if (!number) {
            quantity_if_given(out, field.key, value_of(requirement, field));
        } else if (requirement.**number != Requirement{}.**number) {
            out.key(field.key);
            out.finite_number(requirement.**number);
        }
    }
    out.end();
}

}  // namespace

void read_analysis_details(ObjectReader& reader, AnalysisEntry& analysis) {
    read_list(reader, "links", analysis.links, read_link);
    read_list(reader, "inputs", analysis.inputs, read_input);
    read_list(reader, "correlations", analysis.correlations, read_correlation);
    if (const Json* options = reader.find("options"))
        analysis.options = options_from_json(*options, reader.path_of("options"), reader.problems());
    read_list(reader, "requirements", analysis.requirements, read_requirement);
    read_list(reader, "studies", analysis.studies, study_from_json);
    read_list(reader, "designs", analysis.designs, design_from_json);
}

void write_analysis_details(JsonWriter& out, const AnalysisEntry& analysis) {
    write_list(out, "links", analysis.links, write_link);
    write_list(out, "inputs", analysis.inputs, write_input);
    write_list(out, "correlations", analysis.correlations, write_correlation);
    if (analysis.options != EvaluationOptions{}) {
        out.key("options");
        write_options(out, analysis.options);
    }
    write_list(out, "requirements", analysis.requirements, write_requirement);
    write_list(out, "studies", analysis.studies, write_study);
    write_list(out, "designs", analysis.designs, write_design);
}

}  // namespace covaria
