#include "core/parts/program.h"

#include <gnu/libc-version.h>

#include "core/base/version.h"

namespace covaria {

namespace {

std::string instructions_of_build() {
    std::string names;
    const auto add = [&names](const char* name) { names += (names.empty() ? "" : ", ") + std::string(name); };
#ifdef __AVX512F__
    add("AVX-512");
#endif
#ifdef __AVX2__
    add("AVX2");
#endif
#ifdef __FMA__
    add("FMA");
#endif
#ifdef __ARM_NEON
    add("NEON");
#endif
    if (names.empty()) add("SSE2");
    return names;
}

}  // namespace

const ProgramIdentity& this_program() {
    // The mathematical functions come from the C library and may differ in the last bit between its versions.
    static const ProgramIdentity identity{std::string("covaria ") + version() + " (compiler " + __VERSION__ +
                                              ", C library " + gnu_get_libc_version() + ")",
                                          instructions_of_build()};
    return identity;
}

}  // namespace covaria
