#include "image/openexr/openexr_channels.h"

#include "image/refuse.h"

#include <algorithm>
#include <optional>

namespace lambent::image {
namespace {

const ExrChannel* find_channel(const ExrPart& part, const std::string& name)
{
    const auto found = std::ranges::find(part.channels, name, &ExrChannel::name);
    return found == part.channels.end() ? nullptr : &*found;
}

bool has_chroma(const ExrPart& part)
{
    return find_channel(part, "RY") || find_channel(part, "BY");
}

std::optional<ExrChoice> find_colour(const ExrPart& part)
{
    const auto in_layer = [&](const std::string& layer) -> std::optional<ExrChoice> {
        const ExrChoice choice{0, {layer + "R", layer + "G", layer + "B"}, false};
        const bool all = std::ranges::all_of(
            choice.channels, [&](const std::string& name) { return find_channel(part, name); });
        return all ? std::optional(choice) : std::nullopt;
    };
    if (auto colour = in_layer(""))
        return colour;
    for (const ExrChannel& channel : part.channels)
        if (auto colour = in_layer(channel.name.substr(0, channel.name.rfind('.') + 1)))
            return colour;
    if (!find_channel(part, "Y"))
        return std::nullopt;
    return ExrChoice{0, {"Y", "Y", "Y"}, has_chroma(part)};
}

[[noreturn]] void refuse_channels(const ExrHeader& header, const std::string& name)
{
    std::string channels;
    for (const ExrPart& part : header.parts) {
        if (part.deep)
            refuse(name, "deep images are not supported");
        for (const ExrChannel& channel : part.channels)
            channels += (channels.empty() ? "" : ", ") + channel.name;
    }
    refuse(name, "has no channels R, G and B and no Y; its channels are ", printable(channels));
}

// Refuses luminance-chroma images that the library's reader for them does not support.
void check_chroma(const ExrChoice& choice, const ExrPart& part, const std::string& name)
{
    if (choice.part != 0)
        refuse(name, "luminance-chroma (channels Y, RY, BY) is only read from the first part");
    for (const char* const chroma : {"RY", "BY"})
        if (const ExrChannel* channel = find_channel(part, chroma);
            channel && (channel->x_sampling != 2 || channel->y_sampling != 2))
            refuse(name, "its channel ", chroma, " is subsampled by ", channel->x_sampling, "x",
                   channel->y_sampling, "; luminance-chroma is read with 2x2");
}

} // namespace

ExrChoice choose_channels(const ExrHeader& header, const std::string& name)
{
    for (std::size_t i = 0; i < header.parts.size(); ++i) {
        const ExrPart& part = header.parts[i];
        std::optional<ExrChoice> choice = part.deep ? std::nullopt : find_colour(part);
        if (!choice)
            continue;
        choice->part = static_cast<int>(i);
        for (const std::string& wanted : choice->channels)
            if (const ExrChannel* channel = find_channel(part, wanted);
                channel->x_sampling != 1 || channel->y_sampling != 1)
                refuse(name, "its channel ", printable(wanted), " is subsampled, which is not supported");
        if (choice->luminance_chroma)
            check_chroma(*choice, part, name);
        return *choice;
    }
    refuse_channels(header, name);
}

std::optional<ExrChoice> choose_alpha(const ExrHeader& header, const ExrChoice& colour)
{
    const std::string& red = colour.channels[0];
    const std::string alpha = red.substr(0, red.rfind('.') + 1) + "A";
    const ExrChannel* const channel =
        find_channel(header.parts[static_cast<std::size_t>(colour.part)], alpha);
    if (!channel || channel->x_sampling != 1 || channel->y_sampling != 1)
        return std::nullopt;
    return ExrChoice{colour.part, {alpha, alpha, alpha}, false};
}

} // namespace lambent::image
