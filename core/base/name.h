// Names of groups of quantities, contributors, things in space: the program gives some and people give
// others. Files and addresses have them in English; people read the program's own in their language.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/base/message.h"

namespace covaria {

/// Compared and filed by its letters. Who gave it travels with it: a pose that somebody called "flange" is
/// that in every language, though the program has a word "flange". Made from a text it is somebody's.
class Name : public std::string {
public:
    Name() = default;
    Name(std::string given) : std::string(std::move(given)) {}
    Name(std::string_view given) : std::string(given) {}
    Name(const char* given) : std::string(given) {}
    /// Given by the program, as far as the message has words of it.
    static Name of(const Message& message) {
        Name name(message.english());
        name.said_ = std::make_shared<const Message>(message);
        return name;
    }

    /// The name for people.
    Message said() const { return said_ && said_->english() == *this ? *said_ : Message(std::string(*this)); }

private:
    std::shared_ptr<const Message> said_;
};

/// own_name<"distances">(): a name that the program gives.
template <detail::Words name>
Name own_name() {
    return Name::of(tell<name>());
}

/// own_name<"joint %1">(3) or of a name that somebody gave: likewise.
template <detail::Words name>
Name own_name(const Message& part) {
    static_assert(name.placeholders() == 1);
    return Name::of(tell<name>(part));
}

/// The name for people; a name that has lost who gave it is refused by the compiler.
inline Message said_name(const Name& name) {
    return name.said();
}
Message said_name(const std::string& name) = delete;

}  // namespace covaria
