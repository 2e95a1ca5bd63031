// Hostile files, names and moments: none brings the program down, or lets it write what was not meant.
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/app/program.h"

namespace hostile_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string corpus(const std::string& name) {
    return (fs::path(COVARIA_SOURCE_DIR) / "tests/fuzz/corpus" / name).string();
}
const std::string gauge = shipped_project("gum/h1-end-gauge.covaria").string();
const std::string stewart = shipped_project("stewart-platform.covaria").string();

bool contains(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

TEST(Hostile, ADistributionThatCannotBeIsAProblemWithAPlace) {
    for (const char* name : {"abort-negative.covaria", "abort-min.covaria"}) {
        const fs::path folder = fresh_folder(std::string("hostile-") + name);
        const fs::path copy = fs::path(stewart).parent_path() / "force-moment-sensor.csv";
        fs::copy_file(copy, folder / "force-moment-sensor.csv");
        fs::copy_file(corpus(name), folder / name);
        const Outcome run = run_program({"validate", (folder / name).string()});
        EXPECT_EQ(run.status, 1) << name;
        EXPECT_TRUE(contains(run.err, std::string(name) + ":")) << run.err;
        EXPECT_TRUE(contains(run.err, "/rows/")) << run.err;
    }
}

TEST(Hostile, WhatIsNoFileIsRefusedAtOnce) {
    const fs::path folder = fresh_folder("hostile-kinds");
    const fs::path pipe = folder / "pipe.covaria", socket_file = folder / "socket.covaria";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int socket_made = socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{AF_UNIX, {}};
    const std::string name = "/tmp/covaria-hostile-" + std::to_string(getpid());
    name.copy(address.sun_path, sizeof address.sun_path - 1);
    ASSERT_EQ(bind(socket_made, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    fs::create_symlink(name, socket_file);
    const std::vector<std::pair<std::string, std::string>> kinds = {{pipe.string(), "a pipe"},
                                                                    {socket_file.string(), "a socket"},
                                                                    {"/dev/zero", "a device"},
                                                                    {folder.string(), "a folder"}};
    for (const auto& [file, words] : kinds) {
        const std::string out = (folder / "out.covaria").string();
        const std::vector<std::vector<std::string>> uses = {
            {"validate", file}, {"convert", file, out}, {"import-urdf", file, "-o", out}};
        for (const auto& arguments : uses) {
            const Outcome run = run_program(arguments);
            EXPECT_EQ(run.status, 1) << file;
            EXPECT_TRUE(contains(run.err, words)) << run.err;
        }
    }
    ::close(socket_made);
    fs::remove(name);
}

TEST(Hostile, AFileThatIsTooLargeIsRefusedBeforeItIsRead) {
    const fs::path file = fresh_folder("hostile-large") / "large.covaria";
    write_text(file, "{");
    fs::resize_file(file, 3'000'000'000);  // sparse
    const Outcome run = run_program({"validate", file.string()});
    EXPECT_EQ(run.status, 1);
    EXPECT_TRUE(contains(run.err, "3000 MB")) << run.err;
    fs::remove(file);
}

TEST(Hostile, ATableOfWrongCellsIsListedInParts) {
    const fs::path folder = fresh_folder("hostile-cells");
    json project = json::parse(read_text(corpus("abort-min.covaria")));
    auto& rows = project["analyses"][0]["setup"]["observations"]["rows"];
    rows = json::array();
    for (int i = 0; i < 40'000; ++i) rows.push_back({"x", "wrong", "wrong"});
    write_text(folder / "wrong.covaria", project.dump(0));
    const auto begin = std::chrono::steady_clock::now();
    const Outcome run = run_program({"validate", (folder / "wrong.covaria").string()});
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 10.0);
    EXPECT_EQ(run.status, 1);
    EXPECT_TRUE(contains(run.err, "and 39900 more")) << run.err.substr(run.err.size() - 500);
    EXPECT_LT(std::count(run.err.begin(), run.err.end(), '\n'), 300);
}

TEST(Hostile, SigintEndsEveryCommandWithin_0_5_Seconds) {
    const fs::path folder = fresh_folder("hostile-interrupt");
    const fs::path pipe = folder / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const std::string out = (folder / "out").string();
    // Some write into a pipe that nobody reads: the worst that can be waited for.
    const std::vector<std::vector<std::string>> commands = {
        {"run", stewart, "--trials", "2000000000", "--out", out},
        {"report", stewart, "--trials", "200000000", "--out", out},
        {"render", stewart, "--trials", "200000000", "-o", (folder / "a.png").string()},
        {"convert", gauge, pipe.string()}};
    for (const auto& command : commands) {
        const Outcome run = run_program(command, Ending::interrupted);
        EXPECT_EQ(run.status, 130) << command[0] << ": " << run.err;
        EXPECT_LT(run.after_signal_s, 0.5 + 1.5) << command[0];  // the rest is for a busy machine
    }
}

std::set<std::string> files_in(const fs::path& folder, const std::string& ending) {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ending) names.insert(fs::relative(entry.path(), folder).string());
    return names;
}

TEST(Hostile, NoPictureOrTableOverwritesAnother) {
    for (const char* name : {"picture-collision.covaria", "csv-collision.covaria", "hostile-names.covaria"}) {
        const fs::path folder = fresh_folder(std::string("hostile-names-") + name);
        const fs::path out = folder / "inner/out";
        const Outcome run =
            run_program({"run", corpus(name), "--trials", "1000", "--pictures", "--out", out.string()});
        ASSERT_EQ(run.status, 0) << run.err;
        const json results = json::parse(read_text(out / "results.json"));
        std::set<std::string> listed;
        for (const json& file : results.at("files"))
            EXPECT_TRUE(listed.insert(file.at("file")).second) << file;
        std::set<std::string> there = files_in(folder, ".png");
        there.merge(files_in(folder, ".csv"));
        std::set<std::string> expected;
        for (const std::string& file : listed) expected.insert("inner/out/" + file);
        EXPECT_EQ(there, expected) << name;
        EXPECT_GE(listed.size(), 10u);
    }
}

TEST(Hostile, OneAnalysisThatFailsIsNamedAndTheOthersAreWritten) {
    const fs::path folder = fresh_folder("hostile-att3");
    const Outcome run =
        run_program({"run", corpus("att3.covaria"), "--first-order", "--report", "--out", folder.string()});
    EXPECT_EQ(run.status, 1);
    const json results = json::parse(read_text(folder / "results.json"));
    const json source = json::parse(read_text(corpus("att3.covaria")));
    ASSERT_EQ(results.at("failed").size(), 1u);
    EXPECT_EQ(results.at("analyses").size() + 1, source.at("analyses").size());
    const json& failed = results["failed"][0];
    const std::string cause = failed.at("cause"), id = failed.at("analysis");
    EXPECT_TRUE(contains(cause, "(")) << "it names the outputs and their pose: " << cause;
    for (const std::string& word : {id, cause}) EXPECT_TRUE(contains(run.err, word)) << run.err;
    EXPECT_TRUE(fs::exists(folder / "report.pdf"));
    EXPECT_TRUE(contains(read_text(folder / "report.md"), "Not evaluated"));
}

TEST(Hostile, WhatIsTypedIsInertInReportsAndTables) {
    const fs::path folder = fresh_folder("hostile-injection");
    for (const char* name : {"injection.covaria", "hostile-names.covaria"}) {
        const fs::path out = folder / name;
        const Outcome run =
            run_program({"run", corpus(name), "--trials", "1000", "--report", "--out", out.string()});
        ASSERT_EQ(run.status, 0) << run.err;
        const std::string html = read_text(out / "report.html"), markdown = read_text(out / "report.md");
        for (const char* live : {"<script>alert", "<img src=x", "<http"}) {
            EXPECT_FALSE(contains(html, live)) << live;
            EXPECT_FALSE(contains(markdown, live)) << live;
        }
        for (const char* live :
             {"[click](javascript", "![i](http", "[l](javascript", " http://", " https://"})
            EXPECT_FALSE(contains(markdown, live)) << live;
        for (const std::string& table : files_in(out, ".csv")) {
            const std::string text = "\n" + read_text(out / table);
            for (const char* start : {"\n=", ",=", "\"=", "\n@", ",@", "\"@", "\n+", ",+"})
                EXPECT_FALSE(contains(text, start)) << table << " has a cell that begins with " << start;
        }
    }
}

TEST(Hostile, TheReportIsTheSameTwice) {
    std::string first;
    for (const char* seed : {"a", "b"}) {
        const fs::path folder = fresh_folder(std::string("hostile-twice-") + seed);
        ASSERT_EQ(run_program({"report", gauge, "--out", folder.string()}).status, 0);
        if (!first.empty()) sleep(1);  // another second on the clock
        const std::string bytes = read_text(folder / "report.pdf") + read_text(folder / "report.html");
        if (first.empty()) first = bytes;
        EXPECT_TRUE(bytes == first);
        EXPECT_FALSE(first.empty());
        sleep(1);
    }
}

TEST(Hostile, NoResultDependsOnMemoryThatNobodySet) {
    for (const char* project : {"gum/h2-impedance.covaria", "lsm-network.covaria", "ballbar-tcp.covaria",
                                "force-moment-sensor.covaria", "er10l-c10.covaria", "tracker-pose.covaria"}) {
        std::string first;
        for (const char* fill : {"MALLOC_PERTURB_=85", "MALLOC_PERTURB_=170"}) {
            const fs::path folder = fresh_folder("hostile-perturb");
            const Outcome run =
                run_program_with({fill}, {"run", shipped_project(project).string(), "--trials", "2000",
                                          "--no-studies", "--out", folder.string()});
            ASSERT_EQ(run.status, 0) << run.err;
            std::string bytes = read_text(folder / "results.json");
            for (const std::string& table : files_in(folder, ".csv")) bytes += read_text(folder / table);
            if (first.empty()) first = bytes;
            EXPECT_TRUE(bytes == first) << project;
        }
    }
}

/// The first control character that is neither a tab nor of a line end, in words; empty: there is none.
std::string control_in(const std::string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]), next = static_cast<unsigned char>(text[i + 1]);
        const bool of_line = c == '\n' || c == '\t' || (c == '\r' && next == '\n');
        const bool second = c == 0xC2 && next >= 0x80 && next <= 0x9F;
        if ((c < 0x20 && !of_line) || c == 0x7F || second)
            return std::to_string(int(c)) + " at " + std::to_string(i) + ", behind '" +
                   text.substr(i < 40 ? 0 : i - 40, std::min<std::size_t>(i, 40)) + "'";
    }
    return {};
}

