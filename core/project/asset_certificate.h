// Where the figures of an asset, or of quantities of an analysis, come from: a calibration certificate, a
// report, a data sheet, with what says when and for what it holds (ISO/IEC 17025 6.4.13, 6.5).
//
// No result depends on it. What a certificate of ours says is `Certificate`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/unit.h"

namespace covaria {

enum class FiguresFrom { certificate, report, data_sheet };

/// The figures hold for values of something from the one to the other, ends included.
struct CertifiedRange {
    std::string of = {};  ///< symbol of a quantity, or key of a field or column: "T", "temperature"
    std::optional<Quantity> lowest = {}, highest = {};
    bool operator==(const CertifiedRange&) const = default;
};

struct AssetCertificate {
    FiguresFrom kind = FiguresFrom::certificate;
    std::string number = {}, edition = {}, issuer = {};
    std::string calibrated = {};   ///< a date, or an interval of two
    std::string issued = {};       ///< a date
    std::string valid_until = {};  ///< a date: the last day, by whose rule it may be
    std::string conditions = {};   ///< in words: mode, filter, whatever the figures hold for
    std::string file = {};         ///< its name, without folders
    std::string digest = {};       ///< SHA-256 of the file
    std::vector<CertifiedRange> ranges = {};
    /// Of an analysis: symbols of the quantities whose figures it states; none: all that are stated in it.
    std::vector<std::string> quantities = {};
    bool operator==(const AssetCertificate&) const = default;
};

/// "certificate 2026-114", "report 7 of Laboratory X"; what it is called in messages.
Message name_of(const AssetCertificate& certificate);

/// The number in any case of letters, or the digest.
bool is_called(const AssetCertificate& certificate, const std::string& number_or_digest);

/// An error for dates, a digest and ranges that are none, a warning for dates in the wrong order and for a
/// certificate that nothing names. `path`: of the list.
void check_certificates(const std::vector<AssetCertificate>& certificates, const std::string& path,
                        Problems& problems);
/// An error for a text that is neither a date nor an interval of two; nothing for an empty one.
void check_measured(const std::string& measured, const std::string& path, Problems& problems);

}  // namespace covaria
