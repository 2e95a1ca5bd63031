// The place where exceptions end: what is thrown below becomes an Error.
#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <type_traits>

#include "core/base/error.h"

namespace covaria {

/// A value that no quantity can have was computed from the user's data: a negative standard deviation, a
/// width that overflows. Thrown where a Result would burden every caller; `guarded` makes it an Error.
class ImpossibleValue : public std::domain_error {
public:
    using std::domain_error::domain_error;
};

/// The result of `work()`. Errors: bad_input from ImpossibleValue; numeric from memory that is not there, and
/// from any other exception, which is a defect of the program and says so.
template <class Work>
auto guarded(Work&& work) -> Result<std::invoke_result_t<Work>> {
    try {
        return work();
    } catch (const ImpossibleValue& e) {
        return fail(ErrorCode::bad_input, tell<"the values given lead to a %1">(e.what()));
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::numeric, tell<"the memory of this machine does not suffice">());
    } catch (const std::length_error&) {
        return fail(ErrorCode::numeric, tell<"the memory of this machine does not suffice">());
    } catch (const std::exception& e) {
        return fail(
            ErrorCode::numeric,
            tell<"a defect of the program was met (%1): please report it with the project">(e.what()));
    }
}

}  // namespace covaria