/// `text` with what a terminal obeys in every text that people type.
std::string with_escapes(std::string text, const std::vector<std::string>& typed) {
    const std::string escapes = "\\u001b[2J\\u001b]0;x\\u0007\\u009b31m\\u007f";
    for (const std::string& words : typed) {
        const std::size_t at = text.find("\"" + words + "\"");
        EXPECT_NE(at, std::string::npos) << words;
        if (at != std::string::npos) text.insert(at + 1, escapes);
    }
    return text;
}

// Names and notes are anybody's; what is printed and written of them is shown, not obeyed.
TEST(Hostile, NoControlCharacterLeavesTheProgram) {
    const fs::path folder = fresh_folder("hostile-escapes");
    const std::string project = (folder / "p.covaria").string(), out = (folder / "out").string();
    write_text(project, with_escapes(R"json({"format": "covaria", "schemaVersion": 2, "title": "the title",
 "notes": "the notes", "author": "the author", "certificate": {"number": "7", "laboratory": {"name": "the lab"}},
 "assets": [], "analyses": [{"id": "a", "model": "measurement-equation", "name": "the name",
 "notes": "of analysis", "setup": {"equations": ["y = x"], "outputs": {"columns": ["symbol", "name", "unit"],
 "rows": [["y", "the output", "1"]]}, "quantities": {"columns": ["symbol", "name", "unit", "value", "statement",
 "a"], "rows": [["x", "the input", "1", 1, "standard", 0.1]]}}, "options": {"trials": 1000},
 "requirements": [{"symbol": "y", "targetUncertainty": {"value": 1, "unit": "1"}}]}]})json",
                                     {"the title", "the notes", "the author", "the lab", "the name",
                                      "of analysis", "the output", "the input"}));
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"run", project, "--report", "--certificate", "--out", out},
          {"validate", project},
          {"validate", corpus("terminal-escape.covaria")},
          {"check", project, "--junit", out + "/junit.xml"},
          {"compare", project, project, "--out", out},
          {"export", project, "--as", "xlsx", "-o", out + "/x.xlsx"},
          {"run", project, "--analysis", "\x1b[2J"},
          {"run", "\x1b[2J.covaria"},
          {"\x1b[2J", "--help"}}) {
        const Outcome outcome = run_program(command);
        EXPECT_EQ(control_in(outcome.out), "") << command[0];
        EXPECT_EQ(control_in(outcome.err), "") << command[0];
    }
    std::size_t files = 0;
    for (const char* ending : {".md", ".html", ".csv", ".json", ".svg", ".xml"})
        for (const std::string& file : files_in(out, ending)) {
            EXPECT_EQ(control_in(read_text(fs::path(out) / file)), "") << file;
            ++files;
        }
    EXPECT_GT(files, 8u);
}

