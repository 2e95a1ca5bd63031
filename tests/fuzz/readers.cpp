// Files of others, changed at random, read by each reader that they may be meant for.
#include "core/readers/readers.h"

#include <algorithm>

#include "core/base/guarded.h"
#include "core/made/made_project.h"
#include "core/readers/zip_parts.h"
#include "tests/core/readers/zipped.h"
#include "tests/fuzz/fuzz.h"

namespace covaria::fuzz {

namespace {

namespace fs = std::filesystem;

class ReaderFiles : public Kind {
public:
    ReaderFiles() {
        for (const auto& entry : fs::directory_iterator(fs::path(COVARIA_SOURCE_DIR) / "tests/data/readers"))
            names_.push_back(entry.path().string());
        std::sort(names_.begin(), names_.end());
        for (const std::string& name : names_) texts_.push_back(file_text(name));
        stations_ = "\n1 A 0 0 10 0.001 0.001 0.001\n0 B 100 0 10\n2 C 60 80 12 0 0.001 0\n";
    }

    std::string make(Noise& noise) override {
        const std::size_t file = noise.below(texts_.size());
        std::string text = damaged(texts_[file], noise);
        if (noise.chance(4)) text = damaged(text, noise);
        return std::string(1, static_cast<char>(noise.below(200))) +
               text;  // the first byte chooses the reader
    }

    Outcome run(const std::string& input) override {
        if (input.empty()) return {};
        const std::string text = input.substr(1);
        const auto number = static_cast<unsigned char>(input[0]);
        const auto& readers = reader_registry();
        const auto found = reader_for(text, number % 2 == 0   ? "file.cor"
                                            : number % 3 == 0 ? "file.obs"
                                                              : "file.comp");
        const Reader& reader =
            found && number % 4 != 0 ? **found : readers[static_cast<std::size_t>(number) % readers.size()];
        ReadChoice choice{.file_name = number % 3 == 0 ? "file.obs" : "file.cor"};
        choice.chosen = number % 2 == 0;
        if (number % 3 == 0) {
            choice.beside.names = {"file.cor", "file.comp"};
            choice.beside.read = [&](const std::string& name) -> Result<std::string> {
                return name.ends_with(".cor") ? text.substr(0, text.size() / 2) + stations_ : text;
            };
        }
        if (number % 5 == 0) choice.columns = {"group", "name", "x", "y", "z", "u"};
        const auto read = guarded([&] { return reader.read(text, choice); });
        if (!read) return {false, false, "thrown: " + read.error().message.english()};
        if (!*read) return refused((*read).error());
        return accepted(**read);
    }

private:
    /// Damages a text, or a part within a zip file: its checksums would refuse damage of the whole.
    std::string damaged(const std::string& text, Noise& noise) const {
        auto zip = text.starts_with("PK") && !noise.chance(8) ? ZipParts::open(text, 16'000'000)
                                                              : Result<ZipParts>(fail(Error{}));
        if (!zip) return damaged_text(text, words_, noise);
        readers_test::Parts parts;
        for (const char* name :
             {"[Content_Types].xml", "xl/workbook.xml", "xl/_rels/workbook.xml.rels",
              "xl/worksheets/sheet1.xml", "xl/worksheets/sheet2.xml", "xl/sharedStrings.xml"})
            if (const auto part = zip->read(name)) parts[name] = *part;
        if (parts.empty()) return damaged_text(text, words_, noise);
        auto part = parts.begin();
        std::advance(part, static_cast<std::ptrdiff_t>(noise.below(parts.size())));
        if (noise.chance(2) && parts.contains("xl/worksheets/sheet2.xml"))
            part = parts.find("xl/worksheets/sheet2.xml");
        part->second = damaged_text(part->second, words_, noise);
        return readers_test::zipped(parts);
    }

    static Outcome refused(const Error& error) {
        if (error.message.english().empty()) return {false, false, "an error without words"};
        // An error about the whole file (nothing in it, a choice to state first) has no line.
        const bool whole =
            error.code == ErrorCode::usage || error.message.english().starts_with("the file has ");
        return {false, false,
                whole || error.line > 0 ? "" : "an error without a line: " + error.message.english()};
    }

    /// A proposal may contradict itself at a place, but must never show a defect of the program.
    static Outcome accepted(const Proposals& proposals) {
        Project project;
        add_to_project(project, proposals);
        const Problems problems = MadeProject::make(project)->problems();
        for (const Problem& problem : problems.items())
            if (problem.path.empty() ||
                problem.message.english().find("a defect of the program") != std::string::npos)
                return {true, false, problem.path + ": " + problem.message.english()};
        return {true, !problems.has_errors(), {}};
    }

    std::vector<std::string> names_, texts_;
    std::string stations_;  ///< coordinates beside the file
    const std::vector<std::string> words_{"<",
                                          ">",
                                          "/>",
                                          "\"",
                                          ",",
                                          ";",
                                          " ",
                                          "\t",
                                          "\n",
                                          "\r",
                                          "-",
                                          "1e99",
                                          "nan",
                                          "1e999",
                                          "#",
                                          "//",
                                          "*",
                                          "@",
                                          "&lt;",
                                          "&a;",
                                          "\\",
                                          "{2}",
                                          "\\per",
                                          "<!--",
                                          "[m]",
                                          "<!DOCTYPE a>",
                                          "0 0 0",
                                          "9 9 9 9",
                                          "11",
                                          "*a",
                                          "&a ",
                                          ": ",
                                          "- ",
                                          "[",
                                          "{",
                                          "=",
                                          "_",
                                          "√3",
                                          "<f>",
                                          "<v>",
                                          "\xFF",
                                          "\xEF\xBB\xBF",
                                          std::string(1, '\0')};
};

}  // namespace

std::unique_ptr<Kind> reader_kind() {
    return std::make_unique<ReaderFiles>();
}

}  // namespace covaria::fuzz
