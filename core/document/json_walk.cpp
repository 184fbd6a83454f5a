#include "core/document/json_walk.h"

#include <limits>

#include "core/document/detail/json_checks.h"

namespace batten::core {

namespace {

class ListenerCaller : public JsonChecks {
  public:
    ListenerCaller(TextStream& text, JsonListener& listener) : JsonChecks(text), listener_(listener) {}

    bool null() override { return tell({}); }
    bool boolean(bool value) override { return tell(value); }
    bool number_integer(number_integer_t value) override { return tell(static_cast<double>(value)); }
    bool number_unsigned(number_unsigned_t value) override { return tell(static_cast<double>(value)); }
    bool number_float(number_float_t value, const string_t& /*text*/) override { return tell(value); }
    bool string(string_t& value) override { return tell(std::move(value)); }
    bool start_object(std::size_t /*count*/) override { return enter() && goes_on(listener_.begin_object()); }
    bool start_array(std::size_t /*count*/) override { return enter() && goes_on(listener_.begin_list()); }
    bool key(string_t& name) override { return add_name(name) && goes_on(listener_.name(std::move(name))); }

    bool end_object() override {
        leave();
        return goes_on(listener_.end_object());
    }
    bool end_array() override {
        leave();
        return goes_on(listener_.end_list());
    }

  private:
    bool tell(JsonScalar value) { return goes_on(listener_.scalar(std::move(value))); }
    bool goes_on(bool is_taken) { return is_taken || refuse_here(listener_.refusal()); }

    JsonListener& listener_;
};

}  // namespace

FileResult<void> walk_json(std::string_view text, JsonListener& listener) {
    TextStream stream(text);
    return ListenerCaller(stream, listener).read(std::numeric_limits<std::size_t>::max());
}

}  // namespace batten::core
