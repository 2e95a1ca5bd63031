#include "app/schema_json.h"

#include "app/json_output.h"
#include "app/project_parts.h"
#include "core/kinds/registries.h"

namespace covaria {
namespace {

/// Keys of the project's schema, so that a program has one name for a kind of field.
const char* kind_key(FieldKind kind) {
    switch (kind) {
        case FieldKind::number:
            return "number";
        case FieldKind::integer:
            return "integer";
        case FieldKind::choice:
            return "choice";
        case FieldKind::text:
            return "text";
        case FieldKind::flag:
            return "flag";
        case FieldKind::pose:
            return "pose";
        case FieldKind::table:
            return "table";
        case FieldKind::reference:
            return "reference";
    }
    return "";
}

/// The default in a project file's form; null: it must be given, or is a table or a pose at rest.
OrderedJson default_json(const SetupValue& value) {
    if (const auto* quantity = std::get_if<Quantity>(&value)) {
        if (quantity->unit == Unit()) return json_number(quantity->value);
        return {{"value", json_number(quantity->value)}, {"unit", quantity->unit.text()}};
    }
    if (const auto* flag = std::get_if<bool>(&value)) return *flag;
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    return nullptr;
}

OrderedJson choices_json(const std::vector<Choice>& choices) {
    OrderedJson list = OrderedJson::array();
    for (const Choice& choice : choices) list.push_back({{"key", choice.key}, {"title", choice.title}});
    return list;
}

/// Members that fields and columns share; a bound that is null does not exist.
template <class Spec>
OrderedJson common_json(const Spec& spec) {
    OrderedJson json{
        {"key", spec.key}, {"title", spec.title}, {"kind", kind_key(spec.kind)}, {"optional", spec.optional}};
    if (spec.kind == FieldKind::number || spec.kind == FieldKind::integer) {
        json["unit"] = spec.unit.text();
        json["minimum"] = json_number(spec.unit.from_si(spec.range.low));
        json["minimumIsExcluded"] = spec.range.low_open;
        json["maximum"] = json_number(spec.unit.from_si(spec.range.high));
    }
    if (!spec.choices.empty()) json["choices"] = choices_json(spec.choices);
    if (!spec.capabilities.empty()) json["offers"] = spec.capabilities;
    json["help"] = spec.help;
    return json;
}

OrderedJson field_json(const FieldSpec& field) {
    OrderedJson json = common_json(field);
    if (field.kind != FieldKind::table) json["default"] = default_json(field.default_value);
    if (!field.section.empty()) json["section"] = field.section;
    if (field.shown_if) json["usedIf"] = {{"key", field.shown_if->key}, {"values", field.shown_if->values}};
    if (field.kind != FieldKind::table) return json;
    json["leastRows"] = field.min_rows;
    json["columns"] = OrderedJson::array();
    for (const ColumnSpec& column : field.columns) json["columns"].push_back(common_json(column));
    return json;
}

/// Adds the members that models and assets share, behind their names.
template <class Descriptor>
OrderedJson with_schema(OrderedJson json, const Descriptor& descriptor) {
    json["title"] = descriptor.title;
    json["summary"] = descriptor.summary;
    json["fields"] = OrderedJson::array();
    for (const FieldSpec& field : descriptor.schema.fields()) json["fields"].push_back(field_json(field));
    json["notes"] = descriptor.notes;
    json["references"] = OrderedJson::array();
    for (const Reference& reference : descriptor.references) json["references"].push_back(reference.text);
    return json;
}

}  // namespace

std::string list_of_descriptions_json() {
    OrderedJson json = json_document("covaria-description");
    json["models"] = json["assets"] = json["parts"] = OrderedJson::array();
    for (const ModelDescriptor& model : model_registry())
        json["models"].push_back({{"id", model.id}, {"title", model.title}});
    for (const AssetDescriptor& asset : asset_registry())
        json["assets"].push_back({{"kind", asset.kind}, {"title", asset.title}});
    for (const ProjectPart& part : project_parts())
        json["parts"].push_back({{"name", part.name}, {"title", part.title}});
    return json_text(json);
}

std::string description_json(const ModelDescriptor& model) {
    OrderedJson json = json_document("covaria-description");
    json["model"] = with_schema({{"id", model.id}}, model);
    OrderedJson equations = OrderedJson::array();
    for (const ModelEquation& equation : model.equations)
        equations.push_back({{"text", equation.text.english()}, {"source", equation.source.english()}});
    json["model"]["equations"] = std::move(equations);
    json["model"]["example"] = model.example;
    return json_text(json);
}

std::string description_json(const AssetDescriptor& asset) {
    OrderedJson json = json_document("covaria-description");
    json["asset"] = with_schema({{"kind", asset.kind}}, asset);
    return json_text(json);
}

}  // namespace covaria
