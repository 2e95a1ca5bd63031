// Results that the laboratory's best capability does not allow, as the program says them.
#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace capability_command_test {
namespace {

std::string capability(const std::string& to, const std::string& below) {
    return R"("assets": [{"id": "cmc", "kind": "best-capability", "name": "Gauge blocks", "setup": {
        "unit": "um", "range_unit": "mm", "below": ")" +
           below + R"(", "ranges": {"columns": ["from", "to", "absolute", "relative"], "rows": [[0, )" + to +
           R"(, 0.08, 0]]}}}])";
}

/// Runs a command on the gauge block of 50 mm, whose U is 66 nm, with a capability of 80 nm.
Outcome run_with(const std::string& assets, std::vector<std::string> command, const std::string& k = {}) {
    const auto file = fresh_folder() / "gauge.covaria";
    std::string text = read_text(shipped_project("certificate-gauge-block.covaria"));
    const std::string none = "\"assets\": []";
    const std::size_t at = text.find(none);
    EXPECT_NE(at, std::string::npos);
    text.replace(at, none.size(), assets);
    const std::string fixed = "\"coverageFactor\": 2";
    if (!k.empty()) text.replace(text.find(fixed), fixed.size(), "\"coverageFactor\": " + k);
    write_text(file, text);
    command.insert(command.begin() + 1, file.string());
    for (std::string& argument : command)
        if (argument == "OUT") argument = (file.parent_path() / "out.md").string();
    Outcome done = run_program(command);
    if (std::filesystem::exists(file.parent_path() / "out.md"))
        done.out += read_text(file.parent_path() / "out.md");
    return done;
}

bool has(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

TEST(Capability, ARaisedUIsInTheCertificateAndNotInTheReport) {
    const Outcome certificate =
        run_with(capability("100", "raised"), {"report", "--certificate", "-o", "OUT"});
    EXPECT_EQ(certificate.status, 0) << certificate.err;
    EXPECT_TRUE(has(certificate.out, "best measurement capability of the laboratory, with k = 2"))
        << certificate.out;
    EXPECT_TRUE(has(certificate.out, "k = 2.00, p = 95")) << certificate.out;
    EXPECT_FALSE(has(certificate.out, "half the width")) << "that is not how this U came about";
    EXPECT_TRUE(has(certificate.err, "below the best capability")) << certificate.err;
    const Outcome report = run_with(capability("100", "raised"), {"report", "-o", "OUT"});
    EXPECT_FALSE(has(report.out, "best measurement capability of the laboratory"));
    const Outcome check = run_with(capability("100", "raised"), {"check"});
    EXPECT_FALSE(has(check.out, "best capability")) << check.out;
}

TEST(Capability, IsHeldAgainstTwoStandardUncertaintiesWhateverKIs) {
    for (const char* k : {"3", "1.5"}) {
        const Outcome done =
            run_with(capability("100", "raised"), {"report", "--certificate", "-o", "OUT"}, k);
        EXPECT_TRUE(has(done.err, "below the best capability")) << k << done.err;
        EXPECT_TRUE(has(done.out, "k = 2.00, p = 95")) << done.out;
    }
}

TEST(Capability, CheckEndsWithStatusThreeOutsideTheScopeAndWhereUMayNotBeStated) {
    const Outcome outside = run_with(capability("25", "raised"), {"check"});
    EXPECT_EQ(outside.status, 3);
    EXPECT_TRUE(has(outside.out, "outside the scope")) << outside.out;
    const Outcome refused = run_with(capability("100", "refused"), {"check"});
    EXPECT_EQ(refused.status, 3);
    EXPECT_TRUE(has(refused.out, "may not be stated")) << refused.out;
}

}  // namespace
}  // namespace capability_command_test
