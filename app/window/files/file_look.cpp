// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/files/file_look.h"

#include <QFileInfo>

#include <mutex>
#include <thread>
#include <utility>
#include <vector>

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

// Outlives the object while a thread is waiting.
struct FileLook::Mail
{
    std::mutex mutex;
    FileLook *to;
    std::vector<std::pair<QString, RecentFile::State>> found;
};

FileLook::FileLook(QObject *parent)
    : QObject(parent)
    , m_mail(std::make_shared<Mail>())
{
    m_mail->to = this;
    m_patience.setSingleShot(true);
    m_patience.setInterval(patience);
    connect(&m_patience, &QTimer::timeout, this, &FileLook::callSilent);
    connect(this, &FileLook::hasMail, this, &FileLook::takeMail, Qt::QueuedConnection);
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
        mail->found.emplace_back(path, state);
        if (mail->to)
            Q_EMIT mail->to->hasMail();
    }).detach();
}

void FileLook::takeMail()
{
    const auto found = [this] {
        const std::lock_guard lock(m_mail->mutex);
        return std::exchange(m_mail->found, {});
    }();
    bool isNew = false;
    for (const auto &[path, state] : found) {
        m_pending.erase(path);
        isNew |= std::exchange(m_states[path], state) != state;
    }
    if (isNew)
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
