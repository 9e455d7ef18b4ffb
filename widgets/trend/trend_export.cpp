// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/trend_export.h"

#include "project/file_access.h"

namespace codewheel {

TrendExport::TrendExport(std::unique_ptr<TrendFiles> files, Origin origin, QObject *parent)
    : QObject(parent)
    , m_files(std::move(files))
    , m_origin(std::move(origin))
{
    connect(&m_timer, &QTimer::timeout, this, &TrendExport::writePiece);
    m_timer.start(0);
}

void TrendExport::writePiece()
{
    if (!std::exchange(m_isBegun, true)) {
        if (const auto begun = m_files->begin(); !begun)
            return end(begun);
    }
    if (m_files->writeSome())
        Q_EMIT progressed(static_cast<int>(m_files->part() * 100));
    else
        end(m_files->finish(m_origin()));
}

void TrendExport::end(const Result<void> &written)
{
    m_timer.stop();
    Q_EMIT ended(written ? QString() : whyNotWritten(written.error()));
}

} // namespace codewheel
