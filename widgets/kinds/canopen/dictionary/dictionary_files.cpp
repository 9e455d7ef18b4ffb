// SPDX-License-Identifier: GPL-3.0-or-later
// Files of makers, and those that are compared with or saved.
#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/eds/dcf_writer.h"
#include "kinds/canopen/eds/device_file_reader.h"
#include "kinds/canopen/eds/standard_objects.h"
#include "project/file_access.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "widgets/kinds/canopen/dictionary/dictionary_view.h"
#include "widgets/kinds/canopen/dictionary/heard_values.h"
#include "widgets/kinds/canopen/dictionary/object_write_bar.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/log_table.h"
#include "widgets/look/save_file.h"

#include <QAction>
#include <QDateTime>
#include <QFileDialog>
#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

constexpr qint64 largestDeviceFile = 16 * 1024 * 1024;

struct ReadFile
{
    std::optional<canopen::DeviceFile> file{};
    QString fault{}; // why there is none, or what of it does not count
};

QString faultText(const QString &path, const canopen::EdsNote &why)
{
    return why.line == 0
               ? sentence(DictionaryView::tr("%1: %2", "file, what is wrong"), {path, why.text()})
               : sentence(DictionaryView::tr("%1, line %2, %3: %4", "file, line, key, what is wrong"),
                          {path, QString::number(why.line), why.key, why.text()});
}

ReadFile readFileAt(const QString &path)
{
    const auto bytes = readWholeFile(path, largestDeviceFile);
    if (!bytes)
        return {.fault = refusalText(bytes.error())};
    auto file = canopen::readDeviceFile(*bytes);
    if (!file)
        return {.fault = faultText(path, file.error())};
    const QString fault = file->refused.empty() ? QString() : faultText(path, file->refused.front());
    return {.file = *std::move(file), .fault = fault}; // the rest counts
}

} // namespace

std::optional<canopen::DeviceFile> DictionaryView::fileAt(const QString &path)
{
    m_message->withdraw();
    auto read = readFileAt(path);
    if (!read.fault.isEmpty())
        m_message->showMessage(Role::attention, read.fault);
    return std::move(read.file);
}

// It stays in the project, whatever becomes of the file.
void DictionaryView::readKnownFile(Known &its)
{
    auto read = readFileAt(its.path);
    its.isRead = read.file.has_value();
    if (read.file) {
        its.file = *std::move(read.file);
        return;
    }
    its.whyNot = read.fault;
    m_message->showMessage(
        Role::attention,
        sentence(
            tr("The objects are not those of the file that the project has for this encoder. %1 It stays in "
               "the project; put it back, or open another one.",
               "why"),
            {read.fault}));
}

bool DictionaryView::openFile(const QString &path)
{
    auto file = m_node ? fileAt(path) : std::nullopt;
    if (!file)
        return false;
    Known &its = known();
    its.path = path;
    its.isRead = true;
    its.whyNot.clear();
    keepRows();
    its.file = *std::move(file);
    showRows();
    Q_EMIT fileChosen(*m_node, path);
    return true;
}

// The file itself stays where it is; undo gives it to the encoder again.
void DictionaryView::dropFile()
{
    if (!m_node || known().path.isEmpty())
        return;
    m_message->withdraw();
    keepRows();
    Known &its = known();
    its.path.clear();
    its.isRead = false;
    its.whyNot.clear();
    describeKnown(its);
    showRows();
    Q_EMIT fileChosen(*m_node, {});
}

// What was read, or heard since, goes before what the file says.
canopen::DeviceFile DictionaryView::fileNow(bool withHeard)
{
    canopen::DeviceFile file = known().file;
    auto object = file.objects.begin();
    for (const ObjectRow &row : m_rows->rows()) {
        const auto order = canopen::orderOf(row.object.object);
        while (object != file.objects.end() && canopen::orderOf(object->object) < order)
            ++object;
        const auto &its = withHeard ? row.shown() : row.now;
        if (its && object != file.objects.end() && object->object == row.object.object)
            object->value = its;
    }
    file.commissioning.node = m_node;
    if (m_bus && m_bus->rate() > 0)
        file.commissioning.rate = m_bus->rate();
    return file;
}

bool DictionaryView::compareWith(const QString &path)
{
    auto file = m_node ? fileAt(path) : std::nullopt;
    if (!file)
        return false;
    known().comparedWith = *std::move(file);
    known().comparedPath = path;
    renewRows();
    tellDifferences();
    showWhatIsPossible();
    return true;
}

void DictionaryView::compareAgain()
{
    m_rows->setDifferences(canopen::compareFiles(fileNow(true), *known().comparedWith));
}

