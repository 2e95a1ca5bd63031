// The certificate section of project files: only texts that are there are written.
#pragma once

#include "core/project/certificate.h"
#include "core/project/json_writer.h"
#include "core/project/object_reader.h"

namespace covaria {

Certificate certificate_from_json(const Json& value, const std::string& path, Problems& problems);
/// Writes a certificate that is not empty as an object on its own lines.
void write_certificate(JsonWriter& out, const Certificate& certificate);

}  // namespace covaria
