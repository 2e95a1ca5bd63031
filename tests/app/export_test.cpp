// covaria export: a point list and a certificate as a user gets them; what is missing or mistyped is said.
#include <gtest/gtest.h>

#include <pugixml.hpp>

#include "tests/app/program.h"

namespace export_test {

namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

/// The options that make a certificate complete.
std::vector<std::string> with_certificate(std::vector<std::string> arguments) {
    for (const char* value :
         {"number=K-7", "laboratory/name=Laboratory A", "laboratory/address=Road 1", "laboratory/country=DE",
          "customer/name=Customer B", "customer/address=Lane 2", "item/description=Network",
          "item/serialNumber=17", "dates/calibrated=2026-04-17", "dates/issued=2026-04-20", "method=M 3",
          "environment=20 degC", "traceability=To PTB", "authorised/name=E. Muster"}) {
        arguments.push_back("--set");
        arguments.push_back(std::string("/certificate/") + value);
    }
    return arguments;
}

TEST(Export, PointsGoOutAndIn) {
    const fs::path folder = fresh_folder("export-points");
    const std::string project = shipped_project("lsm-network.covaria").string(),
                      points = (folder / "new" / "points.txt").string();
    const Outcome done = run_program(
        {"export", project, "--as", "points", "--first-order", "--analysis", "paper", "-o", points});
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_TRUE(has(done.out, "in mm")) << done.out;
    const std::string written = read_text(points);
    EXPECT_EQ(std::count(written.begin(), written.end(), '\n'), std::stoi(done.out)) << "points\n"
                                                                                     << done.out;
    const Outcome read =
        run_program({"import", points, "--as", "spatialanalyzer", "-o", (folder / "back.covaria").string()});
    EXPECT_EQ(read.status, 0) << read.err << read.out;
    EXPECT_EQ(run_program({"validate", (folder / "back.covaria").string()}).status, 0);
}

TEST(Export, AnIdentifiedRobotGoesOutAndIn) {
    const fs::path folder = fresh_folder("export-robot");
    const std::string project = shipped_project("er10l-c10.covaria").string();
    for (const auto& [writer, name] : {std::pair("urdf", "robot.urdf"), {"ur-calibration", "robot.yaml"}}) {
        const std::string file = (folder / name).string(),
                          back = (folder / (std::string(writer) + ".covaria")).string();
        const Outcome done = run_program(
            {"export", project, "--as", writer, "--first-order", "--analysis", "trajectories", "-o", file});
        ASSERT_EQ(done.status, 0) << done.err;
        EXPECT_TRUE(has(done.out, "robot trajectories, 6 joints")) << done.out;
        EXPECT_TRUE(has(read_text(file), " mm (u = "));
        const Outcome read =
            run_program({writer == std::string("urdf") ? "import-urdf" : "import", file, "-o", back});
        EXPECT_EQ(read.status, 0) << read.err << read.out;
        EXPECT_EQ(run_program({"validate", back}).status, 0);
    }
    const Outcome several =
        run_program({"export", project, "--as", "urdf", "--first-order", "--analysis", "zero-pose",
                     "--analysis", "zero-pose-nominal", "-o", (folder / "two.urdf").string()});
    EXPECT_EQ(several.status, 1);
    EXPECT_TRUE(has(several.err, "er10l-calibrated") && has(several.err, "er10l-nominal")) << several.err;
    EXPECT_FALSE(fs::exists(folder / "two.urdf"));
}

TEST(Export, ASceneIsAFile) {
    const fs::path folder = fresh_folder("export-scene");
    const std::string project = shipped_project("ballbar-tcp.covaria").string();
    for (const auto& [name, beginning] : {std::pair("scene.gltf", "{"), {"scene.vtp", "<?xml"}}) {
        const Outcome done =
            run_program({"render", project, "--first-order", "-o", (folder / name).string()});
        ASSERT_EQ(done.status, 0) << done.err;
        EXPECT_TRUE(has(done.out, "lengths in m; ")) << done.out;
        EXPECT_EQ(read_text(folder / name).substr(0, std::string_view(beginning).size()), beginning);
    }
    const Outcome chart = run_program({"render", shipped_project("gum/h1-end-gauge.covaria").string(),
                                       "--first-order", "-o", (folder / "chart.gltf").string()});
    EXPECT_EQ(chart.status, 1);
    EXPECT_TRUE(has(chart.err, "has no scene, only a chart")) << chart.err;
}

TEST(Export, ACertificateNeedsItsFields) {
    const fs::path folder = fresh_folder("export-dcc");
    const std::string project = shipped_project("lsm-network.covaria").string(),
                      file = (folder / "certificate.xml").string();
    const std::vector<std::string> arguments{"export",     project, "--as", "dcc", "--first-order",
                                             "--analysis", "paper", "-o",   file};
    const Outcome missing = run_program(arguments);
    EXPECT_EQ(missing.status, 1);
    for (const char* words : {"/certificate/laboratory/name: 'Laboratory' must be stated (ISO/IEC 17025",
                              "/certificate/laboratory/country: 'Country of the laboratory' must be stated",
                              "nothing was written"})
        EXPECT_TRUE(has(missing.err, words)) << words << "\n" << missing.err;
    EXPECT_FALSE(fs::exists(file));
    const Outcome done = run_program(with_certificate(arguments));
    ASSERT_EQ(done.status, 0) << done.err;
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(read_text(file).c_str()));
    EXPECT_STREQ(document.select_node("//dcc:uniqueIdentifier").node().child_value(), "K-7");
    EXPECT_TRUE(document.select_node("//si:covarianceMatrix"));
    EXPECT_EQ(run_program({"import", file, "-o", (folder / "back.covaria").string()}).status, 0);
}

TEST(Export, NamesWritersAndWhatTheyCannotWrite) {
    const fs::path folder = fresh_folder("export-wrong");
    const std::string gauge = (fs::path(COVARIA_SOURCE_DIR) / "projects/gum/h1-end-gauge.covaria").string(),
                      file = (folder / "x").string();
    const Outcome mistyped = run_program({"export", gauge, "--as", "point", "-o", file});
    EXPECT_EQ(mistyped.status, 2);
    EXPECT_TRUE(has(mistyped.err, "did you mean 'points'")) << mistyped.err;
    const Outcome none = run_program({"export", gauge, "--as", "points", "--first-order", "-o", file});
    EXPECT_EQ(none.status, 1);
    EXPECT_TRUE(has(none.err, "there are no points to write")) << none.err;
    EXPECT_EQ(run_program({"export", gauge, "--as", "points"}).status, 2);
    const Outcome help = run_program({"export", "--help"});
    for (const char* words : {"points", "dcc", "Digital Calibration Certificate 3.2.1"})
        EXPECT_TRUE(has(help.out, words)) << help.out;
    EXPECT_FALSE(fs::exists(file));
}

}  // namespace

}  // namespace export_test