void DictionaryView::tellDifferences()
{
    const auto differences = canopen::compareFiles(fileNow(true), *known().comparedWith);
    using Kind = canopen::ObjectDifference::Kind;
    const auto count = [&](Kind kind) {
        return QString::number(std::ranges::count(differences, kind, &canopen::ObjectDifference::kind));
    };
    const QString name = QFileInfo(known().comparedPath).fileName();
    const QString doubt = doubtOf(*known().comparedWith, known().comparedPath);
    const QString told =
        differences.empty()
            ? sentence(tr("All values are those of %1."), {name})
            : sentence(tr("Compared with %1: %2 values differ, %3 objects are not in it, %4 only in it."),
                       {name, count(Kind::differs), count(Kind::missing), count(Kind::additional)});
    m_message->showMessage(differences.empty() && doubt.isEmpty() ? Role::running : Role::attention,
                           doubt.isEmpty() ? told : told + u' ' + doubt);
}

// What the node is, is known once somebody was told (1018h). 0 in a file says nothing.
QString DictionaryView::doubtOf(const canopen::DeviceFile &file, const QString &path) const
{
    const int node = m_node.value_or(0);
    const QString name = QFileInfo(path).fileName();
    const auto [vendor, product, revision, serial] = m_heard->identityOf(node);
    const auto isOther = [](std::optional<std::uint32_t> its, std::optional<std::uint32_t> told) {
        return its.value_or(0) != 0 && told && *told != *its;
    };
    const auto text = [](std::optional<std::uint32_t> number) {
        return number ? hexNumber(*number) : tr("not known");
    };
    if (isOther(file.identity.vendor, vendor) || isOther(file.identity.product, product))
        return sentence(tr("%1 is for another device: vendor %2, product %3. Node %4 says vendor %5, product "
                           "%6."),
                        {name, text(file.identity.vendor), text(file.identity.product), QString::number(node),
                         text(vendor), text(product)});
    if (file.commissioning.node && *file.commissioning.node != node)
        return sentence(tr("%1 is the configuration of node %2, and this is node %3."),
                        {name, QString::number(*file.commissioning.node), QString::number(node)});
    return {};
}

void DictionaryView::showDoubt()
{
    const QString doubt = m_node && known().isRead ? doubtOf(known().file, known().path) : QString();
    m_writing->setDoubt(doubt);
    m_writing->setAsksWho(m_node && known().isRead && known().file.identity.vendor.value_or(0) != 0 &&
                          !m_heard->identityOf(*m_node)[0]);
    if (std::exchange(m_doubt, doubt) != doubt && !doubt.isEmpty())
        m_message->showMessage(Role::attention, doubt);
}

// What was not read may differ, too.
void DictionaryView::tellProject()
{
    if (wanted().empty())
        return;
    const auto count = [&](auto predicate) {
        return QString::number(std::ranges::count_if(m_rows->rows(), predicate));
    };
    const QString differing = count([](const ObjectRow &row) { return row.differsFromProject(); });
    const QString unread = count([](const ObjectRow &row) { return row.wanted && !row.shown(); });
    m_message->showMessage(
        differing == u'0' && unread == u'0' ? Role::running : Role::attention,
        sentence(tr("Of %1 objects that the project wants, %2 differ, and %3 have not been read."),
                 {QString::number(wanted().size()), differing, unread}));
}

bool DictionaryView::exportTo(const QString &path)
{
    if (!m_node)
        return false;
    canopen::DeviceFile file = fileNow(false);
    if (!known().isRead) // names as in any file
        for (const canopen::DeviceFile standard = canopen::standardObjects();
             canopen::FileObject & object : file.objects)
            if (const canopen::FileObject *its = standard.find(object.object))
                object.name = its->name;
    const canopen::DcfHead head{.fileName = QFileInfo(path).fileName(),
                                .ofFile = known().isRead ? QFileInfo(known().path).fileName() : QString(),
                                .now = QDateTime::currentDateTime()};
    const auto written = replaceFile(path, canopen::dcfOf(file, head), OldFile::goes);
    if (written && m_doubt.isEmpty())
        m_message->showMessage(Role::running, sentence(tr("Saved in %1."), {path}));
    else if (written)
        m_message->showMessage(Role::attention, sentence(tr("Saved in %1."), {path}) + u' ' + m_doubt);
    else
        m_message->showMessage(Role::attention, sentence(tr("%1 was not saved: %2", "file, reason"),
                                                         {path, whyNotWritten(written.error())}));
    return written.has_value();
}

void DictionaryView::askOpen()
{
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open the file of an encoder"), QFileInfo(known().path).path(),
                                     tr("Files of CANopen devices (*.eds *.dcf *.EDS *.DCF)"));
    if (!path.isEmpty())
        openFile(path);
}

void DictionaryView::askCompare()
{
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Compare with"), QFileInfo(known().path).path(),
                                     tr("Files of CANopen devices (*.eds *.dcf *.EDS *.DCF)"));
    if (!path.isEmpty())
        compareWith(path);
}

void DictionaryView::askExport()
{
    const QString path =
        askSaveFile(this, tr("Export the values"), tr("node%1.dcf", "name of a file").arg(m_node.value_or(0)),
                    {tr("Configurations of CANopen devices (*.dcf)")}, "canopen.md#objects");
    if (!path.isEmpty())
        exportTo(path);
}

} // namespace codewheel
