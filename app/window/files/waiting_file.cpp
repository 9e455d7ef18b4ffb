// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/files/waiting_file.h"

#include "widgets/look/inline_message.h"

#include <QFileInfo>

#include <utility>

namespace codewheel {

WaitingFile::WaitingFile(InlineMessage &notice, Wish wish, QObject *parent)
    : QObject(parent)
    , m_notice(notice)
    , m_wish(std::move(wish))
{
    connect(&m_notice, &InlineMessage::closed, this, [this] { m_path.clear(); });
    connect(&m_notice, &InlineMessage::actionTriggered, this, &WaitingFile::actionTriggered);
}

void WaitingFile::open(const QString &path)
{
    m_path.clear();
    if (m_wish.isThere()) {
        m_notice.withdraw();
        Q_EMIT ready(path);
        return;
    }
    m_path = path;
    m_notice.showMessage(Role::attention, m_wish.sentence(QFileInfo(path).fileName()), m_wish.action);
}

void WaitingFile::lookAgain()
{
    if (!m_path.isEmpty() && m_wish.isThere())
        open(std::exchange(m_path, {}));
}

} // namespace codewheel
