// SHA-256 (FIPS 180-4): by which a file is recognised that a project names and does not have.
#pragma once

#include <string>
#include <string_view>

namespace covaria {

/// 64 hexadecimal digits, small letters.
std::string sha256_of(std::string_view bytes);
/// 64 hexadecimal digits, of either case.
bool is_sha256(std::string_view text);

}  // namespace covaria
