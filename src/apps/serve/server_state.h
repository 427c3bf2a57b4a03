// The state that all connections of a server share. It is used by the serving thread alone, except where noted.
#pragma once

#include "apps/serve/gate.h"
#include "apps/serve/server.h"

#include <atomic>
#include <memory>
#include <utility>

namespace lambent::serve {

struct ServerState {
    ServerOptions options;
    viewer::ViewRequest start;
    viewer::FileList files;
    viewer::AssetCache& assets;       ///< for any thread
    viewer::DrawScheduler& scheduler; ///< for any thread
    Gate gate;
    int connections = 0, refusals = 0;
    std::atomic<int> sessions = 0; ///< any thread may read this
};

/// Counts one connection or session for as long as it lives.
template <class Count>
class Counted {
public:
    explicit Counted(Count& count) : count_(&count) { ++count; }
    Counted(Counted&& other) noexcept : count_(std::exchange(other.count_, nullptr)) {}
    Counted& operator=(Counted&&) = delete;
    ~Counted()
    {
        if (count_)
            --*count_;
    }

private:
    Count* count_;
};

} // namespace lambent::serve
