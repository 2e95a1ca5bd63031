// Makes an analysis, step by step, and keeps the steps that stay; internal to core/made.
#pragma once

#include <memory>
#include <string>

#include "core/made/made_project.h"
#include "core/made/making.h"
#include "core/project/links.h"

namespace covaria {

/// The analysis in the state before.
struct AnalysisBefore {
    const AnalysisEntry* entry = nullptr;  ///< null: it was not there
    std::shared_ptr<const MadeAnalysis> made = {};
    bool uses_keep_numbers = false;  ///< what it refers to has other names at most
    bool assets_stay = false;        ///< all assets of the project
};

/// Making of an analysis in two steps: first all analyses by themselves, then their chains.
class AnalysisMaking {
public:
    /// `counts` is added to.
    AnalysisMaking(const MadeProject& project, std::size_t index, AnalysisBefore before,
                   MakingCounts& counts);
    /// `uses` and their assets; what is returned is not finished yet.
    std::shared_ptr<const MadeAnalysis> make_own(making::Uses uses, AssetLibrary assets);
    /// Makes the chain, when all analyses of the project are made by themselves.
    void finish();

private:
    bool model_stays() const;
    bool edits_stay() const;
    bool chain_stays() const;
    bool choices_stay() const;
    AssetLibrary with_offers() const;
    void make_model();
    void make_inputs();
    void find_upstream();
    ModelOfAnalysis composed();
    void compose();
    void prepare();
    std::shared_ptr<const PreparedAnalysis> prepared() const;
    void check_studies();

    const MadeProject& project_;
    const std::size_t number_;  ///< number in the graph
    const AnalysisEntry& entry_;
    const std::vector<EntryReference>& references_;
    const ModelDescriptor* descriptor_;  ///< null: unknown model
    AnalysisBefore before_;
    MakingCounts& counts_;
    std::shared_ptr<MadeAnalysis> made_;
};

}  // namespace covaria
