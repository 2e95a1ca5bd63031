// The section of project files for evaluation options: only options that are not default are written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/message.h"
#include "core/project/json_writer.h"
#include "core/project/object_reader.h"
#include "core/propagation/options.h"

namespace covaria {

EvaluationOptions options_from_json(const Json& value, const std::string& path, Problems& problems);
/// Writes options that are not all default as an object on its own lines.
void write_options(JsonWriter& out, const EvaluationOptions& options);

/// The seed that a text states; empty where it is none. Seeds are texts, because they may need 64 bits.
std::optional<std::uint64_t> seed_from(const std::string& text);
inline Message seed_words() {
    return tell<"a whole number from 0 to 18446744073709551615, in quotes">();
}

}  // namespace covaria
