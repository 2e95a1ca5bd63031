// The worked examples of JCGM 100, 101 and 102 as data: inputs, published and reference values.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/quantity/input_quantity.h"

namespace covaria::test {

const nlohmann::json& gum_example(const std::string& id);
/// Inputs as the example gives them; `degrees_of_freedom` of each where stated.
InputSet example_inputs(const nlohmann::json& example);

}  // namespace covaria::test
