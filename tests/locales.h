// Locales for tests, whatever the machine has: compiled from the sources of the package "locales", without
// rights or a network.
#pragma once

#include <gtest/gtest.h>
#include <langinfo.h>
#include <locale.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace covaria::test {

/// Beside "C": a decimal comma, letters that turn to others in capitals, other letters and fonts.
inline const std::vector<std::string>& foreign_locales() {
    static const std::vector<std::string> names{"de_DE", "tr_TR", "zh_CN"};
    return names;
}

/// The folder for LOCPATH that has them. A test fails, with words, where one cannot be made.
inline std::filesystem::path locale_folder() {
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(COVARIA_BINARY_DIR) / "test-locales";
    fs::create_directories(folder);
    for (const std::string& name : foreign_locales()) {
        const fs::path made = folder / (name + ".UTF-8");
        if (!fs::exists(made / "LC_NUMERIC")) {
            // Tests run at the same time: each makes its own, and one of them takes the name.
            const fs::path own = folder / (name + "." + std::to_string(::getpid()));
            const std::string command =
                "localedef -i " + name + " -f UTF-8 '" + own.string() + "' 2> /dev/null";
            [[maybe_unused]] const int warnings = std::system(command.c_str());
            std::error_code taken;
            fs::rename(own, made, taken);
            if (taken) fs::remove_all(own, taken);
        }
        EXPECT_TRUE(fs::exists(made / "LC_NUMERIC"))
            << "the locale " << name << " cannot be made: install the package \"locales\" (localedef, "
            << "/usr/share/i18n/locales/" << name << ")";
    }
    setenv("LOCPATH", folder.c_str(), 1);
    const locale_t german = newlocale(LC_NUMERIC_MASK, "de_DE.UTF-8", nullptr);
    EXPECT_TRUE(german) << "the locale de_DE was made, and cannot be used";
    if (german) {
        EXPECT_STREQ(nl_langinfo_l(RADIXCHAR, german), ",") << "without its comma this test says nothing";
        freelocale(german);
    }
    return folder;
}

}  // namespace covaria::test
