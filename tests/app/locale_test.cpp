// Files and lines of the program are the same wherever its user lives, byte by byte.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "core/writers/writers.h"
#include "tests/app/program.h"
#include "tests/locales.h"

namespace locale_test {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

const std::string gauge = shipped_project("gum/h1-end-gauge.covaria").string();
const std::string network = shipped_project("lsm-network.covaria").string();
/// The chain's equations have letters that come from other fonts.
const std::string chain = shipped_project("chain.covaria").string();
const std::string robot = shipped_project("er10l-c10.covaria").string();

Arguments with_certificate(Arguments arguments) {
    for (const char* value :
         {"number=K-7", "laboratory/name=Laboratory A", "laboratory/address=Road 1", "laboratory/country=DE",
          "customer/name=Customer B", "customer/address=Lane 2", "item/description=Gauge block",
          "item/serialNumber=17", "dates/calibrated=2026-04-17", "dates/issued=2026-04-20", "method=M 3",
          "environment=20 degC", "traceability=To PTB", "authorised/name=E. Muster",
          "specification=ISO 3650:1998"}) {
        arguments.emplace_back("--set");
        arguments.push_back(std::string("/certificate/") + value);
    }
    return arguments;
}

/// Every command of which something leaves the program; `folder` is its own.
std::vector<Arguments> commands(const fs::path& folder) {
    const auto in = [&](const char* name) { return (folder / name).string(); };
    std::vector<Arguments> all{
        with_certificate({"run", gauge, "--analysis", "statements", "--trials", "2000", "--report",
                          "--certificate", "--pictures", "--out", in("gauge")}),
        {"report", chain, "--first-order", "-o", in("chain.pdf")},
        {"render", network, "--analysis", "paper", "--first-order", "-o", in("scene.png")},
        {"render", network, "--analysis", "paper", "--first-order", "-o", in("scene.gltf")},
        {"render", network, "--analysis", "paper", "--first-order", "-o", in("scene.vtp")},
        {"check", gauge, "--analysis", "statements", "--trials", "20000", "--junit", in("junit.xml")},
        {"compare", gauge, "--first-order", "--set",
         "/analyses/table/setup/quantities/rows/l_S/value=50000625", "--analysis", "table", "--out",
         in("compare")},
        {"describe", "pose-from-points"},
        {"library"},
        {"manual", "html", "-o", in("manual.html")},
        {"manual", "man-page"},
        {"validate", gauge}};
    const std::map<std::string, Arguments> written{
        {"dcc", with_certificate({gauge, "--analysis", "table", "--first-order"})},
        {"points", {network, "--analysis", "paper", "--first-order"}},
        {"ur-calibration", {robot, "--analysis", "trajectories", "--first-order"}},
        {"urdf", {robot, "--analysis", "trajectories", "--first-order"}},
        {"xlsx", {gauge, "--analysis", "table", "--trials", "20000"}}};
    for (const covaria::Writer& writer : covaria::writer_registry()) {
        const auto of = written.find(writer.name);
        EXPECT_NE(of, written.end()) << "no project of this test is written by " << writer.name;
        if (of == written.end()) continue;
        Arguments command{"export", "--as", writer.name, "-o", in(("export" + writer.ending).c_str())};
        command.insert(command.end(), of->second.begin(), of->second.end());
        all.push_back(std::move(command));
    }
    return all;
}

using Files = std::map<std::string, std::string>;

Files files_in(const fs::path& folder) {
    Files files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            files[entry.path().lexically_relative(folder).string()] = read_text(entry.path());
    return files;
}

/// Settings of a machine whose fonts for Chinese come first: fontconfig takes them for letters that ours lack
fs::path fonts_of_a_chinese_desktop() {
    const fs::path file = fresh_folder("fonts") / "fonts.conf";
    write_text(file, R"(<?xml version="1.0"?>
<!DOCTYPE fontconfig SYSTEM "fonts.dtd">
<fontconfig>
  <include>/etc/fonts/fonts.conf</include>
  <match target="pattern">
    <test name="lang" compare="contains"><string>zh</string></test>
    <edit name="family" mode="append" binding="strong"><string>DejaVu Serif</string></edit>
  </match>
</fontconfig>
)");
    return file;
}

/// All that the commands write and print, always from the same folder.
Files written_in(const std::string& locale, const fs::path& locales, const fs::path& fonts) {
    const fs::path folder = fresh_folder("out");
    const Arguments environment{"LOCPATH=" + locales.string(), "FONTCONFIG_FILE=" + fonts.string(),
                                "LC_ALL=" + (locale == "C" ? locale : locale + ".UTF-8"),
                                "LANG=" + (locale == "C" ? locale : locale + ".UTF-8"), "LANGUAGE="};
    std::map<std::string, std::string> printed;
    for (const Arguments& command : commands(folder)) {
        const Outcome outcome = run_program_with(environment, command);
        EXPECT_TRUE(outcome.status == 0 || outcome.status == 3)
            << locale << ": " << command[0] << ": " << outcome.err;
        printed[std::to_string(printed.size()) + " " + command[0] + " prints"] = outcome.out;
        printed[std::to_string(printed.size()) + " " + command[0] + " says"] = outcome.err;
    }
    Files files = files_in(folder);
    files.insert(printed.begin(), printed.end());
    const fs::path kept = fresh_folder(locale);
    fs::remove_all(kept);
    fs::rename(folder, kept);
    return files;
}

TEST(Locale, EveryFileAndEveryLineIsTheSame) {
    const fs::path locales = covaria::test::locale_folder();
    ASSERT_FALSE(HasFailure());
    const fs::path fonts = fonts_of_a_chinese_desktop();
    const Files plain = written_in("C", locales, fonts);
    std::set<std::string> endings;
    for (const auto& [name, bytes] : plain) endings.insert(fs::path(name).extension().string());
    for (const char* ending : {".pdf", ".html", ".md", ".json", ".csv", ".svg", ".png", ".gltf", ".vtp",
                               ".xml", ".xlsx", ".urdf", ".txt"})
        EXPECT_TRUE(endings.contains(ending)) << "nothing is written as " << ending;
    for (const std::string& locale : covaria::test::foreign_locales()) {
        const Files foreign = written_in(locale, locales, fonts);
        EXPECT_EQ(foreign.size(), plain.size()) << locale;
        for (const auto& [name, bytes] : plain)
            EXPECT_TRUE(foreign.contains(name) && foreign.at(name) == bytes)
                << locale << ": " << name << " is another; both are in the folders of this test";
    }
}

}  // namespace
}  // namespace locale_test
