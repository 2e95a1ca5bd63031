// Files of others as they are read for a project, and their budgets held against what they state themselves.
#pragma once

#include <string>
#include <vector>

#include "core/readers/reader.h"

namespace covaria {

/// Each stated value, u and U beside that of the analysis that is proposed, and how far they are apart.
std::vector<Message> held_against_outcomes(const Proposals& proposals);

/// The proposals of the reader; `found` ends with how they were held. Nothing is thrown.
Result<Proposals> read_proposals(const Reader& reader, const std::string& text, const ReadChoice& choice);

}  // namespace covaria
