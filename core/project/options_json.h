// Evaluation options in project files: only what is not default is written.
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
/// An object on its own lines; the options are not all default.
void write_options(JsonWriter& out, const EvaluationOptions& options);

/// Seeds are texts, because they may need 64 bits; empty: the text is no seed.
std::optional<std::uint64_t> seed_from(const std::string& text);
inline Message seed_words() {
    return tell<"a whole number from 0 to 18446744073709551615, in quotes">();
}

}  // namespace covaria
