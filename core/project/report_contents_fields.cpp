#include "core/project/report_contents_fields.h"

namespace covaria {

const JsonFields<ReportContents>& report_contents_fields() {
    static const auto fields = JsonFields<ReportContents>(tell<"the contents of the report">())
                                   .add("withoutAnalyses", &ReportContents::without_analyses)
                                   .add("withoutChapters", &ReportContents::without_chapters)
                                   .add("annex", &ReportContents::annex);
    return fields;
}

}  // namespace covaria
