// Precompiled for the tests.
#pragma once

#include <gtest/gtest.h>

#include "cmake/precompiled/core.h"
