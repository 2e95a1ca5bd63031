#include "core/project/json_fields.h"

namespace covaria {

void JsonValue<std::array<double, 3>>::read(ObjectReader& reader, const std::string& key, bool required,
                                            std::array<double, 3>& member) {
    const Json* list = reader.list(key, required);
    const auto is_number = [](const Json& item) { return item.is_number(); };
    if (!list) return;
    if (list->size() != 3 || !std::all_of(list->begin(), list->end(), is_number))
        return reader.problems().error(reader.path_of(key), tell<"'%1' must be three numbers: x, y, z">(key));
    for (std::size_t i = 0; i < 3; ++i) member[i] = (*list)[i].get<double>();
}

void JsonValue<std::array<double, 3>>::write(JsonWriter& out, const std::array<double, 3>& member) {
    out.begin_list(JsonWriter::Style::one_line);
    for (const double coordinate : member) out.finite_number(coordinate);
    out.end();
}

void JsonValue<std::vector<std::string>>::read(ObjectReader& reader, const std::string& key, bool required,
                                               std::vector<std::string>& member) {
    const Json* list = reader.list(key, required);
    for (std::size_t i = 0; list && i < list->size(); ++i) {
        const Json& item = (*list)[i];
        if (item.is_string())
            member.push_back(item.get<std::string>());
        else
            reader.problems().error(reader.path_of(key) + "/" + std::to_string(i),
                                    tell<"a text is needed here, not %1">(json_words(item)));
    }
}

void JsonValue<std::vector<std::string>>::write(JsonWriter& out, const std::vector<std::string>& member) {
    out.begin_list(JsonWriter::Style::one_line);
    for (const std::string& text : member) out.text(text);
    out.end();
}

}  // namespace covaria
