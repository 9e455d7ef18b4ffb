// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/save_file.h"

#include "widgets/help/help_topic.h"

#include <QFileDialog>

namespace codewheel {
namespace {

// "csv" from "Tables (*.csv)" and from "Tables (*.csv *.txt)"
QString suffixOf(const QString &filter)
{
    return filter.section(QStringLiteral("*."), 1, 1).section(u')', 0, 0).trimmed();
}

} // namespace

void setSaveFilters(QFileDialog &dialog, const QStringList &filters)
{
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters(filters);
    dialog.setDefaultSuffix(suffixOf(filters.front()));
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog,
                     [&dialog](const QString &filter) { dialog.setDefaultSuffix(suffixOf(filter)); });
}

QString askSaveFile(QWidget *parent, const QString &title, const QString &proposed,
                    const QStringList &filters, const char *helpTopic)
{
    const QFileInfo file(proposed);
    QFileDialog dialog(parent, title, file.absolutePath());
    if (helpTopic != nullptr)
        setHelpTopic(dialog, helpTopic);
    setSaveFilters(dialog, filters);
    dialog.selectFile(file.fileName());
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

QString askFolder(QWidget *parent, const QString &title, const QString &proposed, const char *helpTopic)
{
    QFileDialog dialog(parent, title, proposed);
    setHelpTopic(dialog, helpTopic);
    dialog.setFileMode(QFileDialog::Directory);
    dialog.setOption(QFileDialog::ShowDirsOnly);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

} // namespace codewheel
