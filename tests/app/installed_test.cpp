// An installed package: the program runs from a folder of its own, with its man page and its completion.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/app/program.h"

namespace {

namespace fs = std::filesystem;

/// Output of a line of bash.
std::string printed_by_bash(const std::string& line, const fs::path& folder) {
    const fs::path out = folder / "printed.txt";
    const std::string command = "bash -c '" + line + "' > '" + out.string() + "' 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << line;
    return read_text(out);
}

TEST(Installed, TheCommandLineDescribesItself) {
    const Outcome page = run_program({"manual", "man-page"});
    ASSERT_EQ(page.status, 0) << page.err;
    for (const char* text :
         {".TH COVARIA 1", ".SS run", ".B \\-\\-variance\\-reduction", ".SS import\\-urdf", "Exit status"})
        EXPECT_NE(page.out.find(text), std::string::npos) << text;
    EXPECT_EQ(run_program({"manual", "poem"}).status, 2);
}

TEST(Installed, TheManualIsWrittenAsHtmlAndPdf) {
    const fs::path folder = fresh_folder("manual");
    const Outcome html = run_program({"manual", "html", "-o", (folder / "manual.html").string()});
    ASSERT_EQ(html.status, 0) << html.err;
    const std::string page = read_text(folder / "manual.html");
    for (const char* text :
         {"id=\"command-verify-report\"", "<code>--variance-reduction", "id=\"glossary-measurand\"",
          "id=\"model-pose-from-points\"", "data:image/png;base64,"})
        EXPECT_NE(page.find(text), std::string::npos) << text;
    const Outcome pdf = run_program({"manual", "pdf", "-o", (folder / "manual.pdf").string()});
    ASSERT_EQ(pdf.status, 0) << pdf.err;
    const std::string printed = read_text(folder / "manual.pdf");
    EXPECT_TRUE(printed.starts_with("%PDF-"));
    EXPECT_GT(printed.size(), 500'000u) << "with its pictures";
    EXPECT_EQ(run_program({"manual", "html", "-o", (folder / "nowhere/manual.html").string()}).status, 1);
}

TEST(Installed, BashCompletesCommandsAndOptions) {
    const fs::path folder = fresh_folder("completion");
    const Outcome script = run_program({"manual", "bash-completion"});
    ASSERT_EQ(script.status, 0) << script.err;
    write_text(folder / "covaria", script.out);
    const std::string ask = "cd " + folder.string() + "; . ./covaria; COMP_CWORD=";
    const std::string print = "; _covaria; echo ${COMPREPLY[@]}";
    EXPECT_EQ(printed_by_bash(ask + "1; COMP_WORDS=(covaria verify-r)" + print, folder), "verify-report\n");
    EXPECT_EQ(printed_by_bash(ask + "2; COMP_WORDS=(covaria run --tri)" + print, folder), "--trials\n");
    EXPECT_EQ(printed_by_bash(ask + "2; COMP_WORDS=(covaria run co)" + print, folder), "covaria\n")
        << "a file";
}

/// The kind that the desktop takes a file without an ending for, by packaging/covaria.xml.
std::string kind_of_file(const std::string& content, const fs::path& folder) {
    write_text(folder / "file", content);
    const std::string told =
        printed_by_bash("XDG_DATA_HOME=" + folder.string() + " gio info -a standard::content-type " +
                            (folder / "file").string(),
                        folder);
    const std::string key = "standard::content-type: ";
    const auto at = told.find(key);
    if (at == std::string::npos) return told;
    return told.substr(at + key.size(), told.find('\n', at) - at - key.size());
}

TEST(Installed, TheDesktopKnowsProjectsByTheirContent) {
    const fs::path folder = fresh_folder("mime");
    fs::create_directories(folder / "mime/packages");
    fs::copy_file(shipped_project("../packaging/covaria.xml"), folder / "mime/packages/covaria.xml");
    printed_by_bash("update-mime-database " + (folder / "mime").string() + " || true", folder);
    for (const auto& entry : fs::directory_iterator(shipped_project("")))
        if (entry.path().extension() == ".covaria")
            EXPECT_EQ(kind_of_file(read_text(entry.path()), folder), "application/x-covaria") << entry.path();
    EXPECT_EQ(kind_of_file("{\"format\":\"covaria\",\"schemaVersion\":2}", folder), "application/x-covaria");
    EXPECT_NE(kind_of_file("{\n  \"format\": \"covaria-results\",\n", folder), "application/x-covaria");
    EXPECT_NE(kind_of_file("{\"title\": \"other\"}", folder), "application/x-covaria");
}

TEST(Installed, TheDesktopFileOpensProjectsAndReportsAndTheMetadataAreValid) {
    const fs::path packaging = shipped_project("../packaging");
    const std::string entry = read_text(packaging / "covaria.desktop");
    EXPECT_NE(entry.find("\nMimeType=application/x-covaria;application/pdf;\n"), std::string::npos);
    EXPECT_NE(entry.find("\nExec=covaria %f\n"), std::string::npos);
    const fs::path folder = fresh_folder("appstream");
    const std::string told = printed_by_bash(
        "appstreamcli validate --no-net " + (packaging / "covaria.metainfo.xml").string(), folder);
    EXPECT_NE(told.find("successful"), std::string::npos) << told;
}

/// The program in PREFIX/bin finds PREFIX/share/covaria, wherever that is.
TEST(Installed, TheProgramTakesTheDataBesideIt) {
    const fs::path prefix = fresh_folder("prefix");
    fs::create_directories(prefix / "bin");
    fs::create_directories(prefix / "share/covaria/projects");
    fs::create_directories(prefix / "share/covaria/resources/library");
    fs::copy_file(COVARIA_PROGRAM, prefix / "bin/covaria");
    const std::string listed =
        printed_by_bash("env -u COVARIA_DATA_DIR " + (prefix / "bin/covaria").string() + " library", prefix);
    EXPECT_EQ(listed.find("Leica"), std::string::npos) << listed;
    fs::copy(shipped_project("../resources/library"), prefix / "share/covaria/resources/library");
    EXPECT_NE(
        printed_by_bash("env -u COVARIA_DATA_DIR " + (prefix / "bin/covaria").string() + " library", prefix)
            .find("Leica"),
        std::string::npos);
}

}  // namespace
