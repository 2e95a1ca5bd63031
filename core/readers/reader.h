// A reader: by what a file of others is recognised, and what is proposed of its content.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/unit.h"
#include "core/kinds/robot/urdf.h"
#include "core/project/project.h"

namespace covaria {

enum class Recognition {
    no,
    possible,  ///< the bytes can be read so, and as something else
    certain    ///< a signature that nothing else has
};

/// What people say about a file, because its bytes do not.
struct ReadChoice {
    std::string file_name = {};              ///< without folders
    std::optional<Unit> length_unit = {};    ///< of coordinates that bear none; empty: mm
    std::map<std::string, Unit> units = {};  ///< of what else bears none, by the keys of `UnstatedUnit`
    std::vector<std::string> columns = {};   ///< what stands in each column of a table; empty: found
    std::string sheet = {};                  ///< of a workbook; empty: the one with a budget
    bool chosen = false;                     ///< the reader was named: what it stands for is stated
    std::map<std::string, std::string> cells = {};  ///< of a workbook, to be read so: "D3" -> "mm"
    std::set<int> rows_left_out = {};               ///< of a workbook
    UrdfChoice robot = {};                          ///< of a robot: its tip, joints that it does not have
};

/// Something of the file that is not taken over.
struct LeftOut {
    int line = 0;  ///< 1-based; 0: all of the file
    Message what;
};

/// A unit that the file does not state.
struct UnstatedUnit {
    std::string key, title;  ///< "angles"; the name of a quantity
    Unit taken = {};
};

/// A result as the file itself states it, which what is made of the file is held against.
struct StatedOutcome {
    std::string analysis = {}, symbol = {};
    std::optional<double> value = {}, u = {}, expanded = {}, k = {};  ///< in `unit`; u in its interval
    Unit unit = {};
    bool from_contributions = false;  ///< u is the root of the sum of squares of those that the file states
};

/// What a file may become in a project. Ids are unique among the proposals only.
struct Proposals {
    std::string title = {};
    std::vector<AssetEntry> assets = {};
    std::vector<AnalysisEntry> analyses = {};
    std::vector<Message> found = {};          ///< lines: what was found, and how it is understood
    std::vector<LeftOut> left_out = {};       ///< at most `most_left_out`
    std::size_t left_out_beyond = 0;          ///< how many more
    std::vector<UnstatedUnit> unstated = {};  ///< people may state them
    std::vector<StatedOutcome> outcomes = {};

    static constexpr std::size_t most_left_out = 1000;
    void leave_out(int line, Message what) {
        if (left_out.size() < most_left_out)
            left_out.push_back({line, std::move(what)});
        else
            ++left_out_beyond;
    }
};

/// A table of the file as it stands there, for people who state its columns.
struct SourceTable {
    struct Word {
        std::string key, title;  ///< "u_x", "standard uncertainty of x"
    };
    std::vector<std::vector<std::string>> rows = {};  ///< of a file of points the first ones; headers too
    std::vector<std::string> columns = {};  ///< keys of what each is read as; empty: it is not known
    std::vector<Word> words = {};           ///< what a column may be
    std::vector<std::string> sheets = {};   ///< of a workbook
    std::string sheet = {};                 ///< the one shown
    std::string unknown = "-";              ///< how a column that nothing was said about is stated
    /// Of a workbook: the rows' numbers, and the letters of the columns; its cells can be mended and its rows
    /// left out (`ReadChoice::cells`, `rows_left_out`).
    std::vector<int> row_numbers = {};
    std::vector<std::string> letters = {};

    static constexpr std::size_t most_rows = 30;
};

struct Reader {
    std::string name;     ///< as typed: "dcc"
    std::string title;    ///< "Digital Calibration Certificate"
    std::string pattern;  ///< of file names: "*.xml"
    std::string takes;    ///< what becomes what, in a sentence
    Recognition (*recognise)(std::string_view beginning, const std::string& file_name);
    /// Error with `line` ("column 7: " at the front of its message where it is known); Error{usage}: people
    /// have to state something first, the message says what.
    Result<Proposals> (*read)(const std::string& text, const ReadChoice& choice);
    /// The table that `ReadChoice::columns` may be stated for; null: the reader has none.
    Result<SourceTable> (*table)(const std::string& text, const ReadChoice& choice) = nullptr;
    bool mends_cells = false;  ///< takes `ReadChoice::cells` and `rows_left_out`
};

}  // namespace covaria