TEST(Hostile, WhatCannotBePrintedIsStatus1) {
    const fs::path err = fresh_folder("hostile-full") / "err";
    for (const char* command : {"describe", "--help", "--version", "library"}) {
        const std::string line =
            std::string("'") + COVARIA_PROGRAM + "' " + command + " > /dev/full 2> '" + err.string() + "'";
        const int status = std::system(line.c_str());
        EXPECT_EQ(WEXITSTATUS(status), 1) << command;
        EXPECT_TRUE(contains(read_text(err), "standard output cannot be written")) << read_text(err);
    }
}

// A picture or table that is called one of the project's folder and is another file of the machine.
TEST(Hostile, NothingOutsideOfTheFolderIsReadByALink) {
    const fs::path folder = fresh_folder("hostile-out"), home = folder / "home", project = folder / "project";
    fs::create_directories(home);
    fs::create_directories(project);
    for (const auto& entry : fs::directory_iterator(fs::path(stewart).parent_path()))
        if (entry.path().filename().string().starts_with("stewart-platform") &&
            entry.path().extension() != ".png")
            fs::copy_file(entry.path(), project / entry.path().filename());
    const std::string file = (project / "stewart-platform.covaria").string();
    ASSERT_EQ(run_program({"validate", file}).status, 0);
    const fs::path table = project / "stewart-platform-artefact.csv";
    fs::rename(table, home / "secret.csv");
    fs::create_symlink(home / "secret.csv", table);
    const Outcome refused = run_program({"validate", file});
    EXPECT_EQ(refused.status, 1);
    EXPECT_TRUE(contains(refused.err, "is a link that leads out of the project's folder")) << refused.err;
    fs::remove(table);
    fs::create_directories(project / "data");
    fs::rename(home / "secret.csv", project / "data/table.csv");
    fs::create_symlink("data/table.csv", table);
    EXPECT_EQ(run_program({"validate", file}).status, 0) << "a link inside is one";
}

