// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/interbus/offer_files.h"

#include "app/window/kinds/interbus/ring_offer.h"
#include "kinds/interbus/links/server_socket.h"
#include "project/file_access.h"
#include "project/project_file.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/help/help_topic.h"
#include "widgets/look/save_file.h"

#include <QDir>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>
#include <QPushButton>

namespace codewheel {
namespace {

constexpr char filesTopic[] = "serving.md#files-to-hand-out";

const QString allAddresses = QStringLiteral("0.0.0.0");

QString seatFile(int unit)
{
    return QStringLiteral("seat-%1.codewheel").arg(unit, 2, 10, QLatin1Char('0'));
}

} // namespace

OfferFiles::OfferFiles(const RingOffer &offer, const QStringList &own, const QString &folder, QWidget &parent)
    : m_offer(offer)
    , m_own(own.filter(QStringLiteral("."))) // of IP version 4
    , m_folder(folder)
    , m_parent(parent)
{}

std::optional<OfferFiles::Outcome> OfferFiles::save()
{
    QString host = m_offer.server().host;
    if (host == allAddresses) {
        if (m_own.isEmpty())
            return Outcome{Role::attention,
                           tr("This computer has no address in a network: others cannot reach it, and "
                              "no file can say how. Connect it to the network.")};
        host = m_own.size() == 1 ? m_own.front() : askAddress();
    }
    if (host.isEmpty())
        return std::nullopt;
    return m_offer.place().seats > 0 ? saveSeats(host) : saveOne(host);
}

// Empty: none of them.
QString OfferFiles::askAddress() const
{
    QInputDialog dialog(&m_parent);
    setHelpTopic(dialog, filesTopic);
    dialog.setWindowTitle(tr("Save files"));
    dialog.setLabelText(tr("At which address do the others &reach this computer?"));
    dialog.setComboBoxItems(m_own);
    return dialog.exec() == QDialog::Accepted ? dialog.textValue() : QString();
}

std::optional<OfferFiles::Outcome> OfferFiles::saveOne(const QString &host)
{
    const QString path = askSaveFile(&m_parent, tr("Save a file for clients"),
                                     QDir(m_folder).filePath(tr("offered-ring.codewheel", "name of a file")),
                                     {tr("Codewheel projects (*.codewheel)")}, filesTopic);
    if (path.isEmpty())
        return std::nullopt;
    if (const auto saved = saveProject(m_offer.clientProject(1, host), path); !saved)
        return Outcome{Role::fault, refusalText(saved.error())};
    return Outcome{Role::running, sentence(tr("Saved: %1. %2"), {path, whoReaches(host)})};
}

std::optional<OfferFiles::Outcome> OfferFiles::saveSeats(const QString &host)
{
    const QString folder = askFolder(&m_parent, tr("Save files for the seats"), m_folder, filesTopic);
    if (folder.isEmpty() || !mayReplace(folder))
        return std::nullopt;
    const int seats = m_offer.place().seats;
    for (int unit = 1; unit <= seats; ++unit) {
        const auto saved =
            saveProject(m_offer.clientProject(unit, host), QDir(folder).filePath(seatFile(unit)));
        if (!saved)
            return Outcome{Role::fault,
                           unit == 1
                               ? refusalText(saved.error())
                               : sentence(tr("Only the files of the seats before seat %1 were saved. %2"),
                                          {QString::number(unit), refusalText(saved.error())})};
    }
    return Outcome{Role::running,
                   sentence(tr("%n files saved in %1. %2", nullptr, seats), {folder, whoReaches(host)})};
}

// Asks once for all of them.
bool OfferFiles::mayReplace(const QString &folder) const
{
    QStringList there;
    for (int unit = 1; unit <= m_offer.place().seats; ++unit)
        if (QFileInfo::exists(QDir(folder).filePath(seatFile(unit))))
            there << seatFile(unit);
    if (there.isEmpty())
        return true;
    QMessageBox box(QMessageBox::Question, tr("Save files for the seats"),
                    tr("%n files of these names are there already.", nullptr, static_cast<int>(there.size())),
                    QMessageBox::NoButton, &m_parent);
    box.setObjectName(QStringLiteral("seatFilesQuestion"));
    setHelpTopic(box, filesTopic);
    box.setInformativeText(sentence(tr("%1. What is in them is kept as %2."),
                                    {there.join(QStringLiteral(", ")), backupPath(there.front())}));
    QPushButton *replace = box.addButton(tr("&Replace"), QMessageBox::AcceptRole);
    replace->setToolTip(tr("Saves the files of all seats, in place of what is there"));
    box.setDefaultButton(box.addButton(QMessageBox::Cancel));
    box.exec();
    return box.clickedButton() == replace;
}

QString OfferFiles::whoReaches(const QString &host) const
{
    const QString address = shownAddress({host, m_offer.server().port});
    return reachesOthers(host) ? sentence(tr("A Codewheel that opens such a file connects to %1: its "
                                             "computer must reach this one there."),
                                          {address})
                               : sentence(tr("A Codewheel that opens such a file connects to %1: on this "
                                             "computer only, since it is "
                                             "offered to this computer only."),
                                          {address});
}

} // namespace codewheel
