// Words for a column of a table in messages.
#pragma once

#include "core/base/message.h"
#include "core/setup/setup_schema.h"

namespace covaria {

inline Message column_title(const ColumnSpec& column) {
    return Message::declared(column.title.empty() ? column.key : column.title);
}

}  // namespace covaria
