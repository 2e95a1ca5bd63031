// What a cell of a data table says, whether it was typed or is the program's.
#pragma once

#include <string>

#include "core/base/data_table.h"

namespace covaria::test {

inline std::string words_in(const TableCell& cell) {
    if (const auto* words = std::get_if<Message>(&cell)) return words->english();
    return std::get<std::string>(cell);
}

}  // namespace covaria::test
