// Lists of a project file, item by item.
#pragma once

#include <string>
#include <vector>

#include "core/project/json_writer.h"
#include "core/project/object_reader.h"

namespace covaria {

/// One item after the other, with its path.
template <class T, class Read>
void read_list(ObjectReader& reader, const std::string& key, std::vector<T>& out, Read read) {
    const Json* list = reader.list(key);
    for (std::size_t i = 0; list && i < list->size(); ++i)
        out.push_back(read((*list)[i], reader.path_of(key) + "/" + std::to_string(i), reader.problems()));
}

/// Nothing is written of an empty list.
template <class T, class Write>
void write_list(JsonWriter& out, const char* key, const std::vector<T>& items, Write write) {
    if (items.empty()) return;
    out.key(key);
    out.begin_list();
    for (const T& item : items) write(out, item);
    out.end();
}

}  // namespace covaria
