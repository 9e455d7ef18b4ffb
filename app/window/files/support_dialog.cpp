// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/files/support_dialog.h"

#include "vocabulary/refusal_text.h"
#include "widgets/help/help_topic.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/save_file.h"
#include "widgets/look/wrapped_label.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTreeWidget>

namespace codewheel {
namespace {

constexpr QSize supportSize(680, 560);
constexpr int noteLines = 3;
constexpr qsizetype mostShown = 50'000; // characters of a file in the preview
constexpr int sizeColumn = 1;
constexpr int whatColumn = 2;

QPlainTextEdit *noteField(QWidget *parent)
{
    auto *note = describe(new QPlainTextEdit(parent), "supportNote", SupportDialog::tr("What happened"),
                          SupportDialog::tr("Goes into the file as message.txt; may be left empty"));
    note->setPlaceholderText(SupportDialog::tr("What did you do, what happened, what should have happened?"));
    note->setTabChangesFocus(true);
    note->setMaximumHeight((noteLines + 1) * note->fontMetrics().lineSpacing());
    return note;
}

QPlainTextEdit *contentView(QWidget *parent)
{
    auto *content = describe(new QPlainTextEdit(parent), "supportContent", SupportDialog::tr("Content"),
                             SupportDialog::tr("What the chosen file contains"));
    content->setReadOnly(true);
    content->setTabChangesFocus(true);
    content->setLineWrapMode(QPlainTextEdit::NoWrap);
    content->setFont(numberFont(TextSize::small));
    return content;
}

} // namespace

SupportDialog::SupportDialog(std::vector<SupportFile> files, QWidget *parent)
    : QDialog(parent)
    , m_files(std::move(files))
    , m_note(noteField(this))
    , m_list(makeList())
    , m_content(contentView(this))
    , m_total(wrappedLabel(this, "supportTotal"))
    , m_message(new InlineMessage(this))
{
    setObjectName(QStringLiteral("supportDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Collect for support"));
    setHelpTopic(*this, "help.md#collect-for-support");
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_save = buttons->addButton(tr("&Save…"), QDialogButtonBox::ActionRole);
    describe(m_save, "supportSave", tr("Asks where to save the file; nothing is sent"));
    m_save->setDefault(true);
    layOutParts(buttons);
    connect(m_save, &QPushButton::clicked, this, &SupportDialog::askWhere);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_note, &QPlainTextEdit::textChanged, this, &SupportDialog::showChosen);
    connect(m_list, &QTreeWidget::itemChanged, this, &SupportDialog::showChosen);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &SupportDialog::look);
    m_list->setCurrentItem(m_list->topLevelItem(0));
    m_note->setFocus();
    showChosen();
    resize(supportSize);
}

void SupportDialog::layOutParts(QWidget *buttons)
{
    auto *what = wrappedLabel(this);
    what->setText(tr("One file with what is needed to look into a problem. It holds what is ticked here and "
                     "nothing else. The home folder, the user name in paths and the name of this computer "
                     "are removed. Nothing is sent: whom you give the file to is up to you."));
    layOutColumn(this, {what, m_note, {m_list, 2}, {m_content, 2}, m_total, m_message, buttons},
                 {grid::margin, allAround(grid::margin)});
}

QTreeWidget *SupportDialog::makeList()
{
    auto *list = describe(new QTreeWidget(this), "supportFiles", tr("Files"),
                          tr("What will be in the file; what is not ticked is left out (Space)"));
    list->setRootIsDecorated(false);
    list->setUniformRowHeights(true);
    list->setHeaderLabels({tr("File"), tr("Size"), tr("What it contains")});
    for (const SupportFile &file : m_files) {
        auto *row = new QTreeWidgetItem(
            list, {file.file.name, QLocale().formattedDataSize(file.file.bytes.size()), file.what});
        row->setCheckState(0, Qt::Checked);
        row->setTextAlignment(sizeColumn, Qt::AlignRight | Qt::AlignVCenter);
        row->setToolTip(whatColumn, file.what);
    }
    list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    return list;
}

std::vector<ZipEntry> SupportDialog::chosen() const
{
    std::vector<ZipEntry> files;
    if (const QString note = m_note->toPlainText().trimmed(); !note.isEmpty())
        files.push_back({QStringLiteral("message.txt"), (note + u'\n').toUtf8()});
    for (std::size_t i = 0; i < m_files.size(); ++i)
        if (m_list->topLevelItem(static_cast<int>(i))->checkState(0) == Qt::Checked)
            files.push_back(m_files[i].file);
    return files;
}

void SupportDialog::showChosen()
{
    qint64 size = 0;
    const auto files = chosen();
    for (const ZipEntry &file : files)
        size += file.bytes.size();
    m_total->setText(tr("%n files, %1 uncompressed", nullptr, static_cast<int>(files.size()))
                         .arg(QLocale().formattedDataSize(size)));
    m_save->setEnabled(!files.empty());
    m_message->withdraw();
}

void SupportDialog::look()
{
    const int row = m_list->indexOfTopLevelItem(m_list->currentItem());
    if (row < 0)
        return;
    const QString all = QString::fromUtf8(m_files[static_cast<std::size_t>(row)].file.bytes);
    m_content->setPlainText(all.size() > mostShown ? all.first(mostShown) + QChar(0x2026) : all);
}

void SupportDialog::askWhere()
{
    const QString name = QStringLiteral("codewheel-support-%1.zip")
                             .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd-HHmm")));
    const QString path = askSaveFile(this, tr("Save for support"), name, {tr("Zip files (*.zip)")});
    if (!path.isEmpty() && saveTo(path))
        accept();
}

bool SupportDialog::saveTo(const QString &path)
{
    const auto written = saveZip(path, chosen(), QDateTime::currentDateTime());
    if (!written) {
        m_message->showMessage(Role::fault, refusalText(written.error()));
        return false;
    }
    Q_EMIT saved(path);
    return true;
}

} // namespace codewheel
