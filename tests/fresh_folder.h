// A folder of the running test alone: tests run at the same time, and none may find another's files.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace covaria::test {

/// An empty folder in the build folder, named after the running test and `name`.
inline std::filesystem::path fresh_folder(const std::string& name = "files") {
    const testing::TestInfo& running = *testing::UnitTest::GetInstance()->current_test_info();
    std::string test = std::string(running.test_suite_name()) + "." + running.name();
    std::replace(test.begin(), test.end(), '/', '-');
    std::filesystem::path folder = std::filesystem::path(COVARIA_BINARY_DIR) / "test-files" / test / name;
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

}  // namespace covaria::test
