// To change the file format: raise project_schema_version, append a step here, put a sample file of the
// version before it into tests/data/projects.
#include "core/project/migration.h"

#include <array>
#include <cstdint>
#include <iterator>
#include <string>

#include "core/project/project_file.h"

namespace covaria {

namespace {

using Document = nlohmann::ordered_json;

// Before the first release the analyses were called evaluations.
Document from_0_to_1(Document document) {
    Document renamed = Document::object();
    for (auto& [key, value] : document.items()) renamed[key == "evaluations" ? "analyses" : key] = value;
    return renamed;
}

using Step = Document (*)(Document);
constexpr std::array<Step, project_schema_version> steps{from_0_to_1};  // steps[v]: from version v to v + 1

}  // namespace

Result<Document> migrate_project(Document document) {
    const auto version = document.find("schemaVersion");
    if (version == document.end()) return fail(ErrorCode::bad_input, tell<"'schemaVersion' is missing">());
    if (!version->is_number_unsigned())
        return fail(ErrorCode::bad_input, tell<"'schemaVersion' must be a whole number">(), "/schemaVersion");
    const std::uint64_t number = version->get<std::uint64_t>();
    if (number > steps.size())
        return fail(ErrorCode::bad_input,
                    tell<"written by a newer version of Covaria (schema %1, this program reads up to %2); "
                         "nothing was changed">(number, project_schema_version),
                    "/schemaVersion");
    for (std::size_t v = number; v < steps.size(); ++v) document = steps[v](std::move(document));
    document["schemaVersion"] = project_schema_version;
    return document;
}

}  // namespace covaria
