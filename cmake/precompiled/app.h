// Precompiled for the program: the parser of its command line takes longest to compile.
#pragma once

#include <CLI/CLI.hpp>

#include "cmake/precompiled/core.h"
