#include "core/parts/parts_folder.h"

#include <algorithm>

#include "core/base/file_names.h"

namespace covaria {

namespace fs = std::filesystem;

namespace {

/// Most parts loaded: as many as there may be threads on either side of a border between parts.
constexpr std::size_t most_loaded = 4;

bool same_work(const UnitWork& a, const UnitWork& b) {
    return a.analysis == b.analysis && a.study == b.study;
}

}  // namespace

Result<std::unique_ptr<PartsFolder>> PartsFolder::open(fs::path path) {
    std::unique_ptr<PartsFolder> folder(new PartsFolder(std::move(path)));
    std::vector<fs::path> files;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder->path_, none))
        if (entry.path().extension() == part_extension) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        auto part = read_part(file, false);
        if (!part) return fail(part.error());
        if (folder->entries_.empty()) folder->request_ = part->request;
        for (std::size_t i = 0; i < part->sections.size(); ++i)
            folder->entries_.push_back({file, i, part->sections[i].work, part->sections[i].range});
    }
    return folder;
}

Result<void> PartsFolder::check(const std::vector<UnitWork>& works) const {
    for (const Entry& entry : entries_) {
        const auto known = std::find_if(works.begin(), works.end(),
                                        [&](const UnitWork& work) { return same_work(work, entry.work); });
        if (known == works.end())
            return fail(
                ErrorCode::bad_input,
                tell<"%1: the part is of \"%2\", which is not evaluated here: it is of another project">(
                    entry.file.string(), entry.work.name()));
        if (known->fingerprint != entry.work.fingerprint || known->units != entry.work.units)
            return fail(ErrorCode::bad_input,
                        tell<"%1: the part is of \"%2\" in another project or another state of it "
                             "(fingerprint %3, here %4): make it anew">(
                            entry.file.string(), entry.work.name(), entry.work.fingerprint.substr(0, 12),
                            known->fingerprint.substr(0, 12)));
    }
    return {};
}

const PartsFolder::Entry* PartsFolder::entry_of(const UnitWork& work, std::uint64_t unit) const {
    for (const Entry& entry : entries_)
        if (unit >= entry.range.first && unit < entry.range.last && same_work(entry.work, work))
            return &entry;
    return nullptr;
}

bool PartsFolder::has(const UnitWork& work, std::uint64_t unit) const {
    const std::lock_guard lock(mutex_);
    return entry_of(work, unit) != nullptr;
}

std::optional<std::string> PartsFolder::find(const UnitWork& work, std::uint64_t unit) {
    const std::lock_guard lock(mutex_);
    const Entry* entry = entry_of(work, unit);
    if (!entry) return {};
    const auto part = load(entry->file);
    // An empty partial result cannot be read as one: whoever asked says which unit it is.
    if (!part) return std::string();
    return part->sections[entry->section].partials[unit - entry->range.first];
}

std::shared_ptr<const Part> PartsFolder::load(const fs::path& file) {
    const auto known =
        std::find_if(loaded_.begin(), loaded_.end(), [&](const Loaded& one) { return one.first == file; });
    if (known != loaded_.end()) {
        loaded_.splice(loaded_.begin(), loaded_, known);
        return loaded_.front().second;
    }
    auto part = read_part(file);
    if (!part) return nullptr;
    loaded_.emplace_front(file, std::make_shared<const Part>(*std::move(part)));
    if (loaded_.size() > most_loaded) loaded_.pop_back();
    return loaded_.front().second;
}

Result<void> PartsFolder::add(const PartRequest& request, PartSection section) {
    const UnitWork work = section.work;
    const UnitRange range = section.range;
    const fs::path file =
        path_ / (file_name_part(work.name()) + "-" + work.fingerprint.substr(0, 8) + "-units-" +
                 std::to_string(range.first + 1) + "-" + std::to_string(range.last) + part_extension);
    if (auto written = write_part(file, {request, {std::move(section)}}); !written) return written;
    const std::lock_guard lock(mutex_);
    entries_.push_back({file, 0, work, range});
    return {};
}

std::string PartsFolder::missing(const UnitWork& work) const {
    std::string text;
    for (std::uint64_t unit = 0; unit < work.units; ++unit) {
        if (has(work, unit)) continue;
        const std::uint64_t first = unit;
        while (unit + 1 < work.units && !has(work, unit + 1)) ++unit;
        text += (text.empty() ? "" : ", ") + std::to_string(first + 1);
        if (unit > first) text += "-" + std::to_string(unit + 1);
    }
    return text;
}

}  // namespace covaria
