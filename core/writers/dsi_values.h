// Results as values of the D-SI (digital system of units), version 2.1, which certificates of version 3.2.1
// are made of; 2.2 reads it, too.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/result/uncertainty_result.h"

namespace covaria {

/// The verdicts on the conformity of measurands with a tolerance.
struct StatedConformity {
    const std::vector<RequirementResult>& verdicts;
    std::string specification = {};  ///< specification that the verdicts refer to
};

/// Adds the measurands of a group as <dcc:quantity>: with a joint region as one list with the covariance
/// matrix, else one by one. Conformity follows as metadata of their quantity. Error: an uncertainty that is
/// not finite, for which the D-SI has no place.
Result<void> add_quantities(pugi::xml_node data, const UncertaintyResult& result, const std::string& group,
                            const std::vector<std::size_t>& outputs, const StatedConformity& conformity);

}  // namespace covaria
