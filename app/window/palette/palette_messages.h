// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/palette/palette_source.h"

#include <functional>

namespace codewheel {

class MessageModel;

// The messages that the messages panel lists, the newest first, for the command palette.
class PaletteMessages : public PaletteSource
{
public:
    // The model outlives it. `show` takes the id of a message.
    PaletteMessages(const MessageModel &messages, std::function<void(qint64)> show);

    void begin() override;
    std::vector<PaletteEntry> next() override;

private:
    const MessageModel &m_messages;
    const std::function<void(qint64)> m_show;
    qint64 m_before = 0; // id; only older ones are still to be given
    int m_left = 0;
};

} // namespace codewheel
