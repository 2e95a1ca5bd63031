// The members of a struct as a project file has them, each declared once: reading, writing and the places of
// problems follow; nobody writes a key twice.
#pragma once

#include <algorithm>
#include <any>
#include <array>
#include <concepts>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/project/json_writer.h"
#include "core/project/object_reader.h"
#include "core/project/setup_json.h"
#include "core/setup/message_text.h"

namespace covaria {

/// The form of a value of type M under a key. `read` leaves `member` as it is where nothing is given.
template <class M>
struct JsonValue;

template <>
struct JsonValue<std::string> {
    static void read(ObjectReader& reader, const std::string& key, bool required, std::string& member) {
        member = reader.text(key, required);
    }
    static void write(JsonWriter& out, const std::string& member) { out.text(member); }
};

template <>
struct JsonValue<Unit> {
    static void read(ObjectReader& reader, const std::string& key, bool required, Unit& member) {
        const std::string text = reader.text(key, required);
        if (!text.empty()) member = unit_from(text, reader.path_of(key), reader.problems());
    }
    static void write(JsonWriter& out, const Unit& member) { out.text(member.text()); }
};

template <>
struct JsonValue<bool> {
    static void read(ObjectReader& reader, const std::string& key, bool, bool& member) {
        member = reader.flag(key).value_or(member);
    }
    static void write(JsonWriter& out, bool member) { out.boolean(member); }
};

template <>
struct JsonValue<double> {
    static void read(ObjectReader& reader, const std::string& key, bool required, double& member) {
        member = reader.number(key, required).value_or(member);
    }
    static void write(JsonWriter& out, double member) { out.finite_number(member); }
};

/// A whole number that is not negative.
template <std::unsigned_integral M>
struct JsonValue<M> {
    static void read(ObjectReader& reader, const std::string& key, bool required, M& member) {
        if (const auto number = reader.number(key, required))
            take(*number, key, reader.path_of(key), reader.problems(), member);
    }
    static void take(double number, const std::string& key, const std::string& path, Problems& problems,
                     M& member) {
        if (number >= 0 && number <= 1e15 && number == static_cast<double>(static_cast<M>(number)))
            member = static_cast<M>(number);
        else
            problems.error(path, tell<"'%1' must be a whole number that is not negative; it is %2">(
                                     key, readable_number(number)));
    }
    static void write(JsonWriter& out, M member) { out.integer(member); }
};

template <>
struct JsonValue<std::optional<Quantity>> {
    static void read(ObjectReader& reader, const std::string& key, bool, std::optional<Quantity>& member) {
        member = reader.quantity(key);
    }
    static void write(JsonWriter& out, const std::optional<Quantity>& member) {
        write_quantity(out, *member);
    }
};

/// A list of numbers.
template <class Number>
requires std::floating_point<Number> || std::unsigned_integral<Number>
struct JsonValue<std::vector<Number>> {
    static void read(ObjectReader& reader, const std::string& key, bool required,
                     std::vector<Number>& member) {
        const Json* list = reader.list(key, required);
        for (std::size_t i = 0; list && i < list->size(); ++i) {
            const Json& item = (*list)[i];
            const std::string path = reader.path_of(key) + "/" + std::to_string(i);
            member.push_back({});
            if (!item.is_number())
                reader.problems().error(path, tell<"a number is needed here; it is %1">(json_words(item)));
            else if constexpr (std::floating_point<Number>)
                member.back() = item.get<Number>();
            else
                JsonValue<Number>::take(item.get<double>(), key, path, reader.problems(), member.back());
        }
    }
    static void write(JsonWriter& out, const std::vector<Number>& member) {
        out.begin_list();
        for (const Number number : member) JsonValue<Number>::write(out, number);
        out.end();
    }
};

/// A list x, y, z on one line.
template <>
struct JsonValue<std::array<double, 3>> {
    static void read(ObjectReader& reader, const std::string& key, bool required,
                     std::array<double, 3>& member);
    static void write(JsonWriter& out, const std::array<double, 3>& member);
};

/// A list of texts, on one line.
template <>
struct JsonValue<std::vector<std::string>> {
    static void read(ObjectReader& reader, const std::string& key, bool required,
                     std::vector<std::string>& member);
    static void write(JsonWriter& out, const std::vector<std::string>& member);
};

/// A choice as it is called in files.
template <class E>
struct Word {
    E value;
    const char* key;
};

/// A member that is one of some words.
template <class E>
struct OneOf {
    std::vector<Word<E>> words;

    void read(ObjectReader& reader, const std::string& key, bool required, E& member) const {
        const std::string text = reader.text(key, required);
        if (text.empty()) return;
        std::vector<std::string> known;
        for (const Word<E>& word : words) {
            if (text == word.key) member = word.value;
            known.emplace_back(word.key);
        }
        if (std::find(known.begin(), known.end(), text) == known.end())
            reader.problems().error(reader.path_of(key),
                                    tell<"'%1' must be one of %2; it is '%3'%4">(key, listed(known), text,
                                                                                 did_you_mean(text, known)));
    }
    void write(JsonWriter& out, E member) const {
        for (const Word<E>& word : words)
            if (word.value == member) return out.text(word.key);
        throw std::logic_error("a value of an enumeration has no word in project files");
    }
};
template <class T>
class JsonFields {
public:
    using Style = JsonWriter::Style;
    /// `what` names the object in messages ("a study").
    explicit JsonFields(Message what, Style style = Style::spread)
        : JsonFields(std::move(what), [style](const T&) { return style; }) {}
    JsonFields(Message what, std::function<Style(const T&)> style)
        : what_(std::move(what)), style_(std::move(style)) {}

