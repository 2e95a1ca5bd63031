#include "core/project/kind_lookup.h"

#include "core/kinds/registries.h"
#include "core/setup/message_text.h"

namespace covaria {

const SetupSchema* schema_of(const AssetEntry& asset) {
    const AssetDescriptor* kind = find_asset_kind(asset.kind);
    return kind ? &kind->schema : nullptr;
}

const SetupSchema* schema_of(const AnalysisEntry& analysis) {
    const ModelDescriptor* model = find_model(analysis.model);
    return model ? &model->schema : nullptr;
}

Message unknown_kind(const AssetEntry& asset) {
    std::vector<std::string> known;
    for (const AssetDescriptor& kind : asset_registry()) known.push_back(kind.kind);
    return tell<"there is no kind of asset '%1'%2; known are %3">(asset.kind, did_you_mean(asset.kind, known),
                                                                  listed(known));
}

Message unknown_model(const AnalysisEntry& analysis) {
    std::vector<std::string> known;
    for (const ModelDescriptor& model : model_registry()) known.push_back(model.id);
    return tell<"there is no measurement model '%1'%2; known are %3">(
        analysis.model, did_you_mean(analysis.model, known), listed(known));
}

}  // namespace covaria
