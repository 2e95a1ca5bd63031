// A picture in memory, and PNG files.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/error.h"

namespace covaria {

/// Rows from top to bottom, four bytes (red, green, blue, opacity) per pixel.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba = {};

    bool empty() const { return rgba.empty(); }
    std::array<std::uint8_t, 4> at(int x, int y) const;
    bool operator==(const Image&) const = default;
};

/// Writes beside the file and renames, so that a reader never meets half a picture. Error{io} names the file.
Result<void> write_png(const Image& image, const std::filesystem::path& file);
/// Errors: not_found, io.
Result<Image> read_png(const std::filesystem::path& file);

}  // namespace covaria
