// Canonical JSON text: fixed layout and shortest numbers, so that equal values give equal bytes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace covaria {

/// Writes one JSON text from front to back. Objects and lists are either spread (one member a line) or kept
/// on one line; everything inside one that is on one line is on that line too.
class JsonWriter {
public:
    enum class Style { spread, one_line };

    void begin_object(Style style = Style::spread) { open('{', '}', style); }
    void begin_list(Style style = Style::spread) { open('[', ']', style); }
    void end();
    /// Writes a key with a text as its value.
    void member(const char* key, const std::string& value) {
        this->key(key);
        text(value);
    }
    /// Writes the key of the next value, inside an object.
    void key(std::string_view key);

    /// Writes a number. Infinity is written as null; a value that is not a number too, and makes
    /// `has_unwritable` true.
    void number(double value);
    /// Writes a number where infinity has no meaning: it makes `has_unwritable` true as well.
    void finite_number(double value);
    void integer(std::uint64_t value) { raw(std::to_string(value)); }
    void boolean(bool value) { raw(value ? "true" : "false"); }
    void null() { raw("null"); }
    /// Writes a UTF-8 text, whose broken sequences become the replacement character.
    void text(std::string_view value);

    bool has_unwritable() const { return has_unwritable_; }
    /// Notes that a value could not be written as it is: the text does not read back as the same value.
    void note_unwritable() { has_unwritable_ = true; }
    /// The finished text, with a line feed at its end.
    std::string take();

private:
    struct Level {
        char close;
        Style style;
        bool empty = true;
    };
    void open(char open, char close, Style style);
    void raw(std::string_view text);
    void before_item();
    void line_break();

    std::string out_;
    std::vector<Level> levels_;
    bool after_key_ = false;
    bool has_unwritable_ = false;
};

}  // namespace covaria
