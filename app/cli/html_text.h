/// Texts and pictures as they stand in HTML.
#pragma once

#include <string>
#include <string_view>

namespace batten::cli {

/// A text in the notation of render::Label, its lower and higher parts as <sub> and <sup>.
std::string html_of_label(std::string_view label);

/// An image of its own, so that what is named inside of it is not mixed up with that of others.
std::string html_image(std::string_view svg, std::string_view alternative);

}  // namespace batten::cli
