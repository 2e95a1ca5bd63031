// Instructions of the processor at hand beyond those that the program is built for.
#pragma once

// A function that may use AVX-512; its callers ask has_avx512().
#define COVARIA_AVX512 __attribute__((target("avx512f,avx512dq,avx512vl")))

namespace covaria {

/// Whether AVX-512 may be used; integers and single operations of IEEE 754 give the bits that AVX2 gives.
inline bool has_avx512() {
    static const bool has = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                            __builtin_cpu_supports("avx512vl");
    return has;
}

}  // namespace covaria
