// The meanings of the columns of a table of points: stated by people, or by a line of headers.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/unit.h"

namespace covaria {

enum class PointColumnKind {
    unread,
    name,
    group,
    collection,
    coordinate,
    standard,  ///< standard uncertainty of a coordinate
    expanded   ///< expanded uncertainty, k = 2
};

struct PointColumn {
    PointColumnKind kind = PointColumnKind::unread;
    int axis = 0;                   ///< axis 0, 1, 2; -1: all three coordinates
    std::string word;               ///< word as it was written
    std::optional<Unit> unit = {};  ///< unit as it was written behind the word
};
using PointColumns = std::vector<PointColumn>;

/// The words that state columns, for messages: "name, group, collection, x, y, z, u_x ...".
std::string point_column_words();
/// Each word with its meaning.
std::vector<std::pair<std::string, std::string>> point_column_titles();
/// The word of a column, as it would be typed.
std::string word_of(const PointColumn& column);
/// The columns as they were typed: "name,x,y,z,u_x [um],-". Error{usage}: a word that is none, a column
/// stated twice, no x, y or z.
Result<PointColumns> stated_point_columns(const std::vector<std::string>& words);
/// The columns of headers as people write them ("Point Name", "X [mm]", "Ux", "sigma_x"); other headers are
/// not read. Error{usage}: two headers mean the same, a header may mean two things, no x, y or z.
Result<PointColumns> point_columns_of_headers(const std::vector<std::string>& headers);
/// Takes over a line of units below the headers ("", "mm", "mm", "mm"); false where it is none.
bool take_line_of_units(const std::vector<std::string>& cells, PointColumns& columns);
/// Whether the line has headers for x, y and z and no numbers.
bool are_point_headers(const std::vector<std::string>& cells);

}  // namespace covaria
