// CSV text to rows and rows to tables: the variants that people and programs write.
#include <gtest/gtest.h>

#include "core/project/csv_table.h"
#include "tests/core/project/test_kinds.h"

namespace covaria::test::csv_test {

namespace {

using Cells = std::vector<std::string>;

FieldSpec readings_field() {
    FieldSpec field{"readings", "readings", FieldKind::table, "What was read."};
    field.columns = {{"point", "Name of the point", FieldKind::text},
                     {"value", "reading", FieldKind::number, Unit::of("mm")},
                     {"count", "number", FieldKind::integer, {}, {}, true},
                     {"used", "used", FieldKind::flag, {}, {}, true},
                     {"role", "role", FieldKind::choice, {}, {}, true, {{"nest", "a nest"}}}};
    return field;
}

std::vector<Cells> rows_of(const std::string& text) {
    const auto csv = read_csv(text);
    std::vector<Cells> rows;
    if (!csv) return {{"error", csv.error().message.english(), std::to_string(csv.error().line)}};
    for (const CsvRow& row : csv->rows) rows.push_back(row.cells);
    return rows;
}

CsvTable table_of(const std::string& text) {
    const auto csv = read_csv(text);
    return csv ? table_from_csv(*csv, readings_field()) : CsvTable{};
}

// The whole project, its readings in `csv`; `more` follows the file's name.
LoadedProject with_csv(const std::string& csv, const std::string& name = "readings.csv",
                       const std::string& more = {}) {
    const auto folder = fresh_folder("csv");
    put_bytes(folder / "readings.csv", csv);
    put_bytes(folder / "p.covaria",
              changed("{\n          \"columns\": [\"point\", \"value [mm]\"],\n          "
                      "\"rows\": []\n        }",
                      "{\"csv\": \"" + name + "\"" + more + "}"));
    return load_project(folder / "p.covaria");
}

}  // namespace

TEST(CsvReader, SeparatorsAreFound) {
    const std::vector<Cells> expected{{"a", "b"}, {"1", "2"}};
    EXPECT_EQ(rows_of("a,b\n1,2\n"), expected);
    EXPECT_EQ(rows_of("a;b\n1;2\n"), expected);
    EXPECT_EQ(rows_of("a\tb\n1\t2\n"), expected);
    EXPECT_EQ(rows_of("\"a;b\",c\n1,2"), (std::vector<Cells>{{"a;b", "c"}, {"1", "2"}}));
    EXPECT_EQ(rows_of("# x;y\na,b\n1,2"), expected);
}

TEST(CsvReader, LineEndsMarksCommentsAndSpaces) {
    const std::vector<Cells> expected{{"a", "b"}, {"1", "2"}};
    EXPECT_EQ(rows_of("\xEF\xBB\xBF"
                      "a,b\r\n1,2\r\n"),
              expected);
    EXPECT_EQ(rows_of("# heading\n\n a , b \n\n# remark, with comma\n1,2\n,,\n"), expected);
    EXPECT_EQ(rows_of("a\tb\n\t2\n"), (std::vector<Cells>{{"a", "b"}, {"", "2"}}));
    EXPECT_EQ(rows_of(""), std::vector<Cells>{});
}

TEST(CsvReader, QuotedCells) {
    EXPECT_EQ(rows_of("\"a \"\"x\"\"\",\"two\nlines\", \"c,d\" \n1,2,3\n"),
              (std::vector<Cells>{{"a \"x\"", "two\nlines", "c,d"}, {"1", "2", "3"}}));
    EXPECT_EQ(rows_of("a,b\n\"1,2\n3\n"),
              (std::vector<Cells>{{"error", "the quote that begins here is not closed", "2"}}));
    EXPECT_EQ(rows_of("a,b\n\"1\"x,2\n")[0][2], "2");
    EXPECT_NE(rows_of("a,b\n\"1\"x,2\n")[0][1].find("text follows the closing quote"), std::string::npos);
}

TEST(CsvReader, LinesAreCountedThroughQuotesAndComments) {
    const auto csv = read_csv("# c\na,b\n\"x\ny\",1\nz,2\n");
    ASSERT_TRUE(csv);
    ASSERT_EQ(csv->rows.size(), 3u);
    EXPECT_EQ(csv->rows[0].line, 2);
    EXPECT_EQ(csv->rows[1].line, 3);
    EXPECT_EQ(csv->rows[2].line, 5);
}

TEST(CsvReader, OtherEncodingsAreNamed) {
    EXPECT_NE(rows_of("\xFF\xFE"
                      "a")[0][1]
                  .find("UTF-16"),
              std::string::npos);
    EXPECT_NE(rows_of("x [\xB5m]\n1")[0][1].find("not encoded as UTF-8"), std::string::npos);
}

TEST(CsvNumber, AsPeopleWriteThem) {
    EXPECT_EQ(csv_number("1.5", false), 1.5);
    EXPECT_EQ(csv_number("+1.5e-3", false), 1.5e-3);
    EXPECT_EQ(csv_number("-.5", false), -0.5);
    EXPECT_EQ(csv_number("\xE2\x88\x92"
                         "2",
                         false),
              -2.0);
    EXPECT_EQ(csv_number("1,5", true), 1.5);
    for (const char* text :
         {"1,5", "", "-", "nan", "inf", "-inf", "1e999", "1 2", "0x10", "12mm", "+-1", "1,000.5"})
        EXPECT_FALSE(csv_number(text, false)) << text;
    EXPECT_FALSE(csv_number("1,000.5", true));
    EXPECT_FALSE(csv_number("1,000,5", true));
}

TEST(CsvTable, KeysTitlesUnitsAndOrder) {
    const CsvTable read = table_of("reading [um];Name of the point;used;role\n1,5;b1;yes;a nest\n-2;b2;0;\n");
    ASSERT_TRUE(read.problems.empty()) << read.problems.items()[0].message.english();
    EXPECT_EQ(read.table.units[1], Unit::of("um"));
    ASSERT_EQ(read.table.rows.size(), 2u);
    EXPECT_EQ(read.table.rows[0],
              (std::vector<SetupCell>{std::string("b1"), 1.5, std::monostate{}, true, std::string("nest")}));
    EXPECT_EQ(read.table.rows[1],
              (std::vector<SetupCell>{std::string("b2"), -2.0, std::monostate{}, false, std::monostate{}}));
    EXPECT_EQ(read.lines, (std::vector<int>{2, 3}));
}

TEST(CsvTable, SeparatorsBehindTheLastColumn) {
    const CsvTable read = table_of("point,value [mm],,\nb1,1,,\n");
    EXPECT_TRUE(read.problems.empty());
    EXPECT_EQ(read.table.rows.size(), 1u);
}

TEST(CsvTable, ANumberOfAnotherLanguageIsSaidHowToWrite) {
    const CsvTable points = table_of("point,value [mm]\nb1,\"1,5\"\n");
    EXPECT_EQ(points.problems.items().at(0).message.english(),
              "column 'value': '1,5' is not a number; in this file write 1.5");
}

TEST(CsvTable, ProblemsNameLineAndColumn) {
    const CsvTable read = table_of("point,value [mm],used\nb1,wide,true\nb2,1\n# remark\nb3,1,perhaps\n");
    EXPECT_EQ(problem_with(read.problems, "column 'value': 'wide' is not a number").line, 2);
    EXPECT_EQ(problem_with(read.problems, "this row has 2 cells; there are 3 columns").line, 3);
    EXPECT_EQ(problem_with(read.problems, "column 'used': 'perhaps' is neither true nor false").line, 5);
    EXPECT_EQ(problem_with(table_of("point,valeu [mm]\n").problems, "did you mean 'value'").line, 1);
    EXPECT_EQ(problem_with(table_of("\n\npoint,value\n").problems, "its unit is missing").line, 3);
    EXPECT_EQ(problem_with(table_of("").problems, "no row with the names").severity, Severity::error);
}

TEST(CsvTable, BlocksWithoutHeader) {
    const FieldSpec field = readings_field();
    const auto csv = read_csv("b1\t1,5\nb2\t2,5\n");
    ASSERT_TRUE(csv);
    EXPECT_FALSE(has_header(*csv, field));
    EXPECT_TRUE(has_header(*read_csv("point\tvalue [mm]\n"), field));
    const std::vector<Unit> units{{}, Unit::of("um"), {}, {}, {}};
    const CsvTable read = table_from_csv_rows(*csv, field, units);
    ASSERT_EQ(read.table.rows.size(), 2u);
    EXPECT_EQ(std::get<double>(read.table.rows[1][1]), 2.5);
    EXPECT_EQ(read.table.units, units);
}

TEST(CsvFile, RowsAreReadAndTheNameIsSaved) {
    const LoadedProject loaded = with_csv("point,value [um]\nb1,1.5\n");
    ASSERT_TRUE(loaded.problems.empty()) << loaded.problems.items()[0].message.english();
    const SetupTable& table = std::get<SetupTable>(loaded.project.assets[0].setup.values.at("readings"));
    EXPECT_EQ(std::get<double>(table.rows.at(0)[1]), 1.5);
    EXPECT_NE(project_text(loaded.project).find("\"readings\": {\"csv\": \"readings.csv\"}\n"),
              std::string::npos);
}

TEST(CsvFile, ProblemsNameTheCsvFileAndLine) {
    const LoadedProject wrong = with_csv("point,value [um]\nb1,1.5\nb2,x\n");
    const Problem cell = problem_with(wrong.problems, "column 'value': 'x' is not a number");
    EXPECT_EQ(std::filesystem::path(cell.file).filename(), "readings.csv");
    EXPECT_EQ(cell.line, 3);
    EXPECT_EQ(cell.path, "/assets/0/setup/readings");
    const LoadedProject empty = with_csv("point,value [um]\n# remark\nb1,\n");
    const Problem missing = problem_with(empty.problems, "'reading in row 1 of readings' is empty");
    EXPECT_EQ(std::filesystem::path(missing.file).filename(), "readings.csv");
    EXPECT_EQ(missing.line, 3);
    EXPECT_EQ(missing.path, "/assets/0/setup/readings/rows/0/value");
}

TEST(CsvFile, ColumnsMayHaveOtherNames) {
    const std::string columns =
        ", \"columns\": {\"Pt.\": \"point\", \"r_um\": \"value [um]\", \"operator\": \"\"}";
    const LoadedProject loaded =
        with_csv("operator,r_um,Pt.\nAnna,1.5,b1\nBen,2.5,b2\n", "readings.csv", columns);
    ASSERT_TRUE(loaded.problems.empty()) << loaded.problems.items()[0].message.english();
    const SetupTable& table = std::get<SetupTable>(loaded.project.assets[0].setup.values.at("readings"));
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(std::get<std::string>(table.rows[1][0]), "b2");
    EXPECT_EQ(std::get<double>(table.rows[1][1]), 2.5);
    EXPECT_EQ(table.units[1], Unit::of("um"));
    EXPECT_NE(project_text(loaded.project).find("\"readings\": {\"csv\": \"readings.csv\"" + columns + "}\n"),
              std::string::npos);
}

TEST(CsvFile, OtherNamesMustBeThoseOfColumns) {
    const std::string csv = "Pt.,r_um\nb1,1.5\n";
    const auto refused = [&](const std::string& columns) {
        return with_csv(csv, "readings.csv", ", \"columns\": " + columns).problems;
    };
    EXPECT_EQ(problem_with(refused("{\"Pt\": \"point\", \"r_um\": \"value [um]\"}"),
                           "the file has no column 'Pt' (did you mean 'Pt.'?)")
                  .line,
              1);
    problem_with(refused("{\"Pt.\": \"point\", \"r_um\": \"reading [N]\"}"), "N");
    problem_with(refused("{\"Pt.\": \"point\", \"r_um\": \"\"}"),
                 "column 'value [mm]' of 'readings' is missing");
    EXPECT_EQ(problem_with(refused("[1]"), "must be an object in braces").path,
              "/assets/0/setup/readings/columns");
    problem_with(refused("{\"Pt.\": 1}"), "'Pt.' must stand for a column");
}

TEST(CsvFile, MustLieInTheFolderOfTheProject) {
    for (const char* name : {"../readings.csv", "/etc/passwd", "sub/../../x.csv", "", "."}) {
        const LoadedProject loaded = with_csv("point,value [um]\n", name);
        EXPECT_TRUE(loaded.problems.has_errors()) << name;
    }
    EXPECT_EQ(problem_with(with_csv("", "../readings.csv").problems, "relative to the project's folder").path,
              "/assets/0/setup/readings/csv");
    EXPECT_TRUE(with_csv("point,value [um]\n", "./sub/../readings.csv").problems.empty());
}

TEST(CsvFile, MissingFileNamesWhereItWasLookedFor) {
    const LoadedProject loaded = with_csv("", "none.csv");
    const Problem problem = problem_with(loaded.problems, "does not exist: looked for '");
    EXPECT_NE(problem.message.english().find("/none.csv'"), std::string::npos) << problem.message.english();
    EXPECT_EQ(problem.line, 30);
    EXPECT_EQ(std::filesystem::path(problem.file).filename(), "p.covaria");
}

TEST(CsvTable, MoreRowsThanMemoryIsMeantForAreRefusedBeforeAnyIsKept) {
    const FieldSpec field = readings_field();
    EXPECT_EQ(too_many_rows(field, std::string(500'000, '\n')), "");
    EXPECT_EQ(too_many_rows(field, std::string(20'000, '\n') + std::string(100'000'000, 'x')), "");
    EXPECT_NE(too_many_rows(field, std::string(200'000, '\n') + std::string(100'000'000, 'x')), "");
    std::string csv = "point,value\n";
    for (int i = 0; i < 1'100'000; ++i) csv += "p,1\n";
    const LoadedProject loaded = with_csv(csv);
    const Problem problem =
        problem_with(loaded.problems, "it has 1100002 lines, and there is memory for about ");
    EXPECT_NE(problem.file.find("readings.csv"), std::string::npos) << problem.file;
    EXPECT_EQ(problem.line, 1);
}

}  // namespace covaria::test::csv_test
