// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/waiting_cams.h"

#include "widgets/look/inline_message.h"

#include <QAction>
#include <QFileInfo>

#include <utility>

namespace codewheel {

WaitingCams::WaitingCams(InlineMessage &notice, const QAction &cams, QObject *parent)
    : QObject(parent)
    , m_notice(notice)
    , m_cams(cams)
{
    connect(&m_notice, &InlineMessage::closed, this, [this] { m_path.clear(); });
    connect(
        &m_cams, &QAction::enabledChanged, this,
        [this] {
            if (!m_path.isEmpty() && m_cams.isEnabled())
                open(std::exchange(m_path, {}));
        },
        Qt::QueuedConnection); // once all views show that encoder
}

void WaitingCams::open(const QString &path)
{
    m_path.clear();
    if (m_cams.isEnabled()) {
        m_notice.withdraw();
        Q_EMIT ready(path);
        return;
    }
    m_path = path;
    m_notice.showMessage(
        Role::attention,
        tr("%1 has cam programs: choose an encoder with cams in the bus structure, and they are "
           "opened for it.")
            .arg(QFileInfo(path).fileName()));
}

} // namespace codewheel
