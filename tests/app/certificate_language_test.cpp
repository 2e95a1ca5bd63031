// covaria report --certificate in the language of the project.
#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace covaria::certificate_language_test {
namespace {

TEST(CertificateLanguage, OfTheProjectNotOfTheMachine) {
    const auto file = (fresh_folder("certificate-language") / "certificate.html").string();
    const std::string gauge = shipped_project("gum/h1-end-gauge.covaria").string();
    const auto certificate = [&](const std::string& language) {
        std::vector<std::string> arguments{"report",        gauge, "--analysis", "table",
                                           "--certificate", "-o",  file};
        if (!language.empty())
            arguments.insert(arguments.end(), {"--set", "/certificate/language=" + language});
        const Outcome made = run_program(arguments);
        EXPECT_EQ(made.status, 0) << made.err;
        return read_text(file);
    };
    const std::string english = certificate(""), german = certificate("de");
    EXPECT_EQ(certificate("en"), english);
    EXPECT_NE(english.find("<html lang=\"en\">"), std::string::npos);
    EXPECT_NE(english.find("k = 2.91"), std::string::npos);
    EXPECT_NE(german.find("<html lang=\"de\">"), std::string::npos);
    EXPECT_NE(german.find("Kalibrierschein"), std::string::npos);
    EXPECT_NE(german.find("k = 2,91"), std::string::npos);
    EXPECT_EQ(german.find("Calibration certificate"), std::string::npos);
    EXPECT_NE(german.find("length of the end gauge"), std::string::npos) << "what was typed stays";
    const Outcome unknown =
        run_program({"report", gauge, "--certificate", "--set", "/certificate/language=tlh", "-o", file});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_NE(unknown.err.find("must be one of en, de, es, pt, zh_CN, ko"), std::string::npos) << unknown.err;
}

}  // namespace
}  // namespace covaria::certificate_language_test
