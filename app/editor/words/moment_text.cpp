#include "app/editor/words/moment_text.h"

#include <fmt/core.h>

#include <array>
#include <ctime>

#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr std::array months{"January", "February", "March",     "April",   "May",      "June",
                            "July",    "August",   "September", "October", "November", "December"};

std::tm local_time(std::int64_t seconds) {
    const auto time = static_cast<std::time_t>(seconds);
    std::tm parts{};
    localtime_r(&time, &parts);
    return parts;
}

// Noon of the day before, which is on that day in every time zone, summer time or not.
std::tm day_before(std::tm day) {
    constexpr int noon = 12;
    day.tm_mday -= 1;
    day.tm_hour = noon;
    day.tm_isdst = -1;
    return local_time(std::mktime(&day));
}

bool is_same_day(const std::tm& a, const std::tm& b) {
    return a.tm_year == b.tm_year && a.tm_yday == b.tm_yday;
}

}  // namespace

std::string moment_text(std::int64_t seconds, std::int64_t now) {
    constexpr int first_year = 1900;
    const std::tm moment = local_time(seconds);
    const std::tm today = local_time(now);
    const std::string clock = fmt::format("{}:{:02}", moment.tm_hour, moment.tm_min);
    if (is_same_day(moment, today)) return core::sentence("today at {clock}", {{"clock", clock}});
    if (is_same_day(moment, day_before(today))) return core::sentence("yesterday at {clock}", {{"clock", clock}});
    return core::sentence("on {month} {day}, {year} at {clock}",
                          {{"month", months[static_cast<std::size_t>(moment.tm_mon)]},
                           {"day", moment.tm_mday},
                           {"year", moment.tm_year + first_year},
                           {"clock", clock}});
}

}  // namespace batten::editor
