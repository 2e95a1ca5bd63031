#include "app/merged_run.h"

#include <algorithm>

namespace covaria {

namespace {

/// Units of one computation, from the folder or computed here.
class MergingStore : public UnitStore {
public:
    MergingStore(const SharedRun& run, std::size_t work, PartsFolder& folder, MissingUnits missing)
        : run_(run), index_(work), folder_(folder), missing_(missing) {}

    bool only_computes() const override { return false; }
    std::optional<std::string> find(std::uint64_t unit) override {
        if (missing_.source && !folder_.has(work(), unit)) missing_.source->wait_for(index_, unit);
        return folder_.find(work(), unit);
    }
    bool computes_missing(std::uint64_t unit) const override {
        const bool of_no_part = unit >= work().shared;
        return (missing_.rule == MissingUnits::Rule::compute || of_no_part) && !missing_.source;
    }
    bool keep(std::uint64_t unit, std::string bytes) override {
        const bool follows = unit == begun_.range.last && !begun_.partials.empty();
        if (!follows && !write_begun()) return false;
        if (begun_.partials.empty()) begun_ = {work(), {unit, unit}, {}};
        begun_.partials.push_back(std::move(bytes));
        ++begun_.range.last;
        return begun_.range.size() < units_per_part(work().units) || write_begun();
    }
    void lacks(std::uint64_t unit) override {
        if (problem_) return;
        problem_ = Error{ErrorCode::not_found,
                         folder_.path().string() + ": no part has unit " + std::to_string(unit + 1) +
                             " of \"" + work().name() + "\" (missing: " + folder_.missing(work()) +
                             "): compute those parts too, or let --resume compute what is missing"};
    }
    void cannot_read(std::uint64_t unit) override {
        problem_ = Error{ErrorCode::bad_input,
                         folder_.path().string() + ": unit " + std::to_string(unit + 1) + " of \"" +
                             work().name() + "\" cannot be read: " + "its part was changed or is damaged"};
    }
    /// Writes the units that are computed and not yet in the folder. False: that failed.
    bool write_begun() {
        if (begun_.partials.empty()) return true;
        const auto written = folder_.add(run_.part_request(), std::exchange(begun_, {}));
        if (!written) problem_ = written.error();
        return written.has_value();
    }
    const std::optional<Error>& problem() const { return problem_; }

private:
    const UnitWork& work() const { return run_.works[index_]; }

    const SharedRun& run_;
    std::size_t index_;
    PartsFolder& folder_;
    MissingUnits missing_;
    PartSection begun_;
    std::optional<Error> problem_;
};

class MergingStores : public UnitStores {
public:
    MergingStores(const SharedRun& run, PartsFolder& folder, MissingUnits missing) : run_(run) {
        for (std::size_t i = 0; i < run.works.size(); ++i)
            stores_.push_back(std::make_unique<MergingStore>(run, i, folder, missing));
    }
    UnitStore* of(const std::string& analysis, const std::string& study) override {
        for (std::size_t i = 0; i < stores_.size(); ++i)
            if (run_.works[i].analysis == analysis && run_.works[i].study == study) return stores_[i].get();
        return nullptr;
    }
    Result<void> finish() {
        for (const auto& store : stores_) {
            store->write_begun();
            if (store->problem()) return fail(*store->problem());
        }
        return {};
    }

private:
    const SharedRun& run_;
    std::vector<std::unique_ptr<MergingStore>> stores_;
};

}  // namespace

std::uint64_t units_per_part(std::uint64_t units) {
    constexpr std::uint64_t parts = 400;
    return std::max<std::uint64_t>(1, units / parts);
}

Result<Evaluation> merge_units(const SharedRun& run, PartsFolder& folder, MissingUnits missing,
                               const std::stop_token& stop) {
    if (auto same = folder.check(run.works); !same) return fail(same.error());
    MergingStores stores(run, folder, missing);
    auto evaluation = evaluate_analyses(run.opened, run.request, stop, &stores);
    if (auto whole = stores.finish(); !whole && !stop.stop_requested()) return fail(whole.error());
    return evaluation;
}

}  // namespace covaria
