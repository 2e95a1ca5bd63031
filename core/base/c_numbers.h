// Numbers with a decimal point from libraries that write them with the functions of C.
#pragma once

#include <locale.h>

namespace covaria {

/// C functions of this thread write and read numbers as everywhere while it lives: what a program around us
/// (Python, a desktop's theme) has set for the process does not reach a file.
class CNumbers {
public:
    CNumbers()
        : made_(newlocale(LC_NUMERIC_MASK, "C", duplocale(LC_GLOBAL_LOCALE))), before_(uselocale(made_)) {}
    ~CNumbers() {
        uselocale(before_);
        freelocale(made_);
    }
    CNumbers(const CNumbers&) = delete;
    CNumbers& operator=(const CNumbers&) = delete;

private:
    locale_t made_, before_;
};

}  // namespace covaria
