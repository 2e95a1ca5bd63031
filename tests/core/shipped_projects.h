// The projects that are shipped, for tests over all of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/resource_path.h"

namespace covaria {

/// Files of all projects, in the order of their paths.
inline std::vector<std::filesystem::path> shipped_projects() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(data_directory() / "projects"))
        if (entry.path().extension() == ".covaria") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// Name of a test after its file: letters and digits.
inline std::string test_name_of(const testing::TestParamInfo<std::filesystem::path>& instance) {
    std::string name = instance.param.stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
    return name;
}

}  // namespace covaria
