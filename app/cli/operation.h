/// The operations of `apply` and `new`: commands that scripts are offered, read from words.
#pragma once

#include <string>
#include <vector>

#include "app/editor/command_spec.h"
#include "app/editor/fields/argument.h"

namespace batten::cli {

/// Ends the arguments of an operation.
inline constexpr const char* mark = "--";

/// The command that scripts call `name`, or null.
const editor::CommandSpec* operation_called(const std::string& name);

/// How many arguments it cannot do without.
std::size_t needed_count(const editor::CommandSpec& spec);

/// The fields that `count` arguments are for, one for each as far as there are fields: the last ones that can be left
/// out are, and needed ones where there are too few arguments.
std::vector<const editor::Field*> fields_of_arguments(const editor::CommandSpec& spec, std::size_t count);

/// One operation as it was given.
struct Operation {
    const editor::CommandSpec* spec;
    std::vector<editor::Argument> arguments;
    std::string text;  ///< "insert-knot 0.5"
};

/// Takes operations off the front of words, one by one, because what a word means may rest on the ones before.
class OperationReader {
  public:
    explicit OperationReader(const std::vector<std::string>& words) : words_(words) { skip_mark(); }

    bool is_at_end() const { return next_ == words_.size(); }

    /// The next operation: a name and as many arguments as it takes. A word for what is needed is taken whatever it is.
    /// One for what may be left out is taken where it names a curve of `document` or a choice that is due; else the
    /// name of an operation, or "--", ends the arguments. Behind "--" what is needed is taken too. The refusal names a
    /// word that is not an operation.
    editor::Outcome<Operation> take(const core::Document& document);

  private:
    editor::Refusal no_operation() const;
    void take_arguments(Operation& operation, const core::Document& document);
    bool is_argument(const editor::CommandSpec& spec, std::size_t given, const core::Document& document);
    void skip_mark();

    const std::vector<std::string>& words_;
    std::size_t next_ = 0;
    std::string before_;                       ///< the operation before, as it was given
    const editor::Field* left_out_ = nullptr;  ///< the field of it that the next word might have been meant for
};

}  // namespace batten::cli
