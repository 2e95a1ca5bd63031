// The contract of the command line: what scripts rely on.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string stewart = shipped_project("stewart-platform.covaria").string();

json results_of(const fs::path& folder) {
    return json::parse(read_text(folder / "results.json"));
}

TEST(CommandLine, HelpNamesEverySubcommand) {
    const Outcome help = run_program({"--help"});
    EXPECT_EQ(help.status, 0);
    for (const char* word : {"run", "design", "report", "render", "validate", "describe", "convert",
                             "import ", "import-urdf", "Exit status"})
        EXPECT_NE(help.out.find(word), std::string::npos) << word;
}

TEST(CommandLine, WrongUsageIsStatusTwo) {
    EXPECT_EQ(run_program({"run"}).status, 2);
    EXPECT_EQ(run_program({"frobnicate"}).status, 2);
    const Outcome mistyped = run_program({"rnu", stewart});
    EXPECT_EQ(mistyped.status, 2);
    EXPECT_NE(mistyped.err.find("did you mean 'run'"), std::string::npos) << mistyped.err;
    EXPECT_EQ(run_program({"run", stewart, "--trials", "-5"}).status, 2);
    EXPECT_EQ(run_program({"run", stewart, "--trials", "1000", "--adaptive"}).status, 2);
}

TEST(CommandLine, TheLibraryIsSearchedAndTellsItsSources) {
    const Outcome found = run_program({"library", "search", "LEICA", "at960"});
    ASSERT_EQ(found.status, 0) << found.err;
    EXPECT_NE(found.out.find("leica-at960"), std::string::npos) << found.out;
    EXPECT_EQ(found.out.find("faro"), std::string::npos) << found.out;
    const Outcome shown = run_program({"library", "show", "leica-at500"});
    ASSERT_EQ(shown.status, 0) << shown.err;
    EXPECT_NE(shown.out.find("ISO 10360-10:2021"), std::string::npos) << shown.out;
    EXPECT_EQ(run_program({"library", "search", "no-such-thing"}).status, 1);
    const Outcome unknown = run_program({"library", "show", "no-such-thing"});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_NE(unknown.err.find("covaria library list"), std::string::npos) << unknown.err;
}

TEST(CommandLine, RunWritesResultsAndTables) {
    const fs::path folder = fresh_folder("run");
    const Outcome run = run_program({"run", stewart, "--trials", "20000", "--out", folder.string()});
    ASSERT_EQ(run.status, 0) << run.err;
    const json results = results_of(folder);
    EXPECT_EQ(results.at("format"), "covaria-results");
    EXPECT_EQ(results.at("schemaVersion"), 1);
    ASSERT_EQ(results.at("analyses").size(), 2u);
    const json& analysis = results["analyses"][0];
    EXPECT_EQ(analysis.at("trials"), 20000);
    EXPECT_EQ(analysis.at("failedTrials"), 0);
    ASSERT_EQ(analysis.at("outputs").size(), 78u);
    const json& output = analysis["outputs"][0];
    for (const char* key :
         {"symbol", "group", "unit", "role", "estimate", "mean", "standardUncertainty", "expandedUncertainty",
          "coverageFactor", "interval", "shortestInterval", "skewness", "kurtosis", "firstOrder"})
        EXPECT_TRUE(output.contains(key)) << key;
    EXPECT_EQ(analysis.at("covariance").size(), 78u);
    for (const char* table : {"results", "budget", "covariance"}) {
        const fs::path file = folder / (analysis.at("id").get<std::string>() + "-" + table + ".csv");
        EXPECT_TRUE(fs::exists(file)) << file;
    }
}

TEST(CommandLine, ResultsAreTheSameBytesForAnyNumberOfThreads) {
    std::string first;
    for (const char* threads : {"1", "2", "7"}) {
        const fs::path folder = fresh_folder(std::string("threads-") + threads);
        ASSERT_EQ(
            run_program({"run", stewart, "--trials", "50000", "--threads", threads, "--out", folder.string()})
                .status,
            0);
        const std::string bytes = read_text(folder / "results.json");
        if (first.empty()) first = bytes;
        EXPECT_EQ(bytes, first) << threads << " threads";
    }
}

