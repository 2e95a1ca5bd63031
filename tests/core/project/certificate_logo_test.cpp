// The logo of a certificate: what can be one, and what is said of the rest.
#include "core/project/certificate_logo.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "core/base/file_io.h"
#include "core/made/made_project.h"
#include "tests/fresh_folder.h"

namespace covaria::test::certificate_logo_test {
namespace {

struct CertificateLogo : testing::Test {
    Project project;
    CertificateLogo() { project.directory = fresh_folder(); }

    void file(const std::string& name, const std::string& bytes) {
        ASSERT_TRUE(write_file_atomically(project.directory / name, bytes));
    }
    /// Warnings of a project with this logo.
    std::string said_of(const std::string& name) {
        project.certificate.logo = name;
        std::string all;
        const Problems problems = MadeProject::make(project)->problems();
        for (const Problem& problem : problems.items()) {
            EXPECT_EQ(problem.path, "/certificate/laboratory/logo") << problem.message.english();
            EXPECT_EQ(problem.severity, Severity::warning) << "the results do not need it";
            all += problem.message.english();
        }
        EXPECT_EQ(all.empty(), certificate_logo(project).has_value()) << name;
        return all;
    }
};

TEST_F(CertificateLogo, PngAndJpegFilesAreTakenAsTheyAre) {
    EXPECT_EQ(said_of(""), "");
    EXPECT_TRUE(certificate_logo(project)->empty());
    file("a.png", "\x89PNG\r\n\x1a\n...");
    EXPECT_EQ(said_of("a.png"), "");
    EXPECT_EQ(certificate_logo(project)->media_type, "image/png");
    file("b", "\xff\xd8\xff\xe0...");
    EXPECT_EQ(said_of("b"), "");
    EXPECT_EQ(certificate_logo(project)->media_type, "image/jpeg") << "the name says nothing";
    EXPECT_EQ(certificate_logo(project)->bytes, "\xff\xd8\xff\xe0...");
    EXPECT_EQ(said_of((project.directory / "a.png").string()), "") << "anywhere";
}

TEST_F(CertificateLogo, WhatCannotBeOneIsSaid) {
    EXPECT_NE(said_of("none.png").find("No such file"), std::string::npos);
    file("text.png", "not a picture");
    EXPECT_NE(said_of("text.png").find("neither a PNG nor a JPEG"), std::string::npos);
    file("large.png", "\x89PNG\r\n\x1a\n" + std::string(2'000'000, 'x'));
    EXPECT_NE(said_of("large.png").find("more than 2 MB"), std::string::npos);
    EXPECT_NE(said_of("."), "") << "a folder";
    ASSERT_EQ(mkfifo((project.directory / "pipe.png").c_str(), 0600), 0);
    EXPECT_NE(said_of("pipe.png"), "") << "and nobody waits for it";
}

}  // namespace
}  // namespace covaria::test::certificate_logo_test
