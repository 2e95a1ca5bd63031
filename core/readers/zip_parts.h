// A zip file in memory, read part by part within a limit.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "core/base/error.h"

namespace covaria {

class ZipParts {
public:
    /// Opens a zip file. `bytes` must outlive this. `limit` is the number of bytes that all parts that are
    /// read may unpack to together. Error: no zip file, or a damaged one.
    static Result<ZipParts> open(const std::string& bytes, std::size_t limit);

    bool has(const std::string& name) const;
    /// Reads a part. Error: there is no such part, it is encrypted or damaged, or it unpacks beyond the
    /// limit, of which no more is ever unpacked.
    Result<std::string> read(const std::string& name);

private:
    struct Archive;
    explicit ZipParts(std::shared_ptr<Archive> archive, std::size_t limit)
        : archive_(std::move(archive)), limit_(limit), left_(limit) {}
    std::shared_ptr<Archive> archive_;
    std::size_t limit_, left_;
};

}  // namespace covaria