TEST(CommandLine, VarianceReductionIsStatedAndAnythingElseIsWrongUsage) {
    for (const std::string kind : {"control-variate", "sobol"}) {
        std::string first;
        for (const char* threads : {"1", "3"}) {
            const fs::path folder = fresh_folder(kind + threads);
            const Outcome run =
                run_program({"run", stewart, "--trials", "20000", "--analysis", "printed",
                             "--variance-reduction", kind, "--threads", threads, "--out", folder.string()});
            ASSERT_EQ(run.status, 0) << run.err;
            const json analysis = results_of(folder)["analyses"][0];
            EXPECT_EQ(analysis.at("varianceReduction").at("kind"), kind);
            EXPECT_GT(analysis.at("varianceReduction").at("leastGain"), kind == "sobol" ? 0.1 : 100.0);
            const json& output = analysis["outputs"][0]["varianceReduction"];
            EXPECT_GT(output.at("standardErrors").at("high"), 0.0);
            EXPECT_GT(output.at("gains").at("standardUncertainty"), kind == "sobol" ? 0.1 : 1000.0);
            const std::string bytes = read_text(folder / "results.json");
            if (first.empty()) first = bytes;
            EXPECT_EQ(bytes, first);
        }
    }
    EXPECT_EQ(run_program({"run", stewart, "--variance-reduction", "antithetic"}).status, 2);
}

TEST(CommandLine, SeedAndAnalysisAreHonoured) {
    const fs::path folder = fresh_folder("seed");
    const json all = json::parse(read_text(stewart));
    const std::string id = all.at("analyses")[1].at("id");
    const Outcome run = run_program(
        {"run", stewart, "--analysis", id, "--trials", "5000", "--seed", "42", "--out", folder.string()});
    ASSERT_EQ(run.status, 0) << run.err;
    const json results = results_of(folder);
    ASSERT_EQ(results.at("analyses").size(), 1u);
    EXPECT_EQ(results["analyses"][0].at("id"), id);
    const json seed = results["analyses"][0].at("seed");
    EXPECT_TRUE(seed == "42" || seed == 42);
    const Outcome unknown = run_program({"run", stewart, "--analysis", "nothing", "--out", folder.string()});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_NE(unknown.err.find(id), std::string::npos)
        << "the message names the analyses there are: " << unknown.err;
}

TEST(CommandLine, InterruptedRunSaysSoAndLeavesNoResults) {
    const fs::path folder = fresh_folder("interrupt");
    const Outcome run = run_program({"run", stewart, "--trials", "2000000000", "--out", folder.string()},
                                    Ending::interrupted);
    EXPECT_EQ(run.status, 130) << run.err;
    EXPECT_FALSE(fs::exists(folder / "results.json"));
    EXPECT_NE(run.err.find("stopped"), std::string::npos) << run.err;
}

TEST(CommandLine, DescribeListsModelsAndTheirFields) {
    const Outcome list = run_program({"describe"});
    EXPECT_EQ(list.status, 0);
    EXPECT_NE(list.out.find("pose-from-points"), std::string::npos);
    const Outcome pose = run_program({"describe", "pose-from-points"});
    EXPECT_EQ(pose.status, 0);
    EXPECT_NE(pose.out.find("base_points (table"), std::string::npos);
    EXPECT_NE(pose.out.find("[mm]"), std::string::npos);
    EXPECT_EQ(run_program({"describe", "nothing"}).status, 1);
    for (const auto& [part, field] : std::map<std::string, std::string>{
             {"inputs", "components (list, see components, optional)"},
             {"components", "student-t: mean (in the unit), scale (in the unit), degrees_of_freedom"},
             {"correlations", "coefficient (number, at least -1, at most 1)"},
             {"options", "coverageProbability (number, greater than 0, less than 1, optional)  default 0.95"},
             {"requirements", "guardFactor (number, at least -10, at most 10, optional)  default 1"},
             {"studies", "axes (list, see axes)"},
             {"axes", "spacing (choice, optional)  default linear"},
             {"designs", "variables (list, see variables, optional)"},
             {"variables", "tolerance (number, at least 0, optional)  default 0"},
             {"choose", "keep (whole number, at least 1)"},
             {"boxes", "unit (unit)"}}) {
        EXPECT_NE(list.out.find("\n  " + part + " "), std::string::npos) << part;
        const Outcome described = run_program({"describe", part});
        EXPECT_EQ(described.status, 0) << part;
        EXPECT_NE(described.out.find(field), std::string::npos) << described.out;
    }
}

TEST(CommandLine, DesignWritesWhatItFoundAndTakesItOver) {
    const fs::path folder = fresh_folder("design");
    const std::string file = shipped_project("ballbar-design.covaria").string();
    const std::string taken = (folder / "twelve.covaria").string();
    const Outcome found = run_program({"design", file, "--out", folder.string(), "--take-over", taken});
    ASSERT_EQ(found.status, 0) << found.err;
    EXPECT_NE(found.out.find("Rows kept: 12 of 22"), std::string::npos) << found.out;
    const json design = json::parse(read_text(folder / "design-points-twelve.json"));
    EXPECT_EQ(design.at("gains").size(), 22u);
    EXPECT_EQ(design.at("format"), "covaria-design");
    EXPECT_EQ(design.at("rows").size(), 12u);
    EXPECT_LT(design.at("best").get<double>(), 1.1);
    for (const char* table : {"outputs", "rows", "curve", "path", "reasons"})
        EXPECT_TRUE(fs::exists(folder / (std::string("design-points-twelve-") + table + ".csv"))) << table;
    const json project = json::parse(read_text(taken));
    EXPECT_EQ(project["analyses"][0]["setup"]["measured_points"]["rows"].size(), 12u);
    EXPECT_EQ(run_program({"design", file, "--design", "thirteen"}).status, 1);
    EXPECT_EQ(run_program({"design", stewart}).status, 1);  // it has no designs
}

