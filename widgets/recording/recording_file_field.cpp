// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/recording/recording_file_field.h"

#include "vocabulary/refusal_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/look/save_file.h"
#include "widgets/look/wrapped_label.h"

#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QPushButton>

namespace codewheel {
namespace {

const QString recordingSuffix = QStringLiteral(".cwrec");

bool isTaken(const QFileInfo &file)
{
    return file.exists() || file.isSymLink();
}

} // namespace

RecordingFileField::RecordingFileField(QWidget *parent)
    : QWidget(parent)
    , m_line(describe(new QLineEdit(this), "recordingFile", tr("File"),
                      tr("The file of the recording; it must not be there yet")))
    , m_mark(*m_line)
    , m_wrong(wrappedLabel(this, "recordingFileWrong"))
{
    auto *choose = describe(new QPushButton(lineIcon(Icon::open), tr("C&hoose…"), this),
                            "chooseRecordingFile", tr("Asks for folder and name of the file"));
    choose->setAutoDefault(false);
    m_wrong->setFont(textFont(TextSize::small));
    m_wrong->setTextFormat(Qt::PlainText);
    layOutColumn(this,
                 {layOutRow({{m_line, 1}, choose}, {.spacing = grid::unit, .margins = QMargins()}), m_wrong},
                 {.spacing = grid::unit, .margins = QMargins()});
    setFocusProxy(m_line);
    connect(m_line, &QLineEdit::textChanged, this, &RecordingFileField::check);
    connect(choose, &QPushButton::clicked, this, &RecordingFileField::browse);
}

QString RecordingFileField::file() const
{
    const QString name = m_line->text().trimmed();
    if (name.isEmpty() || name.endsWith(u'/'))
        return {};
    const QString path = QDir::cleanPath(QDir(m_folder).absoluteFilePath(name));
    return QFileInfo(path).suffix().isEmpty() ? path + recordingSuffix : path;
}

void RecordingFileField::propose(const QString &folder, const QDateTime &now)
{
    m_folder = folder;
    const QString name = now.toString(QStringLiteral("yyyy-MM-dd-HHmm")); // it is in front of every place
    QString path = QDir(folder).filePath(name + recordingSuffix);
    for (int i = 2; isTaken(QFileInfo(path)); ++i)
        path = QDir(folder).filePath(QStringLiteral("%1-%2").arg(name).arg(i) + recordingSuffix);
    m_line->setText(path);
    check();
}

QString RecordingFileField::complaint() const
{
    const QString path = file();
    if (path.isEmpty())
        return tr("Name a file.");
    const QFileInfo its(path);
    if (isTaken(its))
        return refusalText({RefusalKind::badInput, RefusalId::recordingExists, {path}});
    const QFileInfo folder(its.path());
    if (!folder.isDir())
        return tr("There is no folder %1.").arg(its.path());
    if (!folder.isWritable())
        return tr("Nothing may be saved in the folder %1.").arg(its.path());
    return {};
}

void RecordingFileField::check()
{
    const QString wrong = complaint();
    m_mark.show(wrong);
    m_wrong->setText(wrong);
    m_wrong->setVisible(!wrong.isEmpty());
    Q_EMIT changed();
}

void RecordingFileField::browse()
{
    const QFileInfo proposed(file());
    QFileDialog dialog(this, tr("File of the recording"), proposed.absolutePath());
    setSaveFilters(dialog, {tr("Recordings (*.cwrec)")});
    dialog.setOption(QFileDialog::DontConfirmOverwrite); // it never is
    dialog.selectFile(proposed.fileName());
    if (dialog.exec() == QDialog::Accepted)
        m_line->setText(dialog.selectedFiles().value(0));
}

} // namespace codewheel
