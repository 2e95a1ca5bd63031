// Amended certificates: what the replaced one stated, and the project of the one in its place (ISO/IEC 17025
// 7.8.8).
#pragma once

#include <map>
#include <string>

#include "core/report/report.h"

namespace covaria {

/// The statements of a certificate: its texts and the results of all analyses of the source. `present`: the
/// ids of the analyses by those of the project that takes its place; an id that is not there stays.
Amendment statements_of(const ReportSource& source, const std::map<std::string, std::string>& present = {});

/// The words of a request to amend.
struct AmendmentRequest {
    std::string number;   ///< number of the amended certificate
    std::string reasons;  ///< reasons as they stand in it
    std::string issued;   ///< its date of issue, ISO 8601
};
/// The project with an amended certificate in the place of the one of `replaced`, which stated `statements`.
/// Error{bad_input}: the replaced certificate has no number, or the amended one has the same; a date that is
/// none.
Result<Project> amended(Project project, const Project& replaced, Amendment statements,
                        const AmendmentRequest& request);

}  // namespace covaria
