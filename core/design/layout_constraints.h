// Constraints of a design in space, judged by the layout of its model: no family is known here.
#pragma once

#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/model/layout.h"
#include "core/project/design.h"

namespace covaria::detail {

struct LayoutVerdict {
    double violation = 0.0;  ///< 0: none; grows with what is missing
    Message reason = {};     ///< the first that is violated, in words; empty: none
};

/// Instruments are the bodies of that kind and stations; all other points are to be kept at a distance. A
/// sight line begins at an instrument and ends at a point.
LayoutVerdict judge_layout(const Layout& layout, const Design& design);

/// Why a constraint of the design can say nothing about such a layout; empty if all can.
Message why_not_judged(const Layout& layout, const Design& design);

}  // namespace covaria::detail
