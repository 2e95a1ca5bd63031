// A folder of parts: which units it has, and their partial results.
#pragma once

#include <list>
#include <memory>
#include <mutex>

#include "core/parts/part_file.h"

namespace covaria {

class PartsFolder {
public:
    /// Looks through the files; those that are damaged or of another program are refused. An empty or
    /// missing folder has no parts.
    static Result<std::unique_ptr<PartsFolder>> open(std::filesystem::path folder);

    const std::filesystem::path& path() const { return path_; }
    bool empty() const { return entries_.empty(); }
    /// Request of the first part by name; there is one.
    const PartRequest& request() const { return request_; }
    /// Error: a part is of another state of this computation, or of another project.
    Result<void> check(const std::vector<UnitWork>& works) const;

    bool has(const UnitWork& work, std::uint64_t unit) const;
    /// The partial result of a unit, where a part has it. Safe to use from many threads.
    std::optional<std::string> find(const UnitWork& work, std::uint64_t unit);
    /// A new file of one section.
    Result<void> add(const PartRequest& request, PartSection section);
    /// "3-7, 12" of the units that no part has, counted from 1.
    std::string missing(const UnitWork& work) const;

private:
    struct Entry {
        std::filesystem::path file;
        std::size_t section;
        UnitWork work;
        UnitRange range;
    };
    using Loaded = std::pair<std::filesystem::path, std::shared_ptr<const Part>>;

    explicit PartsFolder(std::filesystem::path path) : path_(std::move(path)) {}
    const Entry* entry_of(const UnitWork& work, std::uint64_t unit) const;
    std::shared_ptr<const Part> load(const std::filesystem::path& file);

    std::filesystem::path path_;
    PartRequest request_;
    mutable std::mutex mutex_;
    std::list<Entry> entries_;
    std::list<Loaded> loaded_;  ///< the last few, newest first
};

}  // namespace covaria
