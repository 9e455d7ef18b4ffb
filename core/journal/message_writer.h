// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "journal/stored_message.h"

#include <vector>

class QIODevice;

namespace codewheel {

class ToldBusNames;

// Writes messages to a file, piece by piece, so that a million of them need no memory. The device reports
// errors (QIODevice::errorString). Used by window and command line.
class MessageWriter
{
public:
    enum class Format {
        csv,  // RFC 4180, UTF-8: time (ISO 8601 with offset from UTC), severity, place, code, text; all but
              // the text is the same in every language
        html, // one page, in the user's language
    };

    // `names`: of buses when the messages were told. They outlive it; null: the names of now.
    MessageWriter(QIODevice &device, Format format, const ToldBusNames *names = nullptr)
        : m_device(device)
        , m_format(format)
        , m_names(names)
    {}

    // "csv" or "html", by the ending of a file's name; empty for any other.
    static std::optional<Format> formatOf(const QString &fileName);

    bool begin();
    bool write(const std::vector<StoredMessage> &messages);
    bool end();

private:
    bool put(const QString &text);

    QIODevice &m_device;
    Format m_format;
    const ToldBusNames *m_names;
};

} // namespace codewheel
