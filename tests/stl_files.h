// STL files made for tests.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace covaria::test {

using StlTriangle = std::array<float, 9>;

inline void append_little_endian(std::string& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xFF);
}

/// A binary STL file with a header of its own and, if it is to lie, another count.
inline std::string binary_stl(const std::vector<StlTriangle>& triangles,
                              std::string header = "made by a test", std::int64_t stated = -1) {
    header.resize(80, ' ');
    append_little_endian(header, static_cast<std::uint32_t>(
                                     stated < 0 ? static_cast<std::int64_t>(triangles.size()) : stated));
    for (const StlTriangle& triangle : triangles) {
        header.append(12, '\0');
        for (const float coordinate : triangle)
            append_little_endian(header, std::bit_cast<std::uint32_t>(coordinate));
        header.append(2, '\0');
    }
    return header;
}

inline std::string ascii_facet(const std::string& a, const std::string& b, const std::string& c) {
    return "facet normal 0 0 1\n outer loop\n  vertex " + a + "\n  vertex " + b + "\n  vertex " + c +
           "\n endloop\nendfacet\n";
}

/// A rectangle in the plane z, from its low to its high corner: two triangles.
inline std::vector<StlTriangle> rectangle(float x0, float y0, float x1, float y1, float z) {
    return {{x0, y0, z, x1, y0, z, x1, y1, z}, {x0, y0, z, x1, y1, z, x0, y1, z}};
}

}  // namespace covaria::test
