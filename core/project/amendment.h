// The statements of the certificate that an amended one replaces (ISO/IEC 17025 7.8.8). What has changed
// since is found by comparing them with what the amended certificate states, whenever that is written.
//
// The number, the date and the reasons are texts of the certificate itself (core/project/certificate.h).
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/unit.h"

namespace covaria {

/// A text of the replaced certificate.
struct ReplacedText {
    std::string field = {};  ///< key of the field behind "/certificate/": "customer/name"
    std::string text = {};
    bool operator==(const ReplacedText&) const = default;
};

/// A decision on conformity that the replaced certificate stated.
enum class ReplacedDecision { none, pass, fail };

/// A result of the replaced certificate.
struct ReplacedResult {
    std::string analysis = {};  ///< id of the analysis that gives it now
    std::string group = {}, symbol = {};
    double estimate = 0.0, expanded_uncertainty = 0.0;  ///< both in `unit`
    Unit unit = {};
    ReplacedDecision decision = ReplacedDecision::none;
    bool operator==(const ReplacedResult&) const = default;
};

struct Amendment {
    std::vector<ReplacedText> texts = {};  ///< texts that were not empty
    std::vector<ReplacedResult> results = {};

    bool empty() const { return *this == Amendment{}; }
    bool operator==(const Amendment&) const = default;
};

}  // namespace covaria
