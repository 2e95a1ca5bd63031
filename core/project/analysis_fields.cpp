#include "core/project/analysis_fields.h"

#include "core/project/asset_certificate_fields.h"
#include "core/project/design_fields.h"
#include "core/project/edit_fields.h"
#include "core/project/options_json.h"
#include "core/project/requirement_fields.h"
#include "core/project/saved_view_fields.h"
#include "core/project/study_fields.h"

namespace covaria {

namespace {

struct OptionsObject {
    void read(ObjectReader& reader, const std::string& key, bool, EvaluationOptions& member) const {
        if (const Json* options = reader.find(key))
            member = options_from_json(*options, reader.path_of(key), reader.problems());
    }
    void write(JsonWriter& out, const EvaluationOptions& member) const { write_options(out, member); }
};

}  // namespace

const JsonFields<AnalysisEntry>& analysis_fields() {
    static const auto fields =
        JsonFields<AnalysisEntry>(tell<"an analysis">())
            .add("links", &AnalysisEntry::links, ListOf{link_fields()})
            .add("inputs", &AnalysisEntry::inputs, ListOf{input_edit_fields()})
            .add("correlations", &AnalysisEntry::correlations, ListOf{correlation_fields()})
            .add("options", &AnalysisEntry::options, OptionsObject{})
            .add("requirements", &AnalysisEntry::requirements, ListOf{requirement_object()})
            .add("studies", &AnalysisEntry::studies, ListOf{study_fields()})
            .add("designs", &AnalysisEntry::designs, ListOf{design_fields()})
            .add("views", &AnalysisEntry::views, SavedViewList{})
            .add("quantityNotes", &AnalysisEntry::quantity_notes, ListOf{quantity_notes_fields()})
            .add("measured", &AnalysisEntry::measured)
            .add("certificates", &AnalysisEntry::certificates, ListOf{asset_certificate_fields()});
    return fields;
}

}  // namespace covaria
