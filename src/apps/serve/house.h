// What all connections share. All of it is used by the serving thread alone, but where it says otherwise.
#pragma once

#include "apps/serve/gate.h"
#include "apps/serve/server.h"

#include <atomic>
#include <memory>
#include <utility>

namespace lambent::serve {

struct House {
    ServerOptions options;
    viewer::ViewRequest start;
    viewer::FileList files;
    viewer::AssetCache& assets;       ///< any thread
    viewer::DrawScheduler& scheduler; ///< any thread
    Gate gate;
    int connections = 0, refusals = 0;
    std::atomic<int> sessions = 0; ///< any thread may read it
};

/// One place of a counted kind, given back at its end.
template <class Count>
class Seat {
public:
    explicit Seat(Count& count) : count_(&count) { ++count; }
    Seat(Seat&& other) noexcept : count_(std::exchange(other.count_, nullptr)) {}
    Seat& operator=(Seat&&) = delete;
    ~Seat()
    {
        if (count_)
            --*count_;
    }

private:
    Count* count_;
};

} // namespace lambent::serve
