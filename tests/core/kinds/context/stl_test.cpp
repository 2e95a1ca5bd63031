// Reading STL: what is taken, what is refused, and where.
#include "core/kinds/context/stl.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/file_io.h"
#include "tests/fresh_folder.h"
#include "tests/stl_files.h"

namespace covaria::stl_test {
namespace {

const std::vector<test::StlTriangle> square = test::rectangle(0, 0, 2, 1, 5);

std::string refusal(const std::string& bytes, int line = 0) {
    const auto mesh = mesh_from_stl(bytes);
    if (mesh) return "accepted";
    EXPECT_EQ(mesh.error().line, line) << mesh.error().message.english();
    return mesh.error().message.english();
}

TEST(Stl, BinaryGivesItsTriangles) {
    const auto mesh = mesh_from_stl(test::binary_stl(square));
    ASSERT_TRUE(mesh) << mesh.error().message.english();
    ASSERT_EQ(mesh->triangles(), 2U);
    EXPECT_EQ(std::vector<float>(mesh->corners.begin(), mesh->corners.begin() + 9),
              (std::vector<float>{0, 0, 5, 2, 0, 5, 2, 1, 5}));
    EXPECT_EQ(mesh->box.min(), Eigen::Vector3f(0, 0, 5));
    EXPECT_EQ(mesh->box.max(), Eigen::Vector3f(2, 1, 5));
}

TEST(Stl, ABinaryFileMayBeginWithSolid) {
    const auto mesh = mesh_from_stl(test::binary_stl(square, "solid exported by a program"));
    ASSERT_TRUE(mesh) << mesh.error().message.english();
    EXPECT_EQ(mesh->triangles(), 2U);
}

TEST(Stl, AsciiGivesTheSame) {
    std::string text = "solid a name, facet and all\n" + test::ascii_facet("0 0 5", "2e0 +0 5", "2 1 5.0") +
                       "FACET NORMAL nan nan nan\r\nOUTER LOOP\r\nVERTEX 0 0 5\r\nVERTEX 2 1 5\r\n"
                       "VERTEX 1e-400 1 5\r\nENDLOOP\r\nENDFACET\r\nendsolid a name\n";
    const auto mesh = mesh_from_stl(text);
    ASSERT_TRUE(mesh) << mesh.error().message.english();
    EXPECT_EQ(mesh->corners, mesh_from_stl(test::binary_stl(square))->corners);
    text += "solid two\n" + test::ascii_facet("9 9 9", "8 8 9", "9 8 9") + "endsolid two";
    EXPECT_EQ(mesh_from_stl(text)->triangles(), 3U) << "several solids are one mesh";
}

TEST(Stl, WhatIsCutOffSaysWhere) {
    const std::string whole = test::binary_stl(square);
    EXPECT_EQ(refusal(whole.substr(0, whole.size() - 1)),
              "its header states 2 triangles; it ends in triangle 2");
    EXPECT_EQ(refusal(test::binary_stl(square, "short", 4'000'000'000)),
              "its header states 4000000000 triangles; it ends in triangle 3")
        << "nothing is reserved for what is not there";
    EXPECT_NE(refusal(test::binary_stl(square, "long", 1)).find("more behind them"), std::string::npos);
    EXPECT_EQ(refusal("solid s\n" + test::ascii_facet("0 0 0", "1 0 0", "0 1 0"), 9),
              "it ends in triangle 2: it has been cut off");
    EXPECT_EQ(refusal("solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0", 4),
              "it ends in triangle 1: it has been cut off");
    EXPECT_NE(refusal("").find("no STL file"), std::string::npos);
    EXPECT_NE(refusal("# vrml").find("no STL file"), std::string::npos);
}

TEST(Stl, CoordinatesAreFiniteNumbers) {
    auto wrong = square;
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                              std::numeric_limits<float>::max()}) {
        wrong[1][4] = value;
        EXPECT_EQ(refusal(test::binary_stl(wrong)),
                  "triangle 2 has a coordinate that is not a finite number");
    }
    for (const char* value : {"nan", "inf", "1e300", "-1e999"})
        EXPECT_NE(
            refusal("solid s\n" + test::ascii_facet("0 0 0", std::string("1 ") + value + " 0", "0 1 0"), 5)
                .find("triangle 1"),
            std::string::npos)
            << value;
    EXPECT_EQ(refusal("solid s\n" + test::ascii_facet("0 0 0", "1 one 0", "0 1 0"), 5),
              "triangle 1: 'one' is no number");
    EXPECT_EQ(refusal("solid s\nfacet normal 0 0 1\nouter ring\n", 3),
              "triangle 1: 'ring' stands where 'loop' should");
}

TEST(Stl, NothingAndTooMuchAreRefused) {
    EXPECT_EQ(refusal(test::binary_stl({})), "it has no triangles");
    EXPECT_EQ(refusal("solid nothing\nendsolid nothing\n"), "it has no triangles");
    std::string many(84 + 50 * (most_triangles + 1), '\0');
    std::string count;
    test::append_little_endian(count, most_triangles + 1);
    many.replace(80, 4, count);
    EXPECT_EQ(refusal(many), "it has more than 5000000 triangles: thin it out");
}

TEST(Stl, AFileIsReadOnceForEachState) {
    const auto file = test::fresh_folder("stl") / "part.stl";
    EXPECT_FALSE(mesh_of_file(file));
    ASSERT_TRUE(write_file_atomically(file, test::binary_stl(square)));
    const auto first = mesh_of_file(file);
    ASSERT_TRUE(first) << first.error().message.english();
    EXPECT_EQ(*first, *mesh_of_file(file)) << "the same object";
    ASSERT_TRUE(write_file_atomically(file, test::binary_stl({square[0]})));
    const auto second = mesh_of_file(file);
    ASSERT_TRUE(second);
    EXPECT_EQ((*second)->triangles(), 1U);
    EXPECT_EQ((*first)->triangles(), 2U) << "who has the old one keeps it";
}

}  // namespace
}  // namespace covaria::stl_test
