// What a package installs: the program from a folder of its own, its man page and its completion.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/app/program.h"

namespace {

namespace fs = std::filesystem;

/// What a line of bash prints.
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
