// The section of project files that says what goes into the report.
#pragma once

#include "core/project/json_writer.h"
#include "core/project/object_reader.h"
#include "core/project/report_contents.h"

namespace covaria {

ReportContents report_contents_from_json(const Json& value, const std::string& path, Problems& problems);
/// An object on its own lines; the contents are not those of every report.
void write_report_contents(JsonWriter& out, const ReportContents& contents);

}  // namespace covaria
