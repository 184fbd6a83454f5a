/// The members of an object that describes a curve, taken by name.
#pragma once

#include "core/base/geometry.h"
#include "exchange/json/json_tree.h"

namespace batten::exchange {

/// Points of a list of rows, and whether any had a third coordinate other than 0.
struct JsonPoints {
    std::vector<core::Point> points{};
    bool has_heights = false;
};

/// Takes members and notes the first thing found wrong; what was not found stays empty.
class JsonMembers {
  public:
    /// `object` must outlive the members.
    explicit JsonMembers(const JsonValue& object);

    /// What stands in the member `name`, which is an object or wrong.
    const JsonValue& inside(const char* name);

    /// A whole number from `least` to `most`.
    int whole_number(const char* name, int least, int most);

    std::vector<double> numbers(const char* name);           ///< empty and wrong where it is missing
    std::vector<double> optional_numbers(const char* name);  ///< empty where it is missing or null
    JsonPoints points(const char* name);                     ///< of rows of two or three numbers
    bool flag(const char* name);                             ///< false where it is missing
    std::string name() const;                                ///< the member "name", empty where it is missing

    /// In words; empty where nothing was wrong.
    const std::string& defect() const { return defect_; }
    void note(std::string defect);

  private:
    const JsonValue* find(const char* name);

    const JsonValue& object_;
    std::string defect_{};
};

}  // namespace batten::exchange