TEST(CommandLine, DesignOfATargetThatCannotBeMetIsStatusThree) {
    const fs::path folder = fresh_folder("design-target");
    const std::string file = (folder / "target.covaria").string();
    write_text(file, R"JSON({"format": "covaria", "schemaVersion": 1, "title": "t", "assets": [],
        "analyses": [{"id": "a", "model": "measurement-equation",
        "setup": {"equations": ["y = d*(2 + sin(t))"], "quantities": {
          "columns": ["symbol", "value", "unit", "statement", "a"],
          "rows": [["d", 0, "mm", "standard", 1], ["t", 0, "rad", null, null]]}},
        "options": {"trials": 20000},
        "requirements": [{"symbol": "y", "targetUncertainty": {"value": 1.5, "unit": "mm"}}],
        "designs": [{"id": "d", "variables":
          [{"target": "/inputs/t/estimate", "from": -3, "to": 3, "unit": "rad"}]}]}]})JSON");
    const Outcome found = run_program({"design", file});
    EXPECT_EQ(found.status, 3) << found.err;
    EXPECT_NE(found.out.find("the target of U(y) is not met: the best design found reaches 1.960 mm"),
              std::string::npos)
        << found.out;
}

TEST(CommandLine, ConvertGivesTheSameBytesForACanonicalFile) {
    const fs::path folder = fresh_folder("convert");
    for (const auto& entry : fs::directory_iterator(fs::path(stewart).parent_path()))
        if (entry.path().extension() == ".csv" || entry.path().extension() == ".covaria")
            fs::copy_file(entry.path(), folder / entry.path().filename());
    const std::string copy = (folder / "stewart-platform.covaria").string();
    ASSERT_EQ(run_program({"convert", copy, (folder / "again.covaria").string()}).status, 0);
    EXPECT_EQ(read_text(folder / "again.covaria"), read_text(stewart));
    const Outcome embedded =
        run_program({"convert", copy, (folder / "sub-embedded.covaria").string(), "--embed"});
    ASSERT_EQ(embedded.status, 0) << embedded.err;
    EXPECT_EQ(read_text(folder / "sub-embedded.covaria").find(".csv\""), std::string::npos);
}

TEST(CommandLine, RenderDrawsAPicture) {
    const fs::path folder = fresh_folder("render");
    const std::string file = (folder / "pose.png").string();
    const Outcome run = run_program({"render", stewart, "--trials", "20000", "--group", "pose 7", "--view",
                                     "front", "--width", "640", "--height", "400", "-o", file});
    ASSERT_EQ(run.status, 0) << run.err;
    const std::string bytes = read_text(file);
    EXPECT_EQ(bytes.substr(1, 3), "PNG");
    EXPECT_GT(bytes.size(), 5000u);
    const Outcome unknown =
        run_program({"render", stewart, "--trials", "2000", "--group", "pose 99", "-o", file});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_NE(unknown.err.find("pose 13"), std::string::npos)
        << "the message names the groups there are: " << unknown.err;
}

TEST(CommandLine, RenderDrawsTheEllipsoidsOfAnotherProject) {
    const fs::path folder = fresh_folder("render-before");
    const std::string file = (folder / "pose.gltf").string();
    const auto drawn = [&](const std::vector<std::string>& further) {
        std::vector<std::string> words{"render", stewart, "--trials", "2000", "-o", file};
        words.insert(words.end(), further.begin(), further.end());
        const Outcome run = run_program(words);
        EXPECT_EQ(run.status, 0) << run.err;
        return read_text(file);
    };
    EXPECT_EQ(drawn({}).find("ellipsoids_before"), std::string::npos);
    EXPECT_NE(drawn({"--before", stewart}).find("ellipsoids_before"), std::string::npos);
    EXPECT_EQ(run_program({"render", stewart, "--before", "nowhere.covaria", "-o", file}).status, 1);
}

