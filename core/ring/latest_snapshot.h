// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ring/snapshot.h"

#include <memory>
#include <mutex>

namespace codewheel {

// Hands the newest snapshot from the bus thread to the window. Whoever takes one gets all edges since the one
// taken before, whatever the number of cycles between. Any thread.
class LatestSnapshot
{
public:
    // `newest` carries the edges of its own cycle only. Allocates only after a snapshot was taken.
    void publish(const Snapshot &newest);
    // Nothing if nothing was published since.
    std::shared_ptr<const Snapshot> take();

private:
    std::mutex m_mutex;
    std::shared_ptr<Snapshot> m_untaken;
};

} // namespace codewheel
