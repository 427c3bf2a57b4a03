#include "apps/serve/messages.h"

#include "base/error.h"
#include "base/text.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <map>

namespace lambent::serve {
namespace {

using nlohmann::json;
using viewer::OrbitCamera;
using viewer::ViewRequest;

struct MessageReader {
    const json& message;
    viewer::Session& session;
    const viewer::FileList& files;
    std::uint64_t id;

    double number(const char* name) const
    {
        const auto found = message.find(name);
        if (found == message.end() || !found->is_number())
            throw Malformed(text("'", name, "' must be a number"));
        return found->get<double>();
    }

    std::string word(const char* name) const
    {
        const auto found = message.find(name);
        if (found == message.end() || !found->is_string())
            throw Malformed(text("'", name, "' must be text"));
        return found->get<std::string>();
    }

    bool yes(const char* name) const
    {
        const auto found = message.find(name);
        if (found == message.end() || !found->is_boolean())
            throw Malformed(text("'", name, "' must be true or false"));
        return found->get<bool>();
    }

    // The value of a parameter, which may be a number or text.
    std::string value() const
    {
        const auto found = message.find("value");
        return found != message.end() && found->is_number() ? viewer::number_word(found->get<double>())
                                                            : word("value");
    }

    std::vector<std::string> words(const char* name) const
    {
        const auto found = message.find(name);
        if (found == message.end() || !found->is_array())
            throw Malformed(text("'", name, "' must be a list"));
        std::vector<std::string> list;
        for (const json& entry : *found) {
            if (!entry.is_string())
                throw Malformed(text("'", name, "' must be a list of texts"));
            list.push_back(entry.get<std::string>());
        }
        return list;
    }

    void change(const viewer::Session::Change& change) const { session.change(id, change); }
};

using Action = std::function<void(const MessageReader&)>;
using Actions = std::map<std::string, Action, std::less<>>;
using World = OrbitCamera::World;

// The messages that change the request.
Actions request_changes()
{
    return {
        {"orbit",
         [](const MessageReader& s) {
             const double x = s.number("x"), y = s.number("y");
             s.change([&](ViewRequest& request, const World&) { request.eye.orbit(x, y); });
         }},
        {"pan",
         [](const MessageReader& s) {
             const double x = s.number("x"), y = s.number("y");
             s.change([&](ViewRequest& request, const World& world) {
                 request.eye.pan(world, x, y, viewer::number_in(request.asked, "fov"));
             });
         }},
        {"dolly",
         [](const MessageReader& s) {
             const double by = s.number("by");
             s.change([&](ViewRequest& request, const World& world) { request.eye.dolly(world, by); });
         }},
        {"turn",
         [](const MessageReader& s) {
             const double by = s.number("by");
             s.change([&](ViewRequest& request, const World&) { viewer::turn_environment(request, by); });
         }},
        {"set",
         [](const MessageReader& s) {
             const std::string name = s.word("name"), value = s.value();
             s.change(
                 [&](ViewRequest& request, const World&) { viewer::set_value(request.asked, name, value); });
         }},
        {"lights",
         [](const MessageReader& s) {
             const std::vector<std::string> list = s.words("list");
             s.change([&](ViewRequest& request, const World&) { viewer::set_lights(request, list); });
         }},
        {"size",
         [](const MessageReader& s) {
             const double width = s.number("width"), height = s.number("height");
             s.change([&](ViewRequest& request, const World&) { viewer::set_size(request, width, height); });
         }},
    };
}

// The messages that the session carries out itself.
Actions session_calls()
{
    return {
        {"animate", [](const MessageReader& s) { s.session.animate(s.id, s.number("number")); }},
        {"moment", [](const MessageReader& s) { s.session.seek(s.id, s.number("seconds")); }},
        {"play", [](const MessageReader& s) { s.session.play(s.id, s.yes("on")); }},
        {"focus", [](const MessageReader& s) { s.session.focus(s.number("x"), s.number("y"), s.id); }},
        {"reset", [](const MessageReader& s) { s.session.reset(s.id); }},
        {"save", [](const MessageReader& s) { s.session.save(s.word("kind")); }},
        {"scene",
         [](const MessageReader& s) {
             const std::string name = s.word("name");
             s.files.check_scene(name);
             s.session.open_scene(name, s.id);
         }},
        {"environment",
         [](const MessageReader& s) {
             const std::string name = s.word("name");
             s.files.check_environment(name);
             s.session.open_environment(name, s.id);
         }},
    };
}

const Actions& actions()
{
    static const Actions all = [] {
        Actions both = request_changes();
        both.merge(session_calls());
        return both;
    }();
    return all;
}

std::string dumped(const nlohmann::ordered_json& message)
{
    return message.dump(-1, ' ', false, json::error_handler_t::replace);
}

} // namespace

MessageKind handle_message(std::string_view message, viewer::Session& session, const viewer::FileList& files)
{
    const json parsed = json::parse(message, nullptr, false);
    if (!parsed.is_object())
        throw Malformed("a message must be a JSON object");
    const auto what = parsed.find("do");
    if (what == parsed.end() || !what->is_string())
        throw Malformed("'do' must be text");
    const std::string& name = what->get_ref<const std::string&>();
    if (name == "seen") {
        session.seen();
        return MessageKind::seen;
    }
    const auto action = actions().find(name);
    if (action == actions().end())
        throw Malformed("'do' names no known action");
    const auto id = parsed.find("id");
    action->second({parsed, session, files,
                    id != parsed.end() && id->is_number_unsigned() ? id->get<std::uint64_t>() : 0});
    return MessageKind::input;
}

std::string hello(const viewer::FileList& files)
{
    return dumped({{"type", "hello"},
                   {"parameters", viewer::to_json(viewer::parameters())},
                   {"scenes", files.scenes()},
                   {"environments", files.environments()},
                   {"most_lights", viewer::most_lights}});
}

std::string error_message(const std::string& line)
{
    return dumped({{"type", "error"}, {"line", one_line(line)}});
}

std::vector<std::uint8_t> frame_message(const std::string& header, std::span<const std::uint8_t> picture)
{
    std::vector<std::uint8_t> bytes;
    bytes.reserve(4 + header.size() + picture.size());
    for (int i = 0; i < 4; ++i)
        bytes.push_back(static_cast<std::uint8_t>(header.size() >> 8 * i));
    bytes.insert(bytes.end(), header.begin(), header.end());
    bytes.insert(bytes.end(), picture.begin(), picture.end());
    return bytes;
}

} // namespace lambent::serve
