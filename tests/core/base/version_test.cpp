// The version is stated once, and is the newest release in the list of changes.
#include "core/base/version.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace covaria::version_test {

TEST(Version, IsThatOfTheNewestRelease) {
    std::ifstream changes(COVARIA_SOURCE_DIR "/CHANGELOG.md");
    std::string line;
    while (std::getline(changes, line) && (!line.starts_with("## ") || line == "## Unreleased")) {
    }
    EXPECT_TRUE(line.starts_with(std::string("## ") + version() + " (")) << line << " and " << version();
}

}  // namespace covaria::version_test
