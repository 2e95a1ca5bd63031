// The applicability of the figures that an analysis uses: the certificates of its assets and of what its
// set-up states, held against the date of the measurement and against the values that they are used for
// (ISO/IEC 17025 6.4.13 e, 6.5).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/made/made_project.h"
#include "core/project/asset_certificate.h"

namespace covaria {

/// The verdicts, of which the worse come later: of several findings the last one counts.
enum class Applicability { applicable, unknown, outside, expired };
/// Whether figures are known not to be applicable, which is said wherever they are used. An unknown verdict
/// is said where the certificates themselves are looked at.
inline bool is_refused(Applicability verdict) {
    return verdict == Applicability::outside || verdict == Applicability::expired;
}
/// The verdict in words: "applicable", "not known", "outside its range", "expired".
Message words_of(Applicability verdict);

struct ApplicabilityVerdict {
    Applicability verdict = Applicability::applicable;
    std::vector<Message> reasons = {};  ///< sentences without their stop; none where it is applicable
    void find(Applicability found, Message reason);
};

/// The verdict by dates alone. `measured` is a date, or an interval of two, all of whose days count. A
/// certificate needs a last day of validity; a report and a data sheet hold until they are replaced.
ApplicabilityVerdict applicable_at(const AssetCertificate& certificate, std::string_view measured);

/// A certificate where it is used.
struct CertificateUse {
    std::string asset = {};  ///< id of the asset; empty: the analysis states the figures itself
    /// Id of the analysis that uses it: the one asked about, or one it is made of.
    std::string analysis = {};
    std::string holder = {};  ///< name of the asset or analysis
    std::string path = {};    ///< place of the certificate, from the root of the project
    AssetCertificate certificate = {};
    ApplicabilityVerdict verdict = {};
};

struct FiguresUsed {
    std::vector<CertificateUse> certificates;
    std::vector<std::string> assumed;  ///< names of the assets whose figures come from no certificate
    std::size_t assets = 0;            ///< number of assets with figures that the analysis uses
    /// Of a project that names certificates: number of quantities that the analyses state with an uncertainty
    /// of Type B, and the symbols of those that no certificate covers.
    std::size_t stated = 0;
    std::vector<std::string> assumed_quantities = {};
};
/// The figures used by the analysis and by those that it takes something from, each at its own date of
/// measurement.
FiguresUsed figures_used(const MadeProject& made, const std::string& analysis);

/// The date of the measurement of an analysis: its own, else that of the project's certificate.
const std::string& measured_of(const Project& project, const AnalysisEntry& analysis);

/// The verdict with its reasons: "certificate 2026-114 of PTB: it was valid until 2026-04-01, ...".
Message sentence_of(const CertificateUse& use);

/// Warns of each certificate that is expired or outside its range in one of the analyses, and reports errors
/// of the certificates and dates themselves.
void check_figures(const MadeProject& made, Problems& problems);

}  // namespace covaria
