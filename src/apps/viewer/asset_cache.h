// Scenes and environments, shared by all viewers: loaded in a thread of their own, loaded again when files change.
#pragma once

#include "apps/options/arguments.h"
#include "apps/common/load_environment.h"
#include "apps/viewer/model.h"

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace lambent::viewer {

struct StockOptions {
    bool cache = true; ///< of environments and shaders, in the user's folder
    cli::Backend backend = cli::Backend::automatic;
    std::function<void(const std::string&)> warn = [](const std::string&) {}; ///< as cli::RendererChoice's
    bool strict = false;  ///< what files are warned of is an error
    scene::Reach reach{}; ///< how far what a glTF names may lead
};

/// A panorama as it is in its file, for the reference.
struct RawEnvironment {
    std::optional<image::RadianceImage> panorama; ///< unset: "none"
};

/// What is there of something asked for. After a file changed `value` is the old one until the new one is loaded, and
/// stays it, with the reason as `error`, if that cannot be.
template <class T>
struct Found {
    std::shared_ptr<T> value;
    std::string error;    ///< one line; empty: none
    bool pending = false; ///< it is being loaded
};

/// Safe for many threads.
class AssetCache {
public:
    explicit AssetCache(StockOptions options = {});
    AssetCache(const AssetCache&) = delete;
    AssetCache& operator=(const AssetCache&) = delete;
    ~AssetCache();

    /// Called, from the loading thread, whenever something asked for was loaded or failed to. Waits for a call that is under
    /// way: what the old function used may then go.
    void on_change(std::function<void()> changed);

    /// The scene that the arguments name, with their options for built-in shapes. Never waits.
    Found<Model> model(const cli::RenderArguments& arguments);

    /// The environment of this name. Never waits.
    Found<const cli::LoadedEnvironment> environment(const std::string& name);

    /// The same environment unprepared. Never waits.
    Found<const RawEnvironment> raw_environment(const std::string& name);

    /// Waits until both were loaded. Throws Error if one could not be.
    void load(const cli::RenderArguments& arguments);

    /// How often files are looked at, and how much is kept that nobody looks at.
    static constexpr int watch_ms = 300, most_kept = 6, most_waiting = 8;
    static constexpr std::size_t most_watched = 256; ///< files of one thing

private:
    using Thing = std::shared_ptr<void>;
    using NoteFiles = Model::NoteFiles;
    using Load = std::function<Thing(const NoteFiles&)>;
    /// Files, and what tells that they have changed since they were read.
    using Watch = std::map<std::string, std::string>;
    struct Slot {
        Thing value;
        std::string error, file; ///< no file: built-in
        Watch watch;
        Failure failure = Failure::bad_input;
        Load load;
        bool loaded = false, busy = false;
        std::uint64_t used = 0;
    };

    template <class T>
    Found<T> find(const std::string& key, const std::string& file, const Load& load);
    Slot& wait_for(const std::string& key, std::unique_lock<std::mutex>& lock);
    void work();
    void load_one(std::unique_lock<std::mutex>& lock);
    void look_at_files();
    void drop_unused();

    const StockOptions options_;
    std::mutex mutex_;
    std::condition_variable wake_, done_;
    std::map<std::string, Slot> slots_;
    std::deque<std::string> waiting_;
    std::function<void()> changed_;
    std::uint64_t clock_ = 0;
    bool ending_ = false, calling_ = false;
    std::thread thread_; ///< last: it uses the others
};

} // namespace lambent::viewer
