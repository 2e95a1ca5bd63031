// Output quantities of a measurement model.
#pragma once

#include <string>

#include "core/base/message.h"
#include "core/base/name.h"
#include "core/base/temperature.h"
#include "core/base/unit.h"

namespace covaria {

enum class OutputRole {
    measurand,
    intermediate,  ///< shown with its own uncertainty, not a result ("point 3 of arc 1")
};

struct OutputQuantity {
    std::string symbol = {};  ///< unique within its group: "x", "alpha"
    Message name = {};        ///< "x of the platform"
    Unit unit = {};           ///< unit for display and results.json; values are SI
    Name group = {};          ///< "pose 7"; one joint coverage region per group of measurands
    OutputRole role = OutputRole::measurand;
    bool periodic = false;  ///< an angle on the circle (period 2 pi): unwrapped to the estimate
    TemperatureKind temperature = TemperatureKind::by_unit;
};

}  // namespace covaria
