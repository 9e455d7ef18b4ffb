// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ring/command.h"

#include <deque>
#include <mutex>
#include <optional>

namespace codewheel {

// Carries commands from the window to the bus thread, in order. Any thread.
class CommandQueue
{
public:
    void post(Command command)
    {
        const std::scoped_lock lock(m_mutex);
        m_commands.push_back(std::move(command));
    }
    std::optional<Command> next()
    {
        const std::scoped_lock lock(m_mutex);
        if (m_commands.empty())
            return std::nullopt;
        std::optional<Command> command(std::move(m_commands.front()));
        m_commands.pop_front();
        return command;
    }

private:
    std::mutex m_mutex;
    std::deque<Command> m_commands;
};

} // namespace codewheel
