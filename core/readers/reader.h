// A reader: the way in which files of others are recognised, and what is proposed of their content.
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
#include "core/readers/neighbours.h"

namespace covaria {

enum class Recognition {
    no,
    possible,  ///< the bytes can be read so, and as something else
    certain    ///< a signature that no other files have
};

/// Statements of people about a file, because its bytes do not make them.
struct ReadChoice {
    std::string file_name = {};            ///< name without folders
    std::optional<Unit> length_unit = {};  ///< unit of coordinates that bear none; empty: mm
    /// Units of other figures that bear none, by the keys of `UnstatedUnit`.
    std::map<std::string, Unit> units = {};
    std::vector<std::string> columns = {};  ///< meaning of each column of a table; empty: found
    std::string sheet = {};                 ///< sheet of a workbook; empty: the one with a budget
    bool chosen = false;                    ///< whether the reader was named: what it stands for is stated
    /// Cells of a workbook, as they are to be read: "D3" -> "mm".
    std::map<std::string, std::string> cells = {};
    std::set<int> rows_left_out = {};  ///< numbers of rows of a workbook
    UrdfChoice robot = {};             ///< for a robot: its tip, joints that it does not have
    Neighbours beside = {};            ///< files beside it, which it may name
};

/// Something of the file that is not taken over.
struct LeftOut {
    int line = 0;  ///< line from 1; 0: all of the file
    Message what;
};

/// A unit that the file does not state.
struct UnstatedUnit {
    std::string key, title;  ///< a key such as "angles"; the name of a quantity
    Unit taken = {};
};

/// A result as the file itself states it, which the analysis made of the file is held against.
struct StatedOutcome {
    std::string analysis = {}, symbol = {};
    /// Figures in `unit`; u in its interval.
    std::optional<double> value = {}, u = {}, expanded = {}, k = {};
    Unit unit = {};
    /// Whether u is the root of the sum of squares of the contributions that the file states.
    bool from_contributions = false;
};

/// The entries that a file may become in a project. Ids are unique among the proposals only.
struct Proposals {
    std::string title = {};
    std::vector<AssetEntry> assets = {};
    std::vector<AnalysisEntry> analyses = {};
    std::vector<Message> found = {};          ///< sentences on what was found, and how it is understood
    std::vector<LeftOut> left_out = {};       ///< remarks, at most `most_left_out`
    std::size_t left_out_beyond = 0;          ///< number of further remarks
    std::vector<UnstatedUnit> unstated = {};  ///< units that people may state
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
        std::string key, title;  ///< "u_x" and "standard uncertainty of x"
    };
    /// All rows, of a file of points the first ones; headers too.
    std::vector<std::vector<std::string>> rows = {};
    std::vector<std::string> columns = {};  ///< key of the meaning of each column; empty: not known
    std::vector<Word> words = {};           ///< words for the meaning of a column
    std::vector<std::string> sheets = {};   ///< names of the sheets of a workbook
    std::string sheet = {};                 ///< name of the sheet that is shown
    std::string unknown = "-";              ///< statement of a column that nothing was said about
    /// The numbers of the rows of a workbook, and the letters of its columns; its cells can be mended and its
    /// rows left out (`ReadChoice::cells`, `rows_left_out`).
    std::vector<int> row_numbers = {};
    std::vector<std::string> letters = {};

    static constexpr std::size_t most_rows = 30;
};

struct Reader {
    std::string name;     ///< name as typed: "dcc"
    std::string title;    ///< title for people: "Digital Calibration Certificate"
    std::string pattern;  ///< pattern of file names: "*.xml"
    std::string takes;    ///< sentence on what is made of which contents
    Recognition (*recognise)(std::string_view beginning, const std::string& file_name);
    /// Reads a file. Error with `line` ("column 7: " at the front of its message where it is known);
    /// Error{usage}: people have to state something first, and the message says what.
    Result<Proposals> (*read)(const std::string& text, const ReadChoice& choice);
    /// The table that `ReadChoice::columns` may be stated for; null where the reader has none.
    Result<SourceTable> (*table)(const std::string& text, const ReadChoice& choice) = nullptr;
    bool mends_cells = false;  ///< whether it takes `ReadChoice::cells` and `rows_left_out`
};

}  // namespace covaria
