#include "core/base/own_names.h"

#include <cstring>
#include <optional>
#include <set>
#include <string_view>

namespace covaria {
namespace {

std::set<const char*>& own() {
    static std::set<const char*> names;
    return names;
}

/// What stands for "%1" in the name; nothing if the words do not fit it.
std::optional<std::string> part_of(std::string_view name, std::string_view words) {
    const std::size_t at = words.find("%1");
    if (at == std::string_view::npos) return std::nullopt;
    const std::string_view before = words.substr(0, at), behind = words.substr(at + 2);
    if (name.size() <= before.size() + behind.size() || !name.starts_with(before) || !name.ends_with(behind))
        return std::nullopt;
    name.remove_prefix(before.size());
    name.remove_suffix(behind.size());
    return std::string(name);
}

}  // namespace

detail::OwnName::OwnName(const KnownWords& words) : english(words.english) {
    own().insert(words.english);
}

Message said_name(const std::string& name) {
    // "axis of %1" before "axis %1".
    const char* closest = nullptr;
    for (const char* words : own()) {
        if (name == words) return Message::declared(name);
        if (part_of(name, words) && (!closest || std::strlen(words) > std::strlen(closest))) closest = words;
    }
    return closest ? Message::of_words(closest, {said_name(*part_of(name, closest))}) : Message(name);
}

}  // namespace covaria
