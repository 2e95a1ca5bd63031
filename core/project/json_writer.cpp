#include "core/project/json_writer.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/setup/message_text.h"

namespace covaria {

void JsonWriter::open(char open, char close, Style style) {
    before_item();
    out_ += open;
    const bool within_line = !levels_.empty() && levels_.back().style == Style::one_line;
    levels_.push_back({close, within_line ? Style::one_line : style});
}

void JsonWriter::end() {
    const Level level = levels_.back();
    levels_.pop_back();
    if (level.style == Style::spread && !level.empty) line_break();
    out_ += level.close;
}

void JsonWriter::key(std::string_view key) {
    text(key);
    out_ += ": ";
    after_key_ = true;
}

void JsonWriter::number(double value) {
    if (std::isnan(value)) note_unwritable();
    if (std::isfinite(value))
        raw(shortest_number(value));
    else
        null();
}

void JsonWriter::finite_number(double value) {
    if (!std::isfinite(value)) note_unwritable();
    number(value);
}

void JsonWriter::text(std::string_view value) {
    raw(nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

std::string JsonWriter::take() {
    return std::move(out_) + "\n";
}

void JsonWriter::raw(std::string_view text) {
    before_item();
    out_ += text;
}

void JsonWriter::before_item() {
    if (after_key_ || levels_.empty()) {
        after_key_ = false;
        return;
    }
    Level& level = levels_.back();
    if (!level.empty) out_ += level.style == Style::one_line ? ", " : ",";
    level.empty = false;
    if (level.style == Style::spread) line_break();
}

void JsonWriter::line_break() {
    out_ += '\n';
    out_.append(2 * levels_.size(), ' ');
}

}  // namespace covaria
