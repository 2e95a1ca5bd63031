// Output of commands for programs: --json.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/result_files/json_values.h"

namespace CLI {
class App;
}

namespace covaria {

/// Adds --json; `wanted` must outlive the parser.
void add_json_option(CLI::App& command, bool& wanted);
/// {"format": ..., "schemaVersion": 1, "covariaVersion": ...}, to be filled.
OrderedJson json_document(const std::string& format);
/// Indented, with a line feed at its end. Bytes that are no UTF-8 become the replacement character.
std::string json_text(const OrderedJson& json);
/// [{"severity", "file", "line", "path", "message"}]; what is not known is null.
OrderedJson problems_json(const Problems& problems);

}  // namespace covaria
