#include "app/project_parts.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/json_output.h"
#include "app/schema_text.h"
#include "core/base/resource_path.h"
#include "core/quantity/distribution.h"

namespace covaria {
namespace {

using SchemaJson = nlohmann::ordered_json;

struct Definition {
    ProjectPart part;
    const char* in_schema;
};
const std::vector<Definition>& definitions() {
    static const std::vector<Definition> all{
        {{"certificate", "what a calibration certificate says beside its results"}, "certificate"},
        {{"review", "who prepared, checked and released it, and what was released"}, "review"},
        {{"amendment", "what the certificate stated that this one replaces"}, "amendment"},
        {{"report", "what goes into the report"}, "report"},
        {{"results", "units, digits and k of all results"}, "results"},
        {{"links", "input quantities taken from other analyses"}, "link"},
        {{"inputs", "edits of input quantities"}, "inputEdit"},
        {{"components", "components of uncertainty, in inputs"}, "component"},
        {{"correlations", "correlations between components"}, "correlation"},
        {{"options", "how it is evaluated"}, "options"},
        {{"requirements", "target uncertainties and tolerances"}, "requirement"},
        {{"studies", "sweeps and maps"}, "study"},
        {{"axes", "what a study varies"}, "studyAxis"},
        {{"designs", "where to stand, what to measure"}, "design"},
        {{"variables", "numbers that a design chooses"}, "designVariable"},
        {{"choose", "rows that a design chooses from"}, "designChoice"},
        {{"reductions", "what a design may pay for"}, "designReduction"},
        {{"boxes", "boxes of a design, in keepOut and hiddenBy"}, "designBox"},
        {{"views", "ways to look at the scene"}, "view"},
        {{"quantityNotes", "what people wrote about input quantities"}, "quantityNotes"},
        {{"certificates", "where the figures of an asset or an analysis come from"}, "figuresCertificate"}};
    return all;
}

std::string text_of(const SchemaJson& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// "a list of components" for a reference to a definition that has a description of its own.
std::string referred(const std::string& reference, bool list) {
    const std::string name = reference.substr(reference.rfind('/') + 1);
    for (const Definition& d : definitions())
        if (name == d.in_schema) return std::string(list ? "list, see " : "see ") + d.part.name;
    return name == "quantity" ? "quantity: {\"value\": 1.5, \"unit\": \"mm\"}" : name;
}

std::string kind_of(const SchemaJson& field) {
    if (field.contains("$ref")) return referred(field["$ref"], false);
    if (field.contains("enum")) return "choice";
    if (field.contains("anyOf")) return kind_of(field["anyOf"][0]) + ", or " + kind_of(field["anyOf"][1]);
    if (!field.contains("type")) return "";
    const SchemaJson& type = field["type"];
    const std::string name = type.is_array() ? text_of(type[0]) : text_of(type);
    if (name == "array" && field["items"].contains("$ref")) return referred(field["items"]["$ref"], true);
    if (name == "array") return "list";
    return name == "string"    ? "text"
           : name == "boolean" ? "flag"
           : name == "object"  ? "group"
           : name == "integer" ? "whole number"
                               : name;
}

std::string limits(const SchemaJson& field) {
    std::string text;
    static constexpr std::pair<const char*, const char*> bounds[] = {{"minimum", "at least "},
                                                                     {"exclusiveMinimum", "greater than "},
                                                                     {"maximum", "at most "},
                                                                     {"exclusiveMaximum", "less than "}};
    for (const auto& [key, words] : bounds)
        if (field.contains(key)) text += ", " + std::string(words) + text_of(field[key]);
    return text;
}

void write_object(std::ostringstream& out, const SchemaJson& object, const std::string& indent) {
    const SchemaJson none = SchemaJson::array();
    const SchemaJson& required = object.contains("required") ? object["required"] : none;
    for (const auto& [key, field] : object["properties"].items()) {
        const bool needed = std::find(required.begin(), required.end(), key) != required.end();
        out << indent << key << " (" << kind_of(field) << limits(field) << (needed ? "" : ", optional")
            << ")";
        if (field.contains("default")) out << "  default " << text_of(field["default"]);
        out << '\n';
        if (field.contains("description")) write_wrapped(out, text_of(field["description"]), indent + "    ");
        if (field.contains("enum"))
            for (const SchemaJson& choice : field["enum"])
                out << indent << "      " << text_of(choice) << '\n';
        if (field.contains("items") && field["items"].contains("properties"))
            write_object(out, field["items"], indent + "      ");
        if (field.contains("properties")) write_object(out, field, indent + "      ");
    }
}

void write_distributions(std::ostringstream& out) {
    out << "\nDistributions and their parameters\n";
    for (const DistributionKindInfo& kind : distribution_kinds()) {
        out << "  " << kind.key << ": ";
        if (kind.parameters.empty()) out << "values (in the unit), probabilities";
        for (std::size_t i = 0; i < kind.parameters.size(); ++i)
            out << (i ? ", " : "") << kind.parameters[i].key
                << (kind.parameters[i].has_unit ? " (in the unit)" : "");
        out << '\n';
    }
}

const Definition* find_definition(const std::string& name) {
    for (const Definition& definition : definitions())
        if (definition.part.name == name) return &definition;
    return nullptr;
}

/// All definitions of the schema of project files, of which one must be there.
Result<SchemaJson> read_definitions(const char* needed) {
    const auto file = data_directory() / "resources" / "schema" / "covaria-project.schema.json";
    std::ifstream in(file, std::ios::binary);
    SchemaJson schema = SchemaJson::parse(in, nullptr, false);
    if (!schema.is_object() || !schema.contains("$defs") || !schema["$defs"].contains(needed))
        return fail(ErrorCode::bad_input, "the schema of the project file cannot be read: " + file.string());
    return std::move(schema["$defs"]);
}

/// Adds the definitions that the schema refers to, and those that they refer to.
void add_referred(const SchemaJson& schema, const SchemaJson& all, SchemaJson& referred) {
    if (schema.is_object() && schema.contains("$ref")) {
        const std::string reference = schema["$ref"];
        const std::string name = reference.substr(reference.rfind('/') + 1);
        if (all.contains(name) && !referred.contains(name)) {
            referred[name] = all[name];
            add_referred(all[name], all, referred);
        }
    }
    if (schema.is_structured())
        for (const SchemaJson& inner : schema) add_referred(inner, all, referred);
}

}  // namespace

const std::vector<ProjectPart>& project_parts() {
    static const std::vector<ProjectPart> parts = [] {
        std::vector<ProjectPart> all;
        for (const Definition& d : definitions()) all.push_back(d.part);
        return all;
    }();
    return parts;
}

Result<std::optional<std::string>> description_of_part(const std::string& name) {
    const Definition* found = find_definition(name);
    if (!found) return std::optional<std::string>();
    const auto definitions_read = read_definitions(found->in_schema);
    if (!definitions_read) return fail(definitions_read.error());
    const SchemaJson& object = definitions_read->at(found->in_schema);
    std::ostringstream out;
    out << found->part.name << ": " << found->part.title << '\n';
    if (object.contains("description")) write_wrapped(out, text_of(object["description"]), "  ");
    out << "\nFields\n";
    write_object(out, object, "  ");
    if (name == "components") write_distributions(out);
    if (name == "axes" || name == "variables") out << "\nTargets\n" << study_targets_text();
    return std::optional<std::string>(out.str());
}

Result<std::optional<std::string>> description_of_part_json(const std::string& name) {
    const Definition* found = find_definition(name);
    if (!found) return std::optional<std::string>();
    const auto definitions_read = read_definitions(found->in_schema);
    if (!definitions_read) return fail(definitions_read.error());
    SchemaJson referred = SchemaJson::object();
    add_referred(definitions_read->at(found->in_schema), *definitions_read, referred);
    SchemaJson schema = definitions_read->at(found->in_schema);
    if (!referred.empty()) schema["$defs"] = std::move(referred);
    OrderedJson json = json_document("covaria-description");
    json["part"] = {{"name", found->part.name}, {"title", found->part.title}, {"schema", std::move(schema)}};
    return std::optional<std::string>(json_text(json));
}

}  // namespace covaria
