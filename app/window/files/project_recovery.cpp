// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/files/project_recovery.h"

#include "app/window/files/project_files.h"
#include "vocabulary/refusal_text.h"
#include "widgets/look/inline_message.h"
#include "widgets/project/project_document.h"

#include <QFileInfo>
#include <QLocale>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr auto keepPeriod = 30s;

} // namespace

ProjectRecovery::ProjectRecovery(ProjectDocument &document, const QString &folder, QObject *parent)
    : QObject(parent)
    , m_document(document)
    , m_recovery(folder)
    , m_left(leftProjects(folder))
{
    connect(&m_timer, &QTimer::timeout, this, &ProjectRecovery::keep);
    connect(&document, &ProjectDocument::savedChanged, this, [this](bool isSaved) {
        if (isSaved)
            m_recovery.drop();
    });
    m_timer.start(keepPeriod);
}

ProjectRecovery::~ProjectRecovery()
{
    m_recovery.drop();
}

void ProjectRecovery::setPeriod(std::chrono::seconds period)
{
    m_timer.start(period);
}

void ProjectRecovery::keep()
{
    if (m_document.isSaved())
        return;
    const auto kept = m_recovery.keep(m_document.project(), m_document.file(),
                                      QDateTime::currentDateTimeUtc(), m_document.fileMark());
    if (!kept)
        Q_EMIT told({.severity = Severity::attention, .id = MessageId::refused, .refusal = kept.error()});
}

void ProjectRecovery::ask(InlineMessage &notice, ProjectFiles &files)
{
    m_notice = &notice;
    m_files = &files;
    connect(&notice, &InlineMessage::actionTriggered, this, &ProjectRecovery::recover);
    connect(&notice, &InlineMessage::otherActionTriggered, this, [this] {
        m_left.front().drop();
        m_left.erase(m_left.begin());
        showNext();
    });
    showNext();
}

void ProjectRecovery::showNext()
{
    if (m_left.empty()) {
        m_notice->withdraw();
        return;
    }
    const LeftProject &left = m_left.front();
    const QString name =
        left.path().isEmpty() ? tr("a project that was never saved") : QFileInfo(left.path()).fileName();
    const QString when = QLocale().toString(left.keptAt().toLocalTime(), QLocale::ShortFormat);
    m_notice->showMessage(
        Role::attention, tr("Codewheel ended unexpectedly. Changes of %1 are kept as of %2.").arg(name, when),
        tr("Recover"), tr("Discard"));
}

void ProjectRecovery::recover()
{
    if (!m_files->mayClose())
        return;
    auto project = m_left.front().load();
    if (!project) {
        m_notice->showMessage(Role::fault, refusalText(project.error()), {}, tr("Discard"));
        return;
    }
    const QString path = m_left.front().path();
    m_document.setProject(std::move(*project), path, m_left.front().mark());
    m_document.setRecovered();
    keep(); // before discarding what was left
    m_left.front().drop();
    m_left.erase(m_left.begin());
    Q_EMIT told({.severity = Severity::information, .id = MessageId::projectRecovered, .arguments = {path}});
    showNext();
}

} // namespace codewheel
