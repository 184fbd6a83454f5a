#include "exchange/code/code.h"

#include <ostream>

#include "app/cli/input.h"

namespace batten::cli {

ExitStatus code(const CodeOptions& options, Output output) {
    const std::optional<core::Document> document = load(output, options.file);
    if (!document) return ExitStatus::wrong_input;
    const std::optional<std::size_t> index = find_curve(output, options.file, *document, options.curve);
    if (!index) return ExitStatus::wrong_input;
    const core::FileResult<exchange::Code> code = exchange::code_of(document->curves[*index], options.language);
    if (!code) {
        say_error(output, options.file, code.error());
        return ExitStatus::wrong_input;
    }
    output.results << code->text;
    if (!code->text.ends_with('\n')) output.results << '\n';
    return ExitStatus::done;
}

}  // namespace batten::cli
