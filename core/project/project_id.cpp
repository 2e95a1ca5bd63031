#include "core/project/project_id.h"

#include <algorithm>

namespace covaria {

namespace {

bool is_letter_or_digit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

}  // namespace

bool is_project_id(const std::string& id) {
    return !id.empty() && std::all_of(id.begin(), id.end(),
                                      [](char c) { return is_letter_or_digit(c) || c == '-' || c == '_'; });
}

std::string project_id_of(const std::string& name, const std::string& otherwise, std::size_t longest) {
    std::string id;
    for (const char c : name) {
        if (is_letter_or_digit(c))
            id += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        else if (!id.empty() && id.back() != '-')
            id += '-';
        if (id.size() >= longest) break;
    }
    while (!id.empty() && id.back() == '-') id.pop_back();
    return id.empty() ? otherwise : id;
}

}  // namespace covaria
