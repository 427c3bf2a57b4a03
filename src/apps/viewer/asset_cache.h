// Scenes and environments shared by all sessions: loaded by a thread of their own, and again when their files change.
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

struct AssetCacheOptions {
    bool cache = true; ///< whether environments and shaders are cached in the user's folder
    cli::Backend backend = cli::Backend::automatic;
    std::function<void(const std::string&)> warn = [](const std::string&) {}; ///< as RendererChoice::warn
    bool strict = false;  ///< whether warnings about a file make loading it fail
    scene::Reach reach{}; ///< the files that a glTF may refer to
};

/// A panorama as read from its file, for the reference.
struct RawEnvironment {
    std::optional<image::RadianceImage> panorama; ///< unset: "none"
};

/// The state of a requested asset. After its file changed, `value` remains the old one until the new one is loaded; if
/// loading fails it remains, and `error` has the reason.
template <class T>
struct Found {
    std::shared_ptr<T> value;
    std::string error;    ///< one line; empty: none
    bool pending = false; ///< being loaded
};

/// All functions may be called from any thread.
class AssetCache {
public:
    explicit AssetCache(AssetCacheOptions options = {});
    AssetCache(const AssetCache&) = delete;
    AssetCache& operator=(const AssetCache&) = delete;
    ~AssetCache();

    /// Sets a function that the loading thread calls whenever an asset was loaded or failed to load. Waits for a
    /// running call of the old function, so that what that uses may be destroyed afterwards.
    void on_change(std::function<void()> changed);

    /// The scene that the arguments name, with their options for built-in shapes. Does not wait for loading.
    Found<Model> model(const cli::RenderArguments& arguments);

    /// The environment of this name. Does not wait for loading.
    Found<const cli::LoadedEnvironment> environment(const std::string& name);

    /// The panorama of this environment, not prepared for drawing. Does not wait for loading.
    Found<const RawEnvironment> raw_environment(const std::string& name);

    /// Waits until the scene and the environment are loaded. Throws Error if one cannot be.
    void load(const cli::RenderArguments& arguments);

    static constexpr int watch_ms = 300;   ///< how often files are checked for changes
    static constexpr int most_kept = 6;    ///< beyond this, assets that are not in use are dropped
    static constexpr int most_waiting = 8; ///< to be loaded; requests beyond it are ignored until repeated
    static constexpr std::size_t most_watched = 256; ///< files of one asset

private:
    using Asset = std::shared_ptr<void>;
    using NoteFiles = Model::NoteFiles;
    using Load = std::function<Asset(const NoteFiles&)>;
    /// Files, each with a signature that changes with the file.
    using Watch = std::map<std::string, std::string>;
    struct Slot {
        Asset value;
        std::string error, file; ///< `file` is empty for built-in assets
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
    void reload_changed();
    void drop_unused();

    const AssetCacheOptions options_;
    std::mutex mutex_;
    std::condition_variable wake_, done_;
    std::map<std::string, Slot> slots_;
    std::deque<std::string> waiting_;
    std::function<void()> changed_;
    std::uint64_t clock_ = 0;
    bool ending_ = false, calling_ = false;
    std::thread thread_; ///< last, as it uses the other members
};

} // namespace lambent::viewer
