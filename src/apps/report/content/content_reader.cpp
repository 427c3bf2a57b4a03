#include "apps/report/content/content_reader.h"

#include "base/text.h"

#include <nlohmann/json.hpp>

#include <set>
#include <stdexcept>
#include <utility>

namespace lambent::report {
namespace {

using Json = nlohmann::ordered_json;

// An object whose keys are read one by one; keys that are not read are errors.
class Object {
public:
    Object(std::string place, const Json& json) : place_(std::move(place)), json_(json)
    {
        if (!json.is_object())
            throw std::logic_error(text(place_, ": not an object"));
    }

    template <class Value>
    Value required(const char* key)
    {
        if (!json_.contains(key))
            throw std::logic_error(text(place_, ": no \"", key, "\""));
        return optional<Value>(key, {});
    }

    template <class Value>
    Value optional(const char* key, Value value)
    {
        taken_.insert(key);
        try {
            return json_.contains(key) ? json_.at(key).get<Value>() : std::move(value);
        } catch (const Json::exception&) {
            throw std::logic_error(text(place_, ": \"", key, "\" has a value of the wrong type"));
        }
    }

    // The result of read(Object) for the object with the key; empty without the key.
    template <class Read>
    auto object(const char* key, Read&& read) -> std::optional<decltype(read(std::declval<Object&>()))>
    {
        taken_.insert(key);
        if (!json_.contains(key))
            return std::nullopt;
        return read_all(text(place_, ".", key), json_.at(key), read);
    }

    // The results of read(Object) for each object of the list with the key; none without the key.
    template <class Read>
    auto objects(const char* key, Read&& read) -> std::vector<decltype(read(std::declval<Object&>()))>
    {
        std::vector<decltype(read(std::declval<Object&>()))> list;
        for (const Json& item : optional<Json>(key, Json::array()))
            list.push_back(read_all(text(place_, ".", key), item, read));
        return list;
    }

    // The result of read(Object) for an object, which must read every key.
    template <class Read>
    static auto read_all(const std::string& place, const Json& json, Read&& read)
    {
        Object object(place, json);
        auto result = read(object);
        for (const auto& [key, value] : json.items())
            if (!object.taken_.contains(key))
                throw std::logic_error(text(place, ": unknown key \"", key, "\""));
        return result;
    }

private:
    std::string place_;
    const Json& json_;
    std::set<std::string> taken_;
};

Json parsed(std::string_view file, std::string_view json)
{
    try {
        return Json::parse(json);
    } catch (const Json::exception& error) {
        throw std::logic_error(text(file, ": ", error.what()));
    }
}

// {"placeholder": "value"} or {"placeholder": ["one value", "another"]}
Condition read_condition(Object& object)
{
    Condition condition;
    const Json entries = object.optional<Json>("if", Json::object());
    for (const auto& [name, values] : entries.items())
        condition[name] = values.is_array() ? values.get<std::vector<std::string>>()
                                            : std::vector{values.get<std::string>()};
    return condition;
}

Axis read_axis(Object& object)
{
    return {object.required<std::string>("name"), object.required<std::vector<std::string>>("values"),
            object.optional<std::string>("title", "")};
}

ShotPattern read_shot(Object& object)
{
    const auto optional = [&](const char* key) { return object.optional<std::string>(key, ""); };
    return {{optional("name"), object.required<std::string>("command"), optional("title"), optional("alt"),
             object.optional("lit", true)},
            optional("converged")};
}

Measurement read_measurement(Object& object)
{
    return {object.required<std::string>("quantity"), object.required<std::string>("name"),
            read_condition(object)};
}

PlottedCurve read_curve(Object& object)
{
    return {object.required<std::string>("name"), object.required<std::string>("figure"),
            object.required<Values>("values")};
}

FigureKind read_kind(const std::string& file, const std::string& name)
{
    static const std::map<std::string, FigureKind> kinds = {{"gallery", FigureKind::gallery},
                                                            {"matrix", FigureKind::matrix},
                                                            {"comparison", FigureKind::comparison},
                                                            {"table", FigureKind::table},
                                                            {"plot", FigureKind::plot}};
    const auto found = kinds.find(name);
    if (found == kinds.end())
        throw std::logic_error(text(file, ": unknown kind of figure \"", name, "\""));
    return found->second;
}

FigureData read_figure(const std::string& file, const std::string& id, Object& object)
{
    FigureData figure;
    figure.id = id;
    figure.kind = read_kind(file, object.required<std::string>("kind"));
    figure.references = object.optional("references", false);
    figure.values = object.optional("values", Values());
    figure.rows = object.object("rows", read_axis).value_or(Axis());
    if (std::optional<Axis> pictures = object.object("pictures", read_axis))
        figure.rows = std::move(*pictures);
    figure.columns = object.object("columns", read_axis).value_or(Axis());
    figure.shot = object.object("shot", read_shot);
    figure.shots_of = object.optional("shots_of", std::vector<std::string>());
    figure.compared = object.object("compared", [](Object& compared) {
        return ComparedShots{compared.required<std::string>("as"), read_condition(compared)};
    });
    figure.reference = object.object("reference", [](Object& reference) {
        return ShownReferences{reference.required<std::string>("title"), read_condition(reference)};
    });
    figure.measured = object.objects("measured", read_measurement);
    figure.titles = object.optional("titles", std::vector<std::string>());
    figure.alt = object.optional("alt", std::string());
    figure.curves = object.objects("curves", read_curve);
    return figure;
}

} // namespace

PageData read_page_data(std::string_view file, std::string_view json)
{
    return Object::read_all(std::string(file), parsed(file, json), [](Object& page) {
        PageData data;
        data.sections = page.required<std::vector<std::string>>("sections");
        data.cover = page.object("cover", read_shot).value_or(ShotPattern()).shot;
        data.constants = page.required<Values>("constants");
        data.labels = page.required<Values>("labels");
        return data;
    });
}

Lists read_lists(std::string_view file, std::string_view json)
{
    try {
        return parsed(file, json).get<Lists>();
    } catch (const Json::exception&) {
        throw std::logic_error(text(file, ": not lists of values with fields of text"));
    }
}

std::vector<FigureData> read_figures(std::string_view file, std::string_view json)
{
    std::vector<FigureData> figures;
    const Json entries = parsed(file, json);
    for (const auto& [id, figure] : entries.items()) {
        const std::string& name = id;
        figures.push_back(Object::read_all(text(file, ": ", id), figure, [&](Object& object) {
            return read_figure(std::string(file), name, object);
        }));
    }
    return figures;
}

} // namespace lambent::report
