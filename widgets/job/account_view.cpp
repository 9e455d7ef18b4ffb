// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/account_view.h"

#include "project/file_access.h"
#include "report/html_report.h"
#include "report/transfer_report.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/save_file.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QPlainTextEdit>
#include <QPushButton>

namespace codewheel {

AccountView::AccountView(QWidget *parent)
    : QWidget(parent)
    , m_text(new QPlainTextEdit(this))
    , m_save(new QPushButton(lineIcon(Icon::save), tr("&Save…"), this))
    , m_copy(new QPushButton(lineIcon(Icon::copy), tr("C&opy"), this))
    , m_message(new InlineMessage(this))
{
    m_text->setReadOnly(true);
    m_text->setTabChangesFocus(true);
    m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_text->setFont(numberFont());
    describe(m_text, "account", tr("What was written where"), tr("What became of each value"));
    describe(m_save, "saveAccount", tr("As plain text, or as a web page if the name ends in .html"));
    describe(m_copy, "copyAccount", tr("Copies the text"));
    layOutColumn(this, {{m_text, 1}, m_message, layOutRow({m_save, m_copy, Stretch{1}})},
                 {.spacing = grid::margin, .margins = QMargins()});
    setFocusProxy(m_save);
    connect(m_save, &QPushButton::clicked, this, &AccountView::saveAs);
    connect(m_copy, &QPushButton::clicked, this, &AccountView::copy);
}

void AccountView::show(const Report &report, const QString &fileName)
{
    m_report = report;
    m_fileName = fileName;
    m_message->withdraw();
    m_text->setPlainText(reportAsText(report));
}

void AccountView::saveAs()
{
    const QString path =
        askSaveFile(this, tr("Save what was written where"), m_fileName + QStringLiteral(".txt"),
                    tr("Text (*.txt);;Web page (*.html)").split(QStringLiteral(";;")));
    if (!path.isEmpty())
        saveTo(path);
}

bool AccountView::saveTo(const QString &path)
{
    const bool asHtml = path.endsWith(QStringLiteral(".html"), Qt::CaseInsensitive);
    const QByteArray bytes = asHtml ? reportAsHtml(m_report) : reportAsText(m_report).toUtf8();
    const auto isSaved = replaceFile(path, bytes, OldFile::goes);
    if (isSaved) {
        m_message->showMessage(Role::running, tr("Saved as %1.").arg(path));
        Q_EMIT saved(path);
    } else {
        m_message->showMessage(
            Role::fault,
            tr("%1 was not saved: %2. Choose another place.").arg(path, whyNotWritten(isSaved.error())));
    }
    return isSaved.has_value();
}

void AccountView::copy()
{
    QGuiApplication::clipboard()->setText(m_text->toPlainText());
    m_message->showMessage(Role::running, tr("Copied."));
}

} // namespace codewheel
