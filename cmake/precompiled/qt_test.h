// Precompiled for the tests of ui.
#pragma once

#include <gtest/gtest.h>

#include "cmake/precompiled/qt.h"
