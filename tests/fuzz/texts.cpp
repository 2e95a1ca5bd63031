// CSV tables read by the schemas of all kinds, robots from URDF, meshes from STL.
#include <bit>

#include "core/base/guarded.h"
#include "core/kinds/context/stl.h"
#include "core/kinds/registries.h"
#include "core/kinds/robot/urdf.h"
#include "core/project/csv_table.h"
#include "tests/fuzz/fuzz.h"
#include "tests/stl_files.h"

namespace covaria::fuzz {

namespace {

class Csv : public Kind {
public:
    Csv() {
        for (const AssetDescriptor& kind : asset_registry()) add(kind.schema);
        for (const ModelDescriptor& model : model_registry()) add(model.schema);
    }

    std::string make(Noise& noise) override {
        const std::size_t table = noise.below(tables_.size());
        const char separator = noise.pick(std::string_view(",;\t"));
        std::string text;
        for (std::size_t row = noise.below(5) + 1; row > 0; --row)
            text += line(table, separator, text.empty(), noise);
        if (noise.chance(2)) text = damaged_text(text, words_, noise);
        return std::string(1, static_cast<char>(table)) + text;  // the first byte chooses the schema
    }

    Outcome run(const std::string& input) override {
        if (input.empty()) return {};
        const FieldSpec& field = tables_[static_cast<unsigned char>(input[0]) % tables_.size()];
        const std::string_view text = std::string_view(input).substr(1);
        const auto csv = read_csv(text);
        if (!csv)
            return {false, false, csv.error().line > 0 ? "" : "no line: " + csv.error().message.english()};
        const CsvTable table = table_from_csv(*csv, field);
        for (const Problem& problem : table.problems.items())
            if (problem.line <= 0 || problem.message.english().empty())
                return {false, false, "no line: " + problem.message.english()};
        if (table.lines.size() != table.table.rows.size()) return {false, false, "rows without lines"};
        for (const auto& row : table.table.rows)
            if (row.size() != field.columns.size()) return {false, false, "a row of another length"};
        return {!table.problems.has_errors(), false, {}};
    }

private:
    void add(const SetupSchema& schema) {
        for (const FieldSpec& field : schema.fields())
            if (field.kind == FieldKind::table && tables_.size() < 250) tables_.push_back(field);
    }

    std::string line(std::size_t table, char separator, bool head, Noise& noise) {
        std::string text;
        for (const ColumnSpec& column : tables_[table].columns) {
            if (!text.empty()) text += separator;
            if (head)
                text += column.key + (column.unit == Unit{} ? "" : " [" + column.unit.text() + "]");
            else
                text += noise.pick(cells_);
        }
        return text + "\n";
    }

    std::vector<FieldSpec> tables_;
    const std::vector<std::string> cells_{"1",
                                          "-2.5",
                                          "1e3",
                                          "1,5",
                                          "",
                                          "abc",
                                          "\"q\"\"q\"",
                                          "true",
                                          "no",
                                          "\xE2\x88\x92"
                                          "3",
                                          "1e400",
                                          "nan",
                                          " 7 ",
                                          "=1+1"};
    const std::vector<std::string> words_{
        "\"", ",", ";", "\t", "\n", "\r\n", "#", "\xEF\xBB\xBF", "\xFF\xFE", "[mm]", std::string(1, '\0')};
};

class Urdf : public Kind {
public:
    std::string make(Noise& noise) override {
        std::string text = "<robot name=\"r\">\n";
        const std::size_t joints = noise.below(9);
        for (std::size_t i = 0; i <= joints; ++i) text += "<link name=\"" + link(i, noise) + "\"/>\n";
        for (std::size_t i = 0; i < joints; ++i) text += joint(i, noise);
        text += "</robot>\n";
        return noise.chance(2) ? damaged_text(text, words_, noise) : text;
    }

