// The sources of the figures of an asset, or of quantities of an analysis: a calibration certificate, a
// report, a data sheet, with the dates on which and the values for which the figures hold (ISO/IEC 17025
// 6.4.13, 6.5).
//
// No result depends on it. The texts of a certificate of ours are in `Certificate`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/unit.h"

namespace covaria {

enum class FiguresFrom { certificate, report, data_sheet };

/// A range of values, ends included, that the figures hold for.
struct CertifiedRange {
    std::string of = {};  ///< symbol of a quantity, or key of a field or column: "T", "temperature"
    std::optional<Quantity> lowest = {}, highest = {};
    bool operator==(const CertifiedRange&) const = default;
};

struct AssetCertificate {
    FiguresFrom kind = FiguresFrom::certificate;
    std::string number = {}, edition = {}, issuer = {};
    std::string calibrated = {};   ///< the date of the calibration, or an interval of two
    std::string issued = {};       ///< the date of issue
    std::string valid_until = {};  ///< the last day that the figures are valid on, by whosever rule
    std::string conditions = {};   ///< conditions in words: mode, filter, whatever the figures hold for
    std::string file = {};         ///< name of the certificate's file, without folders
    std::string digest = {};       ///< SHA-256 of the file
    std::vector<CertifiedRange> ranges = {};
    /// Symbols of the quantities of an analysis whose figures the certificate states; none: all that are
    /// stated in it.
    std::vector<std::string> quantities = {};
    bool operator==(const AssetCertificate&) const = default;
};

/// The name of a certificate in messages: "certificate 2026-114", "report 7 of Laboratory X".
Message name_of(const AssetCertificate& certificate);

/// Whether a text is the number of the certificate, in any case of letters, or its digest.
bool is_called(const AssetCertificate& certificate, const std::string& number_or_digest);

/// Reports an error for dates, a digest and ranges that are none, and a warning for dates in the wrong order
/// and for a certificate that nothing names. `path` is that of the list.
void check_certificates(const std::vector<AssetCertificate>& certificates, const std::string& path,
                        Problems& problems);
/// Reports an error for a text that is neither a date nor an interval of two; an empty text passes.
void check_measured(const std::string& measured, const std::string& path, Problems& problems);

}  // namespace covaria
