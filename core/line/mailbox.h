// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <utility>
#include <vector>

namespace codewheel {

// Carries things from one thread to another, in order. Any thread.
template <typename T>
class Mailbox
{
public:
    void post(T thing)
    {
        const std::scoped_lock lock(m_mutex);
        m_things.push_back(std::move(thing));
    }
    std::vector<T> takeAll()
    {
        const std::scoped_lock lock(m_mutex);
        return std::exchange(m_things, {});
    }
    std::size_t size() const
    {
        const std::scoped_lock lock(m_mutex);
        return m_things.size();
    }

private:
    mutable std::mutex m_mutex;
    std::vector<T> m_things;
};

} // namespace codewheel
