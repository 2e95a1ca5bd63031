// Ids and tables of what is proposed.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>

#include "core/setup/setup_schema.h"

namespace covaria {

/// "Arm X (5).txt" -> "arm-x-5-txt"; `otherwise` where nothing is left. At most 60 characters.
std::string id_of(const std::string& name, const std::string& otherwise);
/// Without marks of control, invalid UTF-8 replaced by '?', one blank between words.
std::string plain_line(const std::string& text);
/// A name as a field takes it: a plain line of at most 200 bytes.
std::string plain_name(const std::string& name);
/// "Certificate 12.xml" -> "Certificate 12".
std::string without_ending(const std::string& file_name);

/// Rows of a table by the keys of its columns; cells that are not named stay empty.
class TableRows {
public:
    /// `field` must be a table and outlive this.
    explicit TableRows(const FieldSpec& field);
    void set_unit(const std::string& column, const Unit& unit);
    void add(std::initializer_list<std::pair<const char*, SetupCell>> cells);
    const SetupTable& table() const { return table_; }

private:
    const FieldSpec& field_;
    SetupTable table_;
};

/// The schema of an asset kind or a model, and a table of it, which there must be.
const SetupSchema& schema_of(const std::string& kind_or_model);
const FieldSpec& table_of(const std::string& kind_or_model, const std::string& key);

}  // namespace covaria
