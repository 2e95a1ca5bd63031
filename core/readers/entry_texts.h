// Ids and tables of proposals.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>

#include "core/setup/setup_schema.h"

namespace covaria {

/// The id made of a name, at most 60 characters: "arm-x-5-txt" of "Arm X (5).txt"; `otherwise` where nothing
/// is left.
std::string id_of(const std::string& name, const std::string& otherwise);
/// The text without marks of control, invalid UTF-8 replaced by '?', with one blank between words.
std::string plain_line(const std::string& text);
/// A name as a field takes it: a plain line of at most 200 bytes.
std::string plain_name(const std::string& name);
/// The file's name without its ending: "Certificate 12" of "Certificate 12.xml".
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