    /// Adds a member that is read where it is given, and written where it is not what a new T has.
    template <class M, class How = JsonValue<M>>
    JsonFields& add(const char* key, M T::*member, How how = {}) {
        return declare(key, member, std::move(how), false, false);
    }
    /// Adds a member that is always written, and without which the file has a problem.
    template <class M, class How = JsonValue<M>>
    JsonFields& required(const char* key, M T::*member, How how = {}) {
        return declare(key, member, std::move(how), true, true);
    }
    /// Adds a member that is always written, and that files may leave out.
    template <class M, class How = JsonValue<M>>
    JsonFields& written(const char* key, M T::*member, How how = {}) {
        return declare(key, member, std::move(how), false, true);
    }
    /// Adds the keys of a member that stand in the same object.
    template <class M>
    JsonFields& part(M T::*member, JsonFields<M> fields) {
        const auto shared = std::make_shared<const JsonFields<M>>(std::move(fields));
        fields_.push_back({{},
                           {},
                           [=](ObjectReader& reader, T& to) { shared->read_into(reader, to.*member); },
                           [=](JsonWriter& out, const T& from, const T& otherwise) {
                               shared->write_members(out, from.*member, otherwise.*member);
                           }});
        return *this;
    }

    /// Adds a member, always written, whose form depends on others, which are declared before it.
    template <class M>
    JsonFields& by_hand(const char* key, M T::*member,
                        std::function<void(ObjectReader&, const std::string& key, T&)> read,
                        std::function<void(JsonWriter&, const T&)> write) {
        fields_.push_back({key, member, [=](ObjectReader& reader, T& to) { read(reader, key, to); },
                           [=](JsonWriter& out, const T& from, const T&) {
                               out.key(key);
                               write(out, from);
                           }});
        return *this;
    }
    /// Adds the fields of others, of T itself.
    JsonFields& all_of(const JsonFields& others) {
        fields_.insert(fields_.end(), others.fields_.begin(), others.fields_.end());
        return *this;
    }

    T read(const Json& value, const std::string& path, Problems& problems) const {
        ObjectReader reader(value, path, what_, problems);
        T read{};
        read_into(reader, read);
        reader.refuse_unknown_keys();
        return read;
    }
    void read_into(ObjectReader& reader, T& to) const {
        for (const Field& field : fields_) field.read(reader, to);
    }
    void write(JsonWriter& out, const T& value) const {
        out.begin_object(style_(value));
        write_members(out, value, T{});
        out.end();
    }
    void write_members(JsonWriter& out, const T& value, const T& otherwise) const {
        for (const Field& field : fields_) field.write(out, value, otherwise);
    }

    /// The place of a problem with the member, relative to the object: "/axes".
    template <class M>
    std::string place(M T::*member) const {
        for (const Field& field : fields_)
            if (const auto* bound = std::any_cast<M T::*>(&field.member); bound && *bound == member)
                return "/" + field.key;
        throw std::logic_error("a member without a key in project files");
    }
    template <class M>
    std::string place(std::vector<M> T::*member, std::size_t item) const {
        return place(member) + "/" + std::to_string(item);
    }

private:
    struct Field {
        std::string key;
        std::any member;
        std::function<void(ObjectReader&, T&)> read;
        std::function<void(JsonWriter&, const T&, const T& otherwise)> write;
    };

    template <class M, class How>
    JsonFields& declare(const char* key, M T::*member, How how, bool required, bool always) {
        fields_.push_back({key, member,
                           [=](ObjectReader& reader, T& to) { how.read(reader, key, required, to.*member); },
                           [=](JsonWriter& out, const T& from, const T& otherwise) {
                               if (!always && from.*member == otherwise.*member) return;
                               out.key(key);
                               how.write(out, from.*member);
                           }});
        return *this;
    }

    Message what_;
    std::function<Style(const T&)> style_;
    std::vector<Field> fields_;
};

/// A list of objects.
template <class T>
struct ListOf {
    JsonFields<T> fields;

    void read(ObjectReader& reader, const std::string& key, bool required, std::vector<T>& member) const {
        const Json* list = reader.list(key, required);
        for (std::size_t i = 0; list && i < list->size(); ++i)
            member.push_back(
                fields.read((*list)[i], reader.path_of(key) + "/" + std::to_string(i), reader.problems()));
    }
    void write(JsonWriter& out, const std::vector<T>& member) const {
        out.begin_list();
        for (const T& item : member) fields.write(out, item);
        out.end();
    }
};
template <class T>
ListOf(JsonFields<T>) -> ListOf<T>;

/// An object.
template <class T>
struct ObjectOf {
    JsonFields<T> fields;

    void read(ObjectReader& reader, const std::string& key, bool, T& member) const {
        if (const Json* value = reader.find(key))
            member = fields.read(*value, reader.path_of(key), reader.problems());
    }
    void write(JsonWriter& out, const T& member) const { fields.write(out, member); }
};
template <class T>
ObjectOf(JsonFields<T>) -> ObjectOf<T>;

/// A value that may be absent, and is not written then.
template <class How>
struct Optional {
    How how;

    template <class M>
    void read(ObjectReader& reader, const std::string& key, bool required, std::optional<M>& member) const {
        const bool given = reader.has(key);
        M value{};
        how.read(reader, key, required, value);
        if (given) member = std::move(value);
    }
    template <class M>
    void write(JsonWriter& out, const std::optional<M>& member) const {
        how.write(out, *member);
    }
};
template <class How>
Optional(How) -> Optional<How>;

}  // namespace covaria
