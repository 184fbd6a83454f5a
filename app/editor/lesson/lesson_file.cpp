#include "app/editor/lesson/lesson_file.h"

#include <map>

#include "app/editor/lesson/check_json.h"
#include "app/editor/state/view_forms.h"
#include "core/document/file_text.h"
#include "core/document/json_check.h"
#include "core/document/native_file.h"

namespace batten::editor {

namespace {

using core::sentence;

constexpr const char* format_name = "batten-lesson";
constexpr int format_version = 1;

/// A document within a lesson, by the reader of documents.
void read_document(MemberReader& reader, const LessonJson& object, const char* name, core::Document& document) {
    const auto refuse = [&](const std::string& what) {
        reader.fail(sentence("{place}: {what}", {{"place", reader.place(name)}, {"what", what}}));
    };
    const auto read = core::parse_document(object.dump());
    if (!read) return refuse(read.error().sentence());
    if (const Outcome<ViewForms> forms = read_forms(read->view.unknown_members); !forms) return refuse(forms.error());
    document = *read;
}

LessonJson json_of_document(const core::Document& document) {
    return LessonJson::parse(core::format_document(document));
}

void describe(auto& members, LessonView& view) {
    members.optional("overlays", view.overlays);
    members.optional("parameter", view.parameter);
    members.optional("level", view.level);
}

/// The member `name` of `parent`, an object of its own, as far as `take` takes its members.
template <class Take>
void read_object(MemberReader& parent, const LessonJson& json, const char* name, const Take& take) {
    if (!parent.has(name)) return;
    MemberReader reader(json[name], parent.place(name));
    take(reader);
    if (std::optional<Refusal> refusal = reader.finish()) parent.fail(*std::move(refusal));
}

/// The member `name`, a list of objects.
template <class Take>
void read_list(MemberReader& parent, const LessonJson& json, const char* name, const Take& take) {
    if (!parent.has(name)) return;
    const LessonJson& list = json[name];
    if (!list.is_array()) return parent.fail(parent.place(name), "a list");
    for (std::size_t i = 0; i < list.size(); ++i) take(list[i], fmt::format("{}/{}", parent.place(name), i));
}

void read_acts(MemberReader& parent, const LessonJson& json, const char* name, std::vector<std::string>& acts) {
    read_list(parent, json, name, [&](const LessonJson& act, const std::string& place) {
        if (!act.is_array()) return parent.fail(place, "a command with its arguments, like [\"insert-knot\", 0.5]");
        acts.push_back(act.dump());
    });
}

void read_checks(MemberReader& parent, const LessonJson& json, std::vector<LessonCheck>& checks) {
    read_list(parent, json, "checks", [&](const LessonJson& item, const std::string& place) {
        Outcome<LessonCheck> check = read_check(item, place);
        if (check)
            checks.push_back(*std::move(check));
        else
            parent.fail(check.error());
    });
}

std::optional<Refusal> read_step(const LessonJson& json, const std::string& pointer, LessonStep& step) {
    MemberReader reader(json, pointer);
    reader.required("text", step.text);
    reader.optional("task", step.task);
    read_acts(reader, json, "do", step.acts);
    read_acts(reader, json, "solution", step.solution);
    if (reader.has("document")) read_document(reader, json["document"], "document", step.document.emplace());
    read_object(reader, json, "view", [&](MemberReader& view) { describe(view, step.view); });
    read_checks(reader, json, step.checks);
    if (!step.task.empty() && step.checks.empty()) reader.fail(reader.place("task"), "followed by checks");
    if (step.task.empty() && !step.checks.empty()) reader.fail(reader.place("checks"), "those of a task");
    return reader.finish();
}

void read_format(MemberReader& reader) {
    std::string format;
    int version = 0;
    reader.required("format", format);
    reader.required("version", version);
    if (format != format_name) reader.fail(reader.place("format"), "\"batten-lesson\"");
    if (version != format_version) reader.fail(reader.place("version"), "1, the version that this program reads");
}

void read_notation(MemberReader& reader, const LessonJson& json, std::optional<Notation>& notation) {
    read_object(reader, json, "notation", [&](MemberReader& members) {
        Notation& chosen = notation.emplace();
        members.optional("points", chosen.points);
        members.optional("parameter", chosen.parameter);
        members.optional("degree", chosen.degree);
        members.optional("triangles", chosen.triangles);
        members.optional("numbers", chosen.numbers);
    });
}

LessonJson json_of(const LessonView& view) {
    MemberWriter writer;
    LessonView copy = view;
    describe(writer, copy);
    return writer.take();
}

void put_acts(LessonJson& json, const char* name, const std::vector<std::string>& acts) {
    if (!acts.empty()) json[name] = LessonJson::array();
    for (const std::string& act : acts) json[name].push_back(LessonJson::parse(act));
}

LessonJson json_of(const LessonStep& step) {
    LessonJson json = LessonJson::object();
    json["text"] = step.text;
    if (step.document) json["document"] = json_of_document(*step.document);
    put_acts(json, "do", step.acts);
    if (LessonJson view = json_of(step.view); !view.empty()) json["view"] = std::move(view);
    if (!step.task.empty()) json["task"] = step.task;
    if (!step.checks.empty()) json["checks"] = LessonJson::array();
    for (const LessonCheck& check : step.checks) json["checks"].push_back(json_of(check));
    put_acts(json, "solution", step.solution);
    return json;
}

}  // namespace

Outcome<Lesson> parse_lesson(std::string_view text, const std::string& name) {
    if (const auto check = core::check_json(text); !check) return tl::unexpected(check.error().sentence());
    const LessonJson json = LessonJson::parse(text, nullptr, false);
    MemberReader reader(json, "");
    Lesson lesson;
    lesson.name = name;
    read_format(reader);
    reader.required("title", lesson.title);
    reader.required("text", lesson.text);
    read_notation(reader, json, lesson.notation);
    if (reader.has("document")) read_document(reader, json["document"], "document", lesson.document);
    read_object(reader, json, "view", [&](MemberReader& view) { describe(view, lesson.view); });
    read_list(reader, json, "steps", [&](const LessonJson& item, const std::string& place) {
        if (std::optional<Refusal> refusal = read_step(item, place, lesson.steps.emplace_back()))
            reader.fail(*std::move(refusal));
    });
    if (lesson.steps.empty()) reader.fail(reader.place("steps"), "a list of at least one step");
    if (std::optional<Refusal> refusal = reader.finish()) return tl::unexpected(*std::move(refusal));
    return lesson;
}

std::string format_lesson(const Lesson& lesson) {
    LessonJson json = LessonJson::object();
    json["format"] = format_name;
    json["version"] = format_version;
    json["title"] = lesson.title;
    json["text"] = lesson.text;
    if (lesson.notation) json["notation"] = names_of(*lesson.notation);
    json["document"] = json_of_document(lesson.document);
    if (LessonJson view = json_of(lesson.view); !view.empty()) json["view"] = std::move(view);
    json["steps"] = LessonJson::array();
    for (const LessonStep& step : lesson.steps) json["steps"].push_back(json_of(step));
    return fmt::format("{}\n", json.dump(2, ' ', false, LessonJson::error_handler_t::replace));
}

Outcome<Lesson> load_lesson(const std::filesystem::path& path) {
    const auto text = core::read_text(path);
    if (!text) return tl::unexpected(text.error().sentence());
    return parse_lesson(*text, path.stem().string()).map_error([&](const Refusal& refusal) {
        return sentence("{file}: {what}", {{"file", path.filename().string()}, {"what", refusal}});
    });
}

Outcome<void> save_lesson(const Lesson& lesson, const std::filesystem::path& path) {
    return core::replace_text(path, format_lesson(lesson)).map_error([](const core::FileError& error) {
        return error.sentence();
    });
}

}  // namespace batten::editor