    Outcome run(const std::string& input) override {
        const auto imported = guarded([&] { return import_urdf(input); });
        if (!imported) return {false, false, "thrown: " + imported.error().message.english()};
        if (!*imported && ((*imported).error().message.english().empty() || (*imported).error().line <= 0))
            return {false, false, "an error without words or line: " + (*imported).error().message.english()};
        return {imported->has_value(), false, {}};
    }

private:
    std::string link(std::size_t i, Noise& noise) {
        return "l" + std::to_string(noise.chance(60) ? noise.below(9) : i);
    }
    /// Mostly what a robot may have: inputs that are refused at the first joint test nothing behind it.
    std::string triple(Noise& noise) {
        const auto& figures = noise.chance(25) ? wild_ : figures_;
        const auto figure = [&] { return noise.pick(figures); };
        return figure() + " " + figure() + " " + figure();
    }
    std::string joint(std::size_t i, Noise& noise) {
        const std::string& type = noise.pick(noise.chance(25) ? other_types_ : types_);
        const std::string axis =
            noise.chance(10) ? triple(noise) : noise.pick(noise.chance(25) ? wild_axes_ : axes_);
        std::string more;
        if (noise.chance(3))
            more += "<limit lower=\"" + noise.pick(figures_) + "\" upper=\"" + noise.pick(figures_) + "\"/>";
        if (noise.chance(30)) more += "<mimic joint=\"j" + std::to_string(noise.below(9)) + "\"/>";
        return "<joint name=\"j" + std::to_string(i) + "\" type=\"" + type + "\">\n<parent link=\"" +
               link(i, noise) + "\"/><child link=\"" + link(i + 1, noise) + "\"/>\n<origin xyz=\"" +
               triple(noise) + "\" rpy=\"" + triple(noise) + "\"/><axis xyz=\"" + axis + "\"/>" + more +
               "\n</joint>\n";
    }

    const std::vector<std::string> figures_{
        "0", "0", "0.1", "-0.3", "1.5707963267948966", "3.141592653589793"};
    const std::vector<std::string> wild_{"0", "1e-12", "1e200", "nan", "x", "", "-1e9"};
    const std::vector<std::string> types_{"revolute", "revolute", "continuous", "fixed", "prismatic"};
    const std::vector<std::string> other_types_{"floating", "planar", ""};
    const std::vector<std::string> axes_{"0 0 1", "0 1 0", "1 0 0", "0 0 -1", "1 1 0", "0 0.6 0.8"};
    const std::vector<std::string> wild_axes_{"0 0 0", "1e-200 0 0", "1e200 0 1"};
    const std::vector<std::string> words_{"<",     ">",    "/",   "\"",  "<joint", "<mimic joint=\"j0\"/>",
                                          "&amp;", "<!--", "]]>", "nan", "1e999",  "\n"};
};

/// Both forms, with a few triangles.
class Stl : public Kind {
public:
    std::string make(Noise& noise) override {
        const std::size_t triangles = noise.below(4);
        std::string text = noise.chance(2) ? binary(triangles, noise) : ascii(triangles, noise);
        return noise.chance(4) ? text : damaged_text(std::move(text), words_, noise);
    }

    Outcome run(const std::string& input) override {
        const auto read = guarded([&] { return mesh_from_stl(input); });
        if (!read) return {false, false, "thrown: " + read.error().message.english()};
        if (!*read)
            return {false, false, (*read).error().message.english().empty() ? "an error without words" : ""};
        const TriangleMesh& mesh = **read;
        const bool right = mesh.triangles() > 0 && mesh.corners.size() % 9 == 0 &&
                           mesh.box.sizes().allFinite() && mesh.corners.size() <= input.size();
        return {true, false, right ? "" : "a mesh that is none"};
    }

private:
    std::string binary(std::size_t triangles, Noise& noise) {
        std::string header = noise.pick(headers_);
        header.resize(80, ' ');
        std::vector<test::StlTriangle> made(triangles);
        for (test::StlTriangle& triangle : made)
            for (float& coordinate : triangle)
                coordinate = noise.chance(40) ? std::bit_cast<float>(static_cast<std::uint32_t>(noise.next()))
                                              : static_cast<float>(noise.below(100));
        return test::binary_stl(made, header);
    }
    std::string ascii(std::size_t triangles, Noise& noise) {
        const auto corner = [&] {
            return noise.pick(figures_) + " " + noise.pick(figures_) + " " + noise.pick(figures_);
        };
        std::string text = "solid s\n";
        for (std::size_t i = 0; i < triangles; ++i) text += test::ascii_facet(corner(), corner(), corner());
        return text + "endsolid s\n";
    }

    const std::vector<std::string> headers_{"solid", "made", ""};
    const std::vector<std::string> figures_{"0", "1", "-2.5", "1e3", "+4", "1e-400", "12.5", "7"};
    const std::vector<std::string> words_{"solid", "facet", "vertex", "endloop",  "nan",
                                          "1e999", "\n",    " ",      "endsolid", std::string(1, '\0')};
};

}  // namespace

std::unique_ptr<Kind> stl_kind() {
    return std::make_unique<Stl>();
}
std::unique_ptr<Kind> csv_kind() {
    return std::make_unique<Csv>();
}
std::unique_ptr<Kind> urdf_kind() {
    return std::make_unique<Urdf>();
}

}  // namespace covaria::fuzz
