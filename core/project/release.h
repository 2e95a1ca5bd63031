// The release of a project: the digest of what was released, and what has changed since.
#pragma once

#include <string>
#include <vector>

#include "core/project/project.h"

namespace covaria {

/// SHA-256 of everything that numbers depend on or documents say, and of the names and dates of the review.
/// Kept states, views of scenes, the log and the names of CSV files are no part of it, so that a report
/// carries what was released. It shows a change; it is no signature.
std::string release_digest(const Project& project);

enum class ReleaseState {
    unreviewed,  ///< nothing is said of a review
    draft,       ///< somebody prepared or checked it, and it was never released
    released,
    changed  ///< released once, and no longer what was released: a draft again
};

struct ReleaseStatus {
    ReleaseState state = ReleaseState::unreviewed;
    /// The parts that differ from those released: "asset 'Plate'", "the title".
    std::vector<Message> changes = {};
};
ReleaseStatus release_status(const Project& project);

/// The status in a sentence: "released by R. Roe on 2026-11-28, digest 3f2a..."; "draft again: changed since
/// it was released by R. Roe on 2026-11-28: asset 'Plate'"; "draft: it was not released".
Message words_of(const ReleaseStatus& status, const Review& review);
/// The changes in one list: "asset 'Plate', the title".
Message list_of_changes(const ReleaseStatus& status);

/// Releases the project as it is: digest, parts and a line of the log. Error{bad_input}: a name or a date is
/// missing or wrong.
Result<void> release(Project& project);

}  // namespace covaria
