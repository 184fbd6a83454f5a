#include "app/platform/profile.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "core/base/sentence.h"

namespace batten::platform {

using Json = nlohmann::ordered_json;

namespace {

using Frames = std::vector<FrameCost>;

constexpr std::array all_parts{FramePart::input, FramePart::commands, FramePart::panels,
                               FramePart::scene, FramePart::upload,   FramePart::draw};

template <class Number>
Spread spread_over(const Frames& frames, const Number& number_of) {
    std::vector<double> values;
    values.reserve(frames.size());
    for (const FrameCost& frame : frames) values.push_back(static_cast<double>(number_of(frame)));
    return spread_of(std::move(values));
}

Spread total_of(const Frames& frames) {
    return spread_over(frames, [](const FrameCost& frame) { return frame.total_ms(); });
}

Spread part_of(const Frames& frames, FramePart part) {
    return spread_over(frames,
                       [part](const FrameCost& frame) { return frame.part_ms[static_cast<std::size_t>(part)]; });
}

Spread vertices_of(const Frames& frames) {
    return spread_over(frames, [](const FrameCost& frame) { return frame.vertices; });
}

double ratio_of(const Profile& profile) {
    return total_of(profile.frames).median / total_of(profile.empty_frames).median;
}

Json json_of(Spread spread) {
    return {{"median", spread.median}, {"p99", spread.p99}};
}

Json parts_json(const Frames& frames) {
    Json parts = Json::object();
    for (const FramePart part : all_parts) parts[core::name_of(part)] = json_of(part_of(frames, part));
    return parts;
}

void print_row(std::ostream& out, const char* title, Spread spread, Spread empty, int decimals) {
    out << fmt::format("  {:<10}{:>12.{}f}{:>12.{}f}{:>15.{}f}{:>12.{}f}\n", title, spread.median, decimals, spread.p99,
                       decimals, empty.median, decimals, empty.p99, decimals);
}

}  // namespace

Spread spread_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t count = values.size();
    return {values[(count + 1) / 2 - 1], values[(99 * count + 99) / 100 - 1]};
}

void print_text(std::ostream& out, const Profile& profile) {
    constexpr int ms_decimals = 3;
    out << core::sentence("{gesture}: {count} frames of {file}, in milliseconds of processor time",
                          {{"gesture", core::title_of(profile.options.gesture)},
                           {"count", profile.frames.size()},
                           {"file", profile.options.file.string()}})
        << '\n'
        << fmt::format("  {:<10}{:>12}{:>12}{:>15}{:>12}\n", "", "median", "99 of 100", "empty canvas", "99 of 100");
    print_row(out, "frame", total_of(profile.frames), total_of(profile.empty_frames), ms_decimals);
    for (const FramePart part : all_parts)
        print_row(out, core::title_of(part), part_of(profile.frames, part), part_of(profile.empty_frames, part),
                  ms_decimals);
    print_row(out, "vertices", vertices_of(profile.frames), vertices_of(profile.empty_frames), 0);
    out << core::sentence("A frame costs {ratio} times that of an empty canvas",
                          {{"ratio", fmt::format("{:.2f}", ratio_of(profile))}})
        << '\n'
        << core::sentence("The first frame was shown after {start}",
                          {{"start", fmt::format("{:.3f}", profile.start_ms)}})
        << '\n';
}

void print_json(std::ostream& out, const Profile& profile) {
    constexpr int indent = 2;
    const Json json{{"file", profile.options.file.string()},
                    {"gesture", core::name_of(profile.options.gesture)},
                    {"frames", profile.frames.size()},
                    {"frame_ms", json_of(total_of(profile.frames))},
                    {"parts_ms", parts_json(profile.frames)},
                    {"vertices", json_of(vertices_of(profile.frames))},
                    {"empty",
                     {{"frame_ms", json_of(total_of(profile.empty_frames))},
                      {"parts_ms", parts_json(profile.empty_frames)},
                      {"vertices", json_of(vertices_of(profile.empty_frames))}}},
                    {"ratio", ratio_of(profile)},
                    {"start_ms", profile.start_ms}};
    out << json.dump(indent, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace batten::platform
