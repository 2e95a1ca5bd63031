#include "core/base/own_names.h"

#include <set>

namespace covaria {
namespace {

std::set<std::string>& own() {
    static std::set<std::string> names;
    return names;
}

}  // namespace

detail::OwnName::OwnName(const KnownWords& words) : english(words.english) {
    own().insert(words.english);
}

Message said_name(const std::string& name) {
    return own().contains(name) ? Message::declared(name) : Message(name);
}

}  // namespace covaria
