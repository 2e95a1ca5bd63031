// The review of a project: who prepared, checked and released it and when, the digest of what was released,
// and a log of what was done (ISO/IEC 17025 7.8.1.1, 7.5.1, 7.5.2).
//
// No result depends on it. Whether the project still is what was released: core/project/release.h.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"

namespace covaria {

/// One step of a review: a person and a day.
struct ReviewStep {
    std::string name = {};
    std::string date = {};  ///< the day of the step, by ISO 8601
    bool empty() const { return name.empty() && date.empty(); }
    bool operator==(const ReviewStep&) const = default;
};

/// A line of the log.
struct ReviewEntry {
    std::string date = {}, who = {}, what = {};
    bool operator==(const ReviewEntry&) const = default;
};

/// A part of the project as it was released, so that a later change of it can be named.
struct ReleasedPart {
    std::string place = {};   ///< place in the project: "/title", "/assets/plate/setup"
    std::string name = {};    ///< name of the entry at the release; empty for a part of the project itself
    std::string digest = {};  ///< first 16 hexadecimal digits of the SHA-256 of the part
    bool operator==(const ReleasedPart&) const = default;
};

struct Review {
    ReviewStep prepared = {}, checked = {}, released = {};
    std::string digest = {};  ///< SHA-256 of what was released; empty: it never was
    std::vector<ReleasedPart> parts = {};
    std::vector<ReviewEntry> log = {};

    bool empty() const { return *this == Review{}; }
    bool operator==(const Review&) const = default;
};

/// A step as files and forms have it.
struct ReviewStepField {
    const char* key;
    const char* title;  ///< the title for people: "Prepared by"
    const char* help;
    ReviewStep Review::*member;
};
/// The steps in their order.
const std::vector<ReviewStepField>& review_steps();

/// Reports an error for dates that are none, and a warning for steps in the wrong order; paths are from the
/// root of the project.
void check_review(const Review& review, Problems& problems);

}  // namespace covaria
