#include "core/base/sha256.h"

#include <openssl/sha.h>

#include <array>

namespace covaria {

std::string sha256_of(std::string_view bytes) {
    std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
    SHA256(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), digest.data());
    std::string digits;
    for (const unsigned char byte : digest)
        for (const int nibble : {byte >> 4, byte & 0xf}) digits += "0123456789abcdef"[nibble];
    return digits;
}

bool is_sha256(std::string_view text) {
    return text.size() == 64 && text.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
}

}  // namespace covaria
