// Results share their inputs with the model: a test that changes them gives the result its own.
#pragma once

#include "core/result/uncertainty_result.h"

namespace covaria::test {

template <class Change>
void change_inputs(UncertaintyResult& result, Change change) {
    InputSet own = *result.inputs;
    change(own);
    result.inputs = std::move(own);
}

}  // namespace covaria::test
