#include "apps/view/view_window.h"

#include "apps/common/console.h"
#include "apps/common/interrupt.h"
#include "apps/common/threads.h"
#include "apps/view/window_settings.h"
#include "apps/view/view.h"
#include "apps/viewer/load_first.h"

#include <vector>

namespace lambent::view_window {
namespace {

WindowSettings remembered(const cli::Console& console)
{
    std::string complaint;
    WindowSettings settings = load_settings(complaint);
    if (!complaint.empty())
        console.warn({complaint});
    return settings;
}

std::vector<std::filesystem::path> folders(const cli::RenderArguments& picture)
{
    std::vector<std::filesystem::path> folders = viewer::folders_named(picture);
    if (folders.empty())
        folders.emplace_back(".");
    return folders;
}

} // namespace

void run(const cli::ViewArguments& arguments)
{
    const cli::RenderArguments& picture = arguments.start.picture;
    const cli::ThreadLimit limit(picture.common.threads);
    const cli::Console console(picture.common.verbosity);
    const WindowSettings before = remembered(console);
    WindowSettings settings = before;
    const bool has_size = arguments.start.given("size");
    if (has_size)
        settings.place = {picture.settings.width, picture.settings.height, before.place.corner, false};
    viewer::AssetCache assets({picture.cache,
                               picture.backend,
                               [&](const std::string& line) { console.warn({line}); },
                               picture.common.strict,
                               {true, {}}});
    const viewer::ViewRequest start = viewer::load_first(arguments.start, assets, console);
    // Only from here on does an interrupt have to wait for pictures that are being saved.
    const cli::Interrupt interrupt;
    View view(start, settings, viewer::FileList(folders(picture)), assets);
    settings = view.run([&] { return interrupt.asked(); });
    if (has_size) // --size is for this run only
        settings.place = before.place;
    save_settings(settings);
}

} // namespace lambent::view_window
