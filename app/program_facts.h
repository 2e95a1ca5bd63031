// Facts about this program: compiler, libraries, its own bytes.
#pragma once

#include "core/verification/dossier.h"

namespace covaria {

/// Version, compiler, libraries, system, SHA-256 of the running program and of the lists of cases, and the
/// day. Error{io}: the program cannot be read.
Result<ProgramFacts> program_facts();

}  // namespace covaria
