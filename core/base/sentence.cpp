#include "core/base/sentence.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <span>
#include <vector>

namespace batten::core {

namespace {

[[maybe_unused]] bool has_place(std::string_view pattern, std::string_view name) {
    return pattern.find(fmt::format("{{{}}}", name)) != std::string_view::npos;
}

std::string filled(const char* pattern, std::span<const Place> places) {
    fmt::dynamic_format_arg_store<fmt::format_context> store;
    for (const Place& place : places) store.push_back(fmt::arg(std::string(place.name).c_str(), place.text));
    try {
        return fmt::vformat(pattern, store);
    } catch (const fmt::format_error&) {
        assert(false && "a place of the template was not given");
        return pattern;
    }
}

}  // namespace

std::string sentence(const char* pattern, std::initializer_list<Place> places) {
    assert(std::all_of(places.begin(), places.end(), [&](const Place& p) { return has_place(pattern, p.name); }));
    return filled(pattern, {places.begin(), places.size()});
}

std::string filled_as_needed(const char* pattern, std::span<const Place> places) {
    return filled(pattern, places);
}

std::string filled_as_needed(const char* pattern, std::initializer_list<Place> places) {
    return filled(pattern, {places.begin(), places.size()});
}

const char* PluralPattern::for_count(std::size_t count) const {
    if (count == 0 && none != nullptr) return none;
    return count == 1 ? one : many;
}

std::string sentence(const PluralPattern& pattern, std::size_t count, std::initializer_list<Place> places) {
    std::vector<Place> all(places);
    all.emplace_back("count", count);
    return filled(pattern.for_count(count), all);
}

std::string listed_as_alternatives(std::span<const std::string> items) {
    if (items.size() < 2) return items.empty() ? std::string() : items.front();
    const auto most = items.first(items.size() - 1);
    return sentence("{items} or {last}", {{"items", fmt::format("{}", fmt::join(most, ", "))}, {"last", items.back()}});
}

}  // namespace batten::core
