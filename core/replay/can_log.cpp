// SPDX-License-Identifier: GPL-3.0-or-later
#include "replay/can_log.h"

#include "can/can_refusals.h"

#include <algorithm>

namespace codewheel {

CanLog::CanLog(QString path, std::string interface)
    : m_path(std::move(path))
    , m_interface(std::move(interface))
    , m_file(m_path)
{}

Result<void> CanLog::open()
{
    m_file.close();
    m_frames.clear();
    m_faults = 0;
    m_latest = Instant::min();
    if (!m_file.open(QIODevice::ReadOnly))
        return refuse(RefusalKind::badInput, RefusalId::fileNotReadable, {m_path, m_file.errorString()});
    m_reader = std::make_unique<CanLogReader>([this](const CanFrame &frame) { m_frames.push_back(frame); },
                                              [this](std::int64_t, CanLogFault) { ++m_faults; });
    return {};
}

Result<CanLogSummary> CanLog::look()
{
    if (auto opened = open(); !opened)
        return tl::unexpected(opened.error());
    CanLogSummary summary{.interface = m_interface};
    for (bool isMore = true; isMore;) {
        isMore = readSome();
        for (const CanFrame &frame : std::exchange(m_frames, {}))
            count(frame, summary);
    }
    summary.faults = m_faults;
    summary.isSince1970 = m_reader->isSince1970();
    if (m_reader->frames() == 0)
        return refuse(RefusalKind::badInput, CanRefusalId::logEmpty, {m_path});
    if (!m_reader->times())
        return refuse(RefusalKind::badInput, CanRefusalId::logHasNoTimes, {m_path});
    if (summary.frames == 0)
        return refuse(RefusalKind::badInput, CanRefusalId::logHasNotThat,
                      {m_path, QString::fromStdString(m_interface)});
    return summary;
}

void CanLog::count(const CanFrame &frame, CanLogSummary &summary) const
{
    if (!frame.time)
        return;
    if (summary.frames == 0 && m_interface.empty())
        summary.interface = frame.interface;
    if (frame.interface != summary.interface) {
        ++summary.otherFrames;
        return;
    }
    if (++summary.frames == 1)
        summary.first = *frame.time;
    summary.last = std::max(summary.last, *frame.time);
    if (!frame.isExtended && !frame.isError)
        summary.identifiers.insert(frame.id);
}

const CanFrame *CanLog::next()
{
    for (;;) {
        while (!m_frames.empty()) {
            CanFrame &frame = m_frames.front();
            if (m_interface.empty() && frame.time)
                m_interface = frame.interface;
            if (frame.time && frame.interface == m_interface) {
                m_latest = std::max(m_latest, *frame.time);
                frame.time = m_latest;
                return &frame;
            }
            m_frames.pop_front();
        }
        if (!readSome() && m_frames.empty())
            return nullptr;
    }
}

bool CanLog::readSome()
{
    constexpr qint64 piece = 65'536;
    if (!m_file.isOpen())
        return false;
    const QByteArray bytes = m_file.read(piece);
    m_reader->read({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    if (!bytes.isEmpty())
        return true;
    m_reader->finish();
    m_file.close();
    return false;
}

} // namespace codewheel