TEST(Hostile, ALinkedProjectFindsItsTables) {
    const fs::path folder = fresh_folder("hostile-link");
    fs::create_symlink(stewart, folder / "link.covaria");
    const Outcome run = run_program({"validate", (folder / "link.covaria").string()});
    EXPECT_EQ(run.status, 0) << run.err;
}

TEST(Hostile, NamesOf255BytesAndWhatAKilledProcessLeft) {
    const fs::path folder = fresh_folder("hostile-long");
    const fs::path file = folder / (std::string(247, 'n') + ".covaria");
    ASSERT_EQ(run_program({"convert", gauge, file.string()}).status, 0);
    EXPECT_EQ(read_text(file), read_text(gauge));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST(Hostile, ARenderThatIsTooLargeIsRefused) {
    const fs::path folder = fresh_folder("hostile-render");
    const Outcome run = run_program({"render", stewart, "--first-order", "--width", "16384", "--height",
                                     "16384", "-o", (folder / "a.png").string()});
    EXPECT_EQ(run.status, 2);
    EXPECT_TRUE(contains(run.err, "too large")) << run.err;
}

TEST(Hostile, AWindowWithoutADisplayEndsInASentence) {
    const std::vector<std::vector<std::string>> environments = {
        {std::string("DISPLAY=:987"), "QT_QPA_PLATFORM=xcb"}, {std::string("QT_QPA_PLATFORM=nothing")}};
    for (const std::vector<std::string>& environment : environments) {
        const Outcome run = run_program_with(environment, {gauge});
        EXPECT_EQ(run.status, 1) << run.err;
        EXPECT_TRUE(contains(run.err, "window cannot be opened")) << run.err;
    }
}

}  // namespace
}  // namespace hostile_test
