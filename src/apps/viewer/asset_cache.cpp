#include "apps/viewer/asset_cache.h"

#include "apps/common/console.h"
#include "apps/common/reference_setup.h"
#include "base/text.h"
#include "environment/builtin/builtin.h"
#include "scene/builtin/builtin.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <new>
#include <utility>

namespace lambent::viewer {
namespace {

// A text that differs when the file was changed; "" if there is no such file.
std::string signature_of(const std::string& file)
{
    std::error_code error;
    const auto time = std::filesystem::last_write_time(file, error);
    if (error)
        return "";
    return text(time.time_since_epoch().count(), " ", std::filesystem::file_size(file, error));
}

bool has_changed(const std::map<std::string, std::string>& watch)
{
    return std::any_of(watch.begin(), watch.end(),
                       [](const auto& file) { return signature_of(file.first) != file.second; });
}

// Watches `file` and `others` instead of what was watched before. Files that are new here have not been read yet.
void watch_files(const std::vector<std::filesystem::path>& others, const std::string& file,
                 std::map<std::string, std::string>& watch)
{
    std::map<std::string, std::string> next = {{file, watch.at(file)}};
    for (const std::filesystem::path& path : others) {
        const std::string name = path.string();
        if (next.size() < AssetCache::most_watched)
            next.emplace(name, watch.contains(name) ? watch.at(name) : signature_of(name));
    }
    watch = std::move(next);
}

std::string model_key(const cli::RenderArguments& arguments)
{
    const auto color = [](const std::optional<glm::vec3>& c) {
        return c ? text(c->r, ",", c->g, ",", c->b) : std::string("-");
    };
    const scene::BuiltinOptions& options = arguments.builtin;
    return text("model\n", arguments.scene, "\n", color(options.diffuse), " ", color(options.specular), " ",
                options.exponent.value_or(0.0f), " ", options.density);
}

// "" for environments without a file.
std::string file_of_environment(const std::string& name)
{
    return name == "none" || environment::is_builtin(name) ? "" : name;
}

} // namespace

AssetCache::AssetCache(AssetCacheOptions options) : options_(std::move(options)), thread_([this] { work(); })
{
}

AssetCache::~AssetCache()
{
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    wake_.notify_all();
    thread_.join();
}

void AssetCache::on_change(std::function<void()> changed)
{
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return !calling_; });
    changed_ = std::move(changed);
}

template <class T>
Found<T> AssetCache::find(const std::string& key, const std::string& file, const Load& load)
{
    const std::lock_guard lock(mutex_);
    Slot& slot = slots_[key];
    slot.used = ++clock_;
    if (!slot.loaded && !slot.busy && waiting_.size() < most_waiting) {
        slot.load = load;
        slot.file = file;
        if (!file.empty())
            slot.watch = {{file, ""}};
        slot.busy = true;
        waiting_.push_back(key);
        wake_.notify_all();
    }
    return {std::static_pointer_cast<T>(slot.value), slot.error, !slot.loaded || slot.busy};
}

Found<Model> AssetCache::model(const cli::RenderArguments& arguments)
{
    const std::string file = scene::is_builtin(arguments.scene) ? "" : arguments.scene;
    return find<Model>(model_key(arguments), file, [arguments, options = options_](const NoteFiles& note) {
        const cli::RendererChoice backend = {options.backend, options.cache, options.warn};
        auto model = std::make_shared<Model>(arguments, backend, note, options.reach);
        if (options.strict)
            cli::refuse_warnings(model->warnings());
        return model;
    });
}

Found<const cli::LoadedEnvironment> AssetCache::environment(const std::string& name)
{
    return find<const cli::LoadedEnvironment>(
        text("environment\n", name), file_of_environment(name), [name, options = options_](const NoteFiles&) {
            auto loaded =
                std::make_shared<cli::LoadedEnvironment>(cli::load_environment(name, options.cache));
            if (options.strict)
                cli::refuse_warnings(loaded->warnings);
            return loaded;
        });
}

Found<const RawEnvironment> AssetCache::raw_environment(const std::string& name)
{
    return find<const RawEnvironment>(text("raw\n", name), file_of_environment(name),
                                      [name](const NoteFiles&) {
                                          Warnings said_already;
                                          return std::make_shared<RawEnvironment>(
                                              RawEnvironment{cli::load_raw_environment(name, said_already)});
                                      });
}

AssetCache::Slot& AssetCache::wait_for(const std::string& key, std::unique_lock<std::mutex>& lock)
{
    done_.wait(lock, [&] { return slots_[key].loaded; });
    Slot& slot = slots_[key];
    if (!slot.error.empty())
        throw Error(slot.failure, slot.error);
    return slot;
}

void AssetCache::load(const cli::RenderArguments& arguments)
{
    // At a program's start the queue is empty, so neither request is ignored.
    model(arguments);
    environment(arguments.environment);
    std::unique_lock lock(mutex_);
    wait_for(model_key(arguments), lock);
    wait_for(text("environment\n", arguments.environment), lock);
}

void AssetCache::work()
{
    std::unique_lock lock(mutex_);
    while (!ending_) {
        if (waiting_.empty()) {
            wake_.wait_for(lock, std::chrono::milliseconds(watch_ms));
            reload_changed();
        } else {
            load_one(lock);
        }
    }
}

void AssetCache::load_one(std::unique_lock<std::mutex>& lock)
{
    const std::string key = waiting_.front();
    waiting_.pop_front();
    const Load load = slots_[key].load;
    const std::string file = slots_[key].file;
    Watch watch = slots_[key].watch;
    lock.unlock();
    // Taken before loading, so that a file written during it is loaded again.
    for (auto& [name, signature] : watch)
        signature = signature_of(name);
    const auto note = [&](const std::vector<std::filesystem::path>& others) {
        watch_files(others, file, watch);
    };
    Asset value;
    std::string problem;
    Failure failure = Failure::bad_input;
    try {
        value = load(note);
    } catch (const Error& error) {
        problem = one_line(error.what());
        failure = error.failure();
    } catch (const std::bad_alloc&) {
        problem = text(file, ": not enough memory");
        failure = Failure::no_device;
    } catch (const std::exception& error) {
        problem = one_line(error.what());
    }
    lock.lock();
    Slot& slot = slots_[key];
    if (value)
        slot.value = std::move(value);
    slot.error = std::move(problem);
    slot.failure = failure;
    slot.watch = std::move(watch);
    slot.loaded = true;
    slot.busy = false;
    drop_unused();
    done_.notify_all();
    if (!changed_)
        return;
    calling_ = true;
    lock.unlock();
    changed_(); // on_change() does not replace it while calling_ is set
    lock.lock();
    calling_ = false;
    done_.notify_all();
}

void AssetCache::reload_changed()
{
    for (auto& [key, slot] : slots_)
        if (slot.loaded && !slot.busy && has_changed(slot.watch)) {
            slot.busy = true;
            waiting_.push_back(key);
        }
}

void AssetCache::drop_unused()
{
    while (slots_.size() > most_kept) {
        auto oldest = slots_.end();
        for (auto i = slots_.begin(); i != slots_.end(); ++i)
            if (!i->second.busy && i->second.value.use_count() <= 1 &&
                (oldest == slots_.end() || i->second.used < oldest->second.used))
                oldest = i;
        if (oldest == slots_.end() || oldest->second.used == clock_)
            return;
        slots_.erase(oldest);
    }
}

} // namespace lambent::viewer
