/// What `batten figure --show` names, and the views in which it is seen.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "app/cli/figure_order.h"

namespace batten::cli {

/// All that `--show` can name, most usual first.
std::vector<std::string> names_to_show();

/// The words of a list such as that of `--show`, without blanks around them; none of nothing but blanks.
std::vector<std::string> words_between_commas(std::string_view text);

/// Takes `--show` and `--view` of `options` into `order`. What is only seen beside the basis functions brings them in
/// where no view was chosen. The error is a sentence: an unknown name or an empty one, one that no figure shows, or
/// one that is not seen in the view that was chosen. Nothing at all between quotes shows the curve alone.
tl::expected<void, std::string> read_show_and_view(FigureOrder& order, const FigureOptions& options);

}  // namespace batten::cli
