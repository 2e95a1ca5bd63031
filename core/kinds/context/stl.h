// STL, binary and ASCII: triangles without a unit.
//
// The binary form has no place for one; M. Burns, Automated Fabrication (Prentice Hall, 1993), section 6.5,
// describes both.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>

#include "core/base/error.h"
#include "core/model/triangle_mesh.h"

namespace covaria {

inline constexpr std::size_t most_triangles = 5'000'000;

/// Binary where the length is what the count of triangles in the header asks for (also when the header begins
/// with "solid"), ASCII where it begins with "solid". Normals are not kept: they follow from the corners.
/// Error{bad_input}: neither; no triangles, too many; a coordinate that is not finite or not a number; with
/// the line of an ASCII file, and the number of the triangle.
Result<TriangleMesh> mesh_from_stl(std::string_view bytes);

/// The mesh of a file, read once for each state of it (size and time) while somebody has it. Errors as above
/// and of read_file, naming the file.
Result<std::shared_ptr<const TriangleMesh>> mesh_of_file(const std::filesystem::path& file);

}  // namespace covaria
