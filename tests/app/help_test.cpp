// The help is true: its examples run, the documents name commands and options that exist, and mistyped ones
// are guessed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "tests/app/program.h"

namespace help_test {
namespace {

namespace fs = std::filesystem;

const fs::path source = COVARIA_SOURCE_DIR;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::string help_of(const std::string& command) {
    const Outcome help = command.empty() ? run_program({"--help"}) : run_program({command, "--help"});
    EXPECT_EQ(help.status, 0) << command << help.err;
    return help.out;
}

/// The commands that --help lists.
std::vector<std::string> commands() {
    std::vector<std::string> names;
    bool listed = false;
    for (const std::string& line : lines_of(help_of(""))) {
        if (line == "Subcommands:") listed = true;
        if (line.empty()) listed = false;
        std::smatch name;
        if (listed && std::regex_search(line, name, std::regex("^  ([a-z][a-z-]*) ")))
            names.push_back(name[1]);
    }
    return names;
}

/// The lines of the examples, without those of the window.
std::vector<std::string> examples_of(const std::string& command) {
    std::vector<std::string> examples;
    for (const std::string& line : lines_of(help_of(command)))
        if (line.starts_with("  covaria ")) examples.push_back(line.substr(2));
    return examples;
}

std::string word_after_covaria(const std::string& line) {
    std::istringstream words(line);
    std::string covaria, command;
    words >> covaria >> command;
    return command;
}

/// A folder with the files that the examples name.
fs::path folder_of_examples() {
    const fs::path folder = fresh_folder("help-examples");
    fs::create_directory_symlink(source / "projects", folder / "projects");
    const fs::path readers = source / "tests/data/readers";
    fs::copy_file(readers / "bar.xml", folder / "certificate.xml");
    fs::copy_file(readers / "sa-groups.txt", folder / "jig.txt");
    fs::copy(source / "docs/three-years/2025", folder / "archive");
    fs::copy_file(source / "docs/three-years/standard/2026-as-found.covaria", folder / "new.covaria");
    const std::string gauge = shipped_project("certificate-gauge-block.covaria").string();
    fs::copy_file(gauge, folder / "corrected.covaria");
    for (const std::vector<std::string>& made :
         {std::vector<std::string>{"report", gauge, "--certificate", "-o", (folder / "issued.pdf").string()},
          {"release", gauge, "--prepared", "A", "--checked", "B", "--released", "C", "-o",
           (folder / "order.covaria").string()}})
        EXPECT_EQ(run_program(made).status, 0) << made.front();
    write_text(folder / "points.csv", "P,1,2,3,0.001,a\nQ,4,5,6,0.001,b\n");
    write_text(
        folder / "arm.urdf",
        "<robot name=\"arm\"><joint name=\"shoulder\" type=\"revolute\"><origin xyz=\"0 0 0.4\"/><parent "
        "link=\"base\"/><child link=\"upper\"/><axis xyz=\"0 0 1\"/></joint><joint name=\"elbow\" "
        "type=\"revolute\"><origin xyz=\"0.3 0 0\"/><parent link=\"upper\"/><child link=\"lower\"/>"
        "<axis xyz=\"0 1 0\"/></joint></robot>");
    return folder;
}

/// Output of a line typed into a shell in that folder.
std::string printed(const std::string& line, const fs::path& folder, int& status) {
    const fs::path bin = folder / "bin", out = folder / "printed.txt";
    if (!fs::exists(bin)) {
        fs::create_directory(bin);
        fs::create_symlink(COVARIA_PROGRAM, bin / "covaria");
    }
    const std::string command = "cd '" + folder.string() + "' && PATH='" + bin.string() + "':\"$PATH\" && " +
                                line + " > '" + out.string() + "' 2>&1";
    status = WEXITSTATUS(std::system(command.c_str()));
    return read_text(out);
}

void run_examples(const std::vector<std::string>& of, const fs::path& folder) {
    for (const std::string& command : of) {
        const std::vector<std::string> examples = examples_of(command);
        EXPECT_FALSE(examples.empty()) << command << " --help has no examples";
        for (const std::string& example : examples) {
            EXPECT_EQ(word_after_covaria(example), command) << example;
            int status = -1;
            const std::string said = printed(example, folder, status);
            EXPECT_EQ(status, 0) << example << "\n" << said;
        }
    }
}

TEST(Help, EveryCommandHasExamplesThatRun) {
    const fs::path folder = folder_of_examples();
    std::vector<std::string> all = commands();
    ASSERT_GT(all.size(), 15u);
    // A report is there before it is verified, parts before they are merged.
    const auto order = [](const std::string& name) {
        return name == "verify-report" || name == "merge" ? 1 : 0;
    };
    std::stable_sort(all.begin(), all.end(),
                     [&](const auto& a, const auto& b) { return order(a) < order(b); });
    run_examples(all, folder);
}

std::set<std::string> options_in(const std::string& text) {
    std::set<std::string> options;
    const std::regex option("--[a-z][a-z-]*");
    for (auto found = std::sregex_iterator(text.begin(), text.end(), option); found != std::sregex_iterator();
         ++found)
        options.insert(found->str());
    return options;
}

/// Command lines in a document: in code, from "covaria COMMAND" to the end of the code or line.
std::vector<std::string> command_lines_of(const std::string& markdown) {
    std::vector<std::string> found;
    const std::regex line("(?:^|[`/ ]|\\n)covaria ([a-z][^`\\n|;)]*)"), run("scripts/run ([a-z][^`\\n|;)]*)");
    for (const std::regex& pattern : {line, run})
        for (auto match = std::sregex_iterator(markdown.begin(), markdown.end(), pattern);
             match != std::sregex_iterator(); ++match)
            found.push_back("covaria " + (*match)[1].str());
    return found;
}

TEST(Help, DocumentsNameCommandsAndOptionsThatExist) {
    std::map<std::string, std::set<std::string>> options;
    for (const std::string& command : commands()) options[command] = options_in(help_of(command));
    for (const char* of_library : {"list", "search", "show"})
        options["library"].merge(options_in(run_program({"library", of_library, "--help"}).out));
    std::vector<fs::path> documents{source / "README.md"};
    for (const auto& entry : fs::directory_iterator(source / "docs"))
        if (entry.path().extension() == ".md") documents.push_back(entry.path());
    std::size_t checked = 0;
    for (const fs::path& document : documents)
        for (const std::string& line : command_lines_of(read_text(document))) {
            const auto known = options.find(word_after_covaria(line));
            if (known == options.end()) continue;  // prose: "covaria is", which is no command
            if (line.find("has no option") != std::string::npos) continue;
            for (const std::string& option : options_in(line)) {
                EXPECT_TRUE(known->second.contains(option)) << document << ": " << line << ": " << option;
                ++checked;
            }
        }
    EXPECT_GT(checked, 20u) << "the documents have command lines";
}

TEST(Help, TheTableOfCommandsHasAllOfThem) {
    const std::string table = read_text(source / "docs/command-line.md");
    for (const std::string& command : commands())
        EXPECT_NE(table.find("| `covaria " + command), std::string::npos) << command;
}

TEST(Help, MistypedCommandsAndOptionsAreGuessed) {
    const std::string gauge = shipped_project("gum/h1-end-gauge.covaria").string();
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
        {{"rnu", gauge}, "did you mean 'run'"},
        {{"library", "serach", "leica"}, "did you mean 'search'"},
        {{"run", gauge, "--trails", "1000"}, "did you mean '--trials'"},
        {{"run", "--trails", "1000", gauge}, "did you mean '--trials'"},
        {{"run", gauge, "--trails=1000"}, "did you mean '--trials'"},
        {{"run", gauge, "-trials", "1000"}, "did you mean '--trials'"},
        {{"report", gauge, "--cert"}, "did you mean '--certificate'"},
        {{"export", gauge, "--sa", "points"}, "did you mean '--as'"},
        {{"library", "show", "leica-at500", "--pciture", "a.png"}, "did you mean '--picture'"},
        {{"validate", gauge, "--format", "pdf"}, "it is an option of 'run'"},
        {{"--langauge", "de"}, "did you mean '--language'"},
        {{"report", gauge, "--langage", "de"}, "'--language' is an option of 'covaria'"},
        {{"validate", gauge, "--adaptve"}, "'--adaptive' is an option of "},
        {{"run", gauge, "--qqqqqqqq"}, "\"covaria run --help\" lists its options"},
        {{"frobnicate"}, "covaria has no command 'frobnicate'"}};
    for (const auto& [words, said] : cases) {
        const Outcome wrong = run_program(words);
        EXPECT_EQ(wrong.status, 2) << said;
        EXPECT_NE(wrong.err.find(said), std::string::npos) << said << "\n" << wrong.err;
        EXPECT_EQ(wrong.out, "");
    }
    const Outcome letter = run_program({"run", gauge, "-x"});
    EXPECT_NE(letter.err.find("covaria run has no option '-x'"), std::string::npos) << letter.err;
    EXPECT_EQ(letter.err.find("did you mean"), std::string::npos) << letter.err;
    // Correct words are not guessed at.
    EXPECT_NE(run_program({"run"}).err.find("FILE is required"), std::string::npos);
    EXPECT_NE(run_program({"run", gauge, "--trials", "-5"}).err.find("'-5' is not a whole number"),
              std::string::npos);
    EXPECT_NE(run_program({"nowhere.covaria"}).err.find("nowhere.covaria"), std::string::npos);
    const Outcome search = run_program({"library", "search", "laica", "at500"});
    EXPECT_EQ(search.status, 1);
    EXPECT_NE(search.err.find("(did you mean 'leica at500'?)"), std::string::npos) << search.err;
    EXPECT_EQ(run_program({"library", "search", "qqqqqq"}).err.find("did you mean"), std::string::npos);
    EXPECT_EQ(run_program({"describe", "spherical-instrumnet"}).status, 1);
    EXPECT_NE(
        run_program({"describe", "spherical-instrumnet"}).err.find("did you mean 'spherical-instrument'"),
        std::string::npos);
}

/// Every option of every command, with two letters exchanged.
TEST(Help, EveryOptionIsGuessedWhenTwoLettersAreExchanged) {
    for (const std::string& command : commands()) {
        const std::set<std::string> options = options_in(help_of(command));
        for (std::string option : options) {
            if (option.size() < 6 || option == "--help") continue;
            const std::string right = option;
            std::swap(option[3], option[4]);
            if (options.contains(option) || option == right) continue;
            // Before a word that is no subcommand, an option of the command itself is what is left to guess.
            const Outcome wrong = run_program({command, option, "x"});
            EXPECT_EQ(wrong.status, 2) << command << ' ' << option;
            EXPECT_NE(wrong.err.find("did you mean '" + right + "'"), std::string::npos)
                << command << ' ' << option << "\n"
                << wrong.err;
        }
    }
}

}  // namespace
}  // namespace help_test
