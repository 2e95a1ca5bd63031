// Columns that people do not see, which say what a row of an evaluation is about and what may be chosen of
// it: a window leads there, and chooses.
#pragma once

#include <string>
#include <utility>

#include "core/text/table.h"

namespace covaria {

/// Place of a row's reading in the set-up, a JSON pointer relative to it: "/readings/rows/3".
inline constexpr const char* place_column = "place";
/// Key of a choice that a window offers to put into a cell of that row: "left-out".
inline constexpr const char* choice_column = "choice";
/// Place of that cell: "/readings/rows/3/use".
inline constexpr const char* cell_column = "place of the choice";
/// The words of that offer: "leave out".
inline constexpr const char* choice_words_column = "choice in words";

/// What is empty is not offered.
struct RowLink {
    std::string place = {}, cell = {}, choice = {};
    Message words = {};
};
/// Adds these columns, after all that people see; `link(row)` is a RowLink.
template <class Link>
void add_row_links(Table& table, Link link) {
    const auto add = [&](const char* key, auto get) {
        table.add(key, [link, get](std::size_t row) { return get(RowLink(link(row))); })
            .hide()
            .not_in_files();
    };
    const auto text = [](std::string said) { return said.empty() ? Cell() : Cell(std::move(said)); };
    add(place_column, [text](RowLink of) { return text(std::move(of.place)); });
    add(cell_column, [text](RowLink of) { return text(std::move(of.cell)); });
    add(choice_column, [text](RowLink of) { return text(std::move(of.choice)); });
    add(choice_words_column,
        [](RowLink of) { return of.words.empty() ? Cell() : Cell(std::move(of.words)); });
}

}  // namespace covaria
