// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/file_look.h"

#include <QFileInfo>

#include <mutex>
#include <thread>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr auto patience = 1500ms;

RecentFile::State lookAt(const QString &path)
{
    const QFileInfo file(path);
    return !file.isFile()      ? RecentFile::State::missing
           : file.isReadable() ? RecentFile::State::there
                               : RecentFile::State::notReadable;
}

} // namespace

// Outlives the object as long as a thread waits.
struct FileLook::Mail
{
    std::mutex mutex;
    FileLook *to;
};

FileLook::FileLook(QObject *parent)
    : QObject(parent)
    , m_mail(std::make_shared<Mail>())
{
    m_mail->to = this;
    m_patience.setSingleShot(true);
    m_patience.setInterval(patience);
    connect(&m_patience, &QTimer::timeout, this, &FileLook::callSilent);
}

FileLook::~FileLook()
{
    const std::lock_guard lock(m_mail->mutex);
    m_mail->to = nullptr;
}

RecentFile::State FileLook::state(const QString &path) const
{
    const auto found = m_states.find(path);
    return found == m_states.end() ? RecentFile::State::unknown : found->second;
}

void FileLook::look(const QString &path)
{
    if (path.isEmpty() || !m_pending.emplace(path, state(path)).second)
        return;
    m_patience.start();
    std::thread([path, mail = m_mail] {
        const RecentFile::State state = lookAt(path);
        const std::lock_guard lock(mail->mutex);
        if (FileLook *to = mail->to)
            QMetaObject::invokeMethod(
                to, [to, path, state] { to->take(path, state); }, Qt::QueuedConnection);
    }).detach();
}

void FileLook::take(const QString &path, RecentFile::State state)
{
    m_pending.erase(path);
    if (std::exchange(m_states[path], state) != state)
        Q_EMIT changed();
}

void FileLook::callSilent()
{
    for (const auto &[path, before] : m_pending)
        m_states[path] = RecentFile::State::silent;
    if (!m_pending.empty())
        Q_EMIT changed();
}

} // namespace codewheel
