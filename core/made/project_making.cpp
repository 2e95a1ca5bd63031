#include "core/made/project_making.h"

#include "core/kinds/registries.h"
#include "core/project/kind_lookup.h"
#include "core/project/linked_files.h"
#include "core/setup/setup_schema.h"

namespace covaria {

namespace {

AssetLibrary library_of(const making::Uses& uses) {
    AssetLibrary library;
    for (const auto& use : uses) {
        if (!use) continue;
        for (const auto& [id, entry] : use->assets.entries()) library.add(id, entry);
    }
    return library;
}

std::shared_ptr<const Asset> create(const Project& project, const AssetEntry& entry,
                                    const std::vector<EntryReference>& references, const MadeAsset& made,
                                    Problems& problems) {
    const AssetDescriptor& kind = *made.made.descriptor;
    check_setup(kind.schema, entry.setup, problems);
    if (problems.has_errors()) return nullptr;
    making::refuse_circles(project, references, problems);
    if (problems.has_errors()) return nullptr;
    making::check_uses(project, references, made.uses, problems);
    if (problems.has_errors()) return nullptr;
    auto asset = kind.create(SetupReader(kind.schema, entry.setup), made.assets, problems);
    return problems.has_errors() ? nullptr : std::move(asset);
}

/// Path, size and time of the files that the set-up names; they are read anew where this has changed.
std::string state_of_files(const Project& project, const AssetEntry& entry) {
    std::string state;
    const SetupSchema* schema = schema_of(entry);
    if (!schema) return state;
    for (const NamedFile& file : named_files(project, *schema, entry.setup)) {
        std::error_code gone;
        const auto size = std::filesystem::file_size(file.path, gone);
        const auto time = std::filesystem::last_write_time(file.path, gone);
        state += file.path.string() + '\n';
        if (!gone)
            state += std::to_string(size) + ' ' + std::to_string(time.time_since_epoch().count()) + '\n';
    }
    return state;
}

template <class Entry>
std::map<std::string, std::size_t> numbers_of(const std::vector<Entry>& entries) {
    std::map<std::string, std::size_t> numbers;
    for (std::size_t i = 0; i < entries.size(); ++i) numbers.try_emplace(entries[i].id, i);
    return numbers;
}

}  // namespace

ProjectMaking::ProjectMaking(std::shared_ptr<const Project> project, const MadeProject* before)
    : made_(new MadeProject(std::move(project))), before_(before) {
    const Project& now = made_->project();
    made_->entries_.resize(made_->graph_.size());
    keeps_numbers_.assign(made_->graph_.size(), false);
    analyses_.reserve(now.analyses.size());
    if (!before) return;
    assets_before_ = numbers_of(before->project().assets);
    analyses_before_ = numbers_of(before->project().analyses);
    all_assets_stay_ = now.assets == before->project().assets;
}

MadeProject::Pointer ProjectMaking::make() {
    const std::size_t assets = made_->project().assets.size();
    for (const std::size_t entry : made_->graph_.order())
        entry < assets ? make_asset(entry) : make_analysis(entry - assets);
    for (AnalysisMaking& analysis : analyses_) analysis.finish();
    for (std::size_t i = assets; i-- > 0;) {  // the first of several with one id counts
        const auto& made = static_cast<const MadeAsset&>(*made_->entries_[i]).made;
        if (made.asset) made_->assets_.add(made_->project().assets[i].id, made);
    }
    return made_;
}

making::Uses ProjectMaking::uses_of(std::size_t entry) const {
    making::Uses uses;
    for (const EntryReference& reference : made_->graph_.references(entry))
        uses.push_back(reference.is_edge() ? made_->entries_[reference.entry] : nullptr);
    return uses;
}

bool ProjectMaking::references_keep_numbers(std::size_t entry) const {
    for (const EntryReference& reference : made_->graph_.references(entry))
        if (!reference.is_edge() || !keeps_numbers_[reference.entry]) return false;
    return true;
}

void ProjectMaking::make_asset(std::size_t index) {
    const AssetEntry& entry = made_->project().assets[index];
    auto made = std::make_shared<MadeAsset>();
    made->uses = uses_of(index);
    made->files = state_of_files(made_->project(), entry);
    const auto then = assets_before_.find(entry.id);
    if (then != assets_before_.end()) {
        const AssetEntry& was = before_->project().assets[then->second];
        const auto& kept = before_->entries_[then->second];
        const bool same = was.kind == entry.kind && was.setup == entry.setup;
        keeps_numbers_[index] = same && references_keep_numbers(index);
        const bool files_stay = static_cast<const MadeAsset&>(*kept).files == made->files;
        if (same && files_stay && making::stay(made->uses, kept->uses)) {
            ++made_->counts_.taken;
            made_->entries_[index] = kept;
            if (was.name == entry.name) return;
            *made = static_cast<const MadeAsset&>(*kept);
            made->made.name = entry.name;
            if (made->made.asset) made->assets.add(entry.id, made->made);
            made_->entries_[index] = std::move(made);
            return;
        }
    }
    ++made_->counts_.assets;
    made->assets = library_of(made->uses);
    made->assets.set_folder(made_->project().directory);
    made->made = {entry.name, find_asset_kind(entry.kind), nullptr};
    if (!made->made.descriptor) {
        made->problems.error("/kind", unknown_kind(entry));
    } else {
        Problems found;
        made->made.asset = making::made_or_problem("", found, [&] {
            return create(made_->project(), entry, made_->graph_.references(index), *made, found);
        });
        if (found.has_errors()) made->made.asset = nullptr;
        made->problems.take(found, "/setup");
    }
    if (made->made.asset) made->assets.add(entry.id, made->made);
    made_->entries_[index] = std::move(made);
}

void ProjectMaking::make_analysis(std::size_t index) {
    const std::size_t number = made_->graph_.number_of_analysis(index);
    AnalysisBefore before;
    const auto then = analyses_before_.find(made_->project().analyses[index].id);
    if (then != analyses_before_.end()) {
        before.entry = &before_->project().analyses[then->second];
        before.made = std::static_pointer_cast<const MadeAnalysis>(
            before_->entries_[before_->graph_.number_of_analysis(then->second)]);
        before.uses_keep_numbers = references_keep_numbers(number);
        before.assets_stay = all_assets_stay_;
    }
    making::Uses uses = uses_of(number);
    AssetLibrary assets = library_of(uses);
    analyses_.emplace_back(*made_, index, std::move(before), made_->counts_);
    made_->entries_[number] = analyses_.back().make_own(std::move(uses), std::move(assets));
}

}  // namespace covaria