TEST(CommandLine, RenderDrawsASavedView) {
    const fs::path folder = fresh_folder("render-view");
    for (const auto& file : fs::directory_iterator(fs::path(stewart).parent_path()))
        if (file.path().filename().string().starts_with("stewart-platform-")) fs::copy(file, folder);
    const fs::path project = folder / "views.covaria";
    json with_view = json::parse(read_text(stewart));
    with_view["analyses"][0]["views"] =
        json::parse(R"([{"name": "from the door", "direction": [-0.5, 1, -0.3],
        "up": [0, 0, 1], "centre": [0, 0, 400], "width": 2000, "height": 2000, "lengthUnit": "mm",
        "perspective": true, "hidden": ["body:base"]}])");
    std::ofstream(project) << with_view.dump();
    const auto render = [&](const std::vector<std::string>& words) {
        const fs::path file = folder / "view.png";
        std::vector<std::string> all = {"render", project.string(), "--trials", "2000", "--width",
                                        "640",    "--height",       "400",      "-o",   file.string()};
        all.insert(all.end(), words.begin(), words.end());
        const Outcome run = run_program(all);
        EXPECT_EQ(run.status, 0) << run.err;
        return read_text(file);
    };
    const std::string saved = render({"--view", "from the door"});
    EXPECT_NE(saved, render({"--view", "from the door", "--orthographic"}));
    EXPECT_EQ(saved, render({"--view", "from the door", "--perspective"}));
    const std::string back = render({"--view", "back"});
    EXPECT_EQ(back, render({"--view", "back", "--orthographic"}));
    EXPECT_NE(back, render({"--view", "back", "--perspective"}));
    EXPECT_NE(back, render({"--view", "front"}));
    const Outcome unknown = run_program({"render", project.string(), "--view", "window"});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_NE(unknown.err.find("\"from the door\""), std::string::npos) << unknown.err;
    EXPECT_EQ(run_program({"render", project.string(), "--perspective", "--orthographic"}).status, 2);
}

TEST(CommandLine, RenderCutsTheSceneOpen) {
    const fs::path folder = fresh_folder("render-section");
    const auto render = [&](const std::vector<std::string>& words) {
        const fs::path file = folder / "section.png";
        std::vector<std::string> all = {"render", stewart,    "--trials", "2000", "--width",
                                        "640",    "--height", "400",      "-o",   file.string()};
        all.insert(all.end(), words.begin(), words.end());
        const Outcome run = run_program(all);
        EXPECT_EQ(run.status, 0) << run.err;
        return read_text(file);
    };
    const std::string whole = render({}), cut = render({"--section", "x=0.05"});
    EXPECT_NE(whole, cut);
    EXPECT_EQ(cut, render({"--section", "x = 50 mm"}));
    EXPECT_NE(cut, render({"--section", "-x=0.05"})) << "the other side";
    EXPECT_NE(whole, render({"--section", "z"})) << "in the middle";
    for (const char* wrong : {"w=1", "x=", "x=1kg", "x=much", "=1", ""}) {
        const Outcome refused = run_program({"render", stewart, "--section", wrong});
        EXPECT_EQ(refused.status, 2) << wrong;
        EXPECT_NE(refused.err.find("-y=250mm"), std::string::npos) << refused.err;
    }
    const std::string file = (folder / "scene.gltf").string();
    EXPECT_NE(run_program({"render", stewart, "--section", "x", "-o", file}).status, 0);
    EXPECT_FALSE(fs::exists(file));
}

TEST(CommandLine, RenderDrawsWhatADesignHasFound) {
    const fs::path folder = fresh_folder("render-design");
    const std::string ballbars = shipped_project("ballbar-design.covaria").string();
    const std::string file = (folder / "design.png").string(), plain = (folder / "plain.png").string();
    const std::vector<std::string> more = {"--trials", "2000", "--width", "640", "--height", "400"};
    const auto render = [&](std::vector<std::string> words) {
        words.insert(words.end(), more.begin(), more.end());
        return run_program(words);
    };
    ASSERT_EQ(render({"render", ballbars, "--design", "twelve", "-o", file}).status, 0);
    ASSERT_EQ(render({"render", ballbars, "-o", plain}).status, 0);
    EXPECT_EQ(read_text(file).substr(1, 3), "PNG");
    EXPECT_NE(read_text(file), read_text(plain));
    const Outcome unknown = render({"render", ballbars, "--design", "thirteen", "-o", file});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_NE(unknown.err.find("has no design \"thirteen\""), std::string::npos) << unknown.err;
}

TEST(CommandLine, ReportWritesAllFormatsAndTheirFigures) {
    const fs::path folder = fresh_folder("report");
    const Outcome run = run_program({"report", stewart, "--trials", "20000", "--out", folder.string()});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(read_text(folder / "report.pdf").substr(0, 5), "%PDF-");
    const std::string html = read_text(folder / "report.html");
    EXPECT_NE(html.find("<table"), std::string::npos);
    std::size_t figures = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".svg" && entry.path().extension() != ".png") continue;
        ++figures;
        EXPECT_NE(html.find(name), std::string::npos) << name << " is not shown in the page";
    }
    EXPECT_GE(figures, 5u);
}

}  // namespace
