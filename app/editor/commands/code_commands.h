/// Commands that copy the active curve as text for programs and papers.
#pragma once

#include "app/editor/command.h"
#include "exchange/code/code.h"

namespace batten::editor {

inline constexpr std::size_t code_language_count = core::Names<exchange::CodeLanguage>::table.size();

struct CopyAs {
    exchange::CodeLanguage language;
    static const CommandSpec& spec();
};

/// One command for each language, for menu and palette.
const CommandSpec& copy_as_language_spec(exchange::CodeLanguage language);

template <exchange::CodeLanguage language>
struct CopyAsLanguage {
    static const CommandSpec& spec() { return copy_as_language_spec(language); }
};

}  // namespace batten::editor
