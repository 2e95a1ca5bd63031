// The section of project files that says what goes into the report.
#pragma once

#include "core/project/json_fields.h"
#include "core/project/report_contents.h"

namespace covaria {

const JsonFields<ReportContents>& report_contents_fields();

}  // namespace covaria
