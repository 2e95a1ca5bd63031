#include "core/project/kind_lookup.h"

#include "core/kinds/registries.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

std::string unknown(const std::string& what, const std::string& name, const std::vector<std::string>& known) {
    return "there is no " + what + " '" + name + "'" + did_you_mean(name, known) + "; known are " +
           listed(known);
}

}  // namespace

const SetupSchema* schema_of(const AssetEntry& asset) {
    const AssetDescriptor* kind = find_asset_kind(asset.kind);
    return kind ? &kind->schema : nullptr;
}

const SetupSchema* schema_of(const AnalysisEntry& analysis) {
    const ModelDescriptor* model = find_model(analysis.model);
    return model ? &model->schema : nullptr;
}

std::string unknown_kind(const AssetEntry& asset) {
    std::vector<std::string> known;
    for (const AssetDescriptor& kind : asset_registry()) known.push_back(kind.kind);
    return unknown("kind of asset", asset.kind, known);
}

std::string unknown_model(const AnalysisEntry& analysis) {
    std::vector<std::string> known;
    for (const ModelDescriptor& model : model_registry()) known.push_back(model.id);
    return unknown("measurement model", analysis.model, known);
}

}  // namespace covaria
