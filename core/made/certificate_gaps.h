// Gaps of a certificate: texts that it must state and does not, and the names of its measurands, which only
// the made project knows.
#pragma once

#include <string>
#include <vector>

#include "core/made/made_project.h"

namespace covaria {

struct CertificateGap {
    std::string path;    ///< path from the root of the project
    Message what;        ///< "Customer", "Name of the measurand Y of End gauge"
    const char* clause;  ///< clause of ISO/IEC 17025:2017
};

/// Analyses whose results a certificate states, by id.
using CertifiedIds = std::vector<std::string>;
/// Ids of the analyses that the project does not leave out of its documents.
CertifiedIds certified_ids(const Project& project);

/// Whether one of the analyses has a tolerance.
Conformity stated_conformity(const Project& project, const CertifiedIds& ids);

/// All gaps: texts in the order of their form, then for each analysis the results that are called by their
/// symbols alone.
std::vector<CertificateGap> certificate_gaps(const MadeProject& made, const CertifiedIds& ids);
/// Errors, one for each gap.
Problems missing_in(const MadeProject& made, const CertifiedIds& ids);

/// Whether a certificate under an accreditation may state U for it: about 95 % (ILAC-P14 5.3), which 95.45 %
/// of k = 2 is.
bool is_accredited_probability(double probability);
/// A warning where an analysis of an accredited certificate states U for another one: at the options that say
/// so, by the normal distribution where k is fixed.
void check_accredited_probability(const Project& project, Problems& problems);

}  // namespace covaria
