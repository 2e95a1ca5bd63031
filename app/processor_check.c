/* Refuses to start on a processor without AVX2 and FMA, in words, before any other code of the program runs.
 * Compiled for plain x86-64; constructor priority 101 is before all C++ static initialisation. */
#include <stdlib.h>
#include <unistd.h>

__attribute__((constructor(101))) static void check_processor(void) {
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2")) return;
    static const char message[] =
        "covaria: this build needs a processor with AVX2, FMA and BMI2 (x86-64-v3: Intel since 2013, AMD since 2015).\n"
        "covaria: on an older one, build it yourself with -march=x86-64-v2 in cmake/covaria.cmake.\n";
    if (write(STDERR_FILENO, message, sizeof message - 1) < 0) _exit(3);
    _exit(3);
}
