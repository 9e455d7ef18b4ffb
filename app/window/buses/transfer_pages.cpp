// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/buses/transfer_pages.h"

#include "app/window/window_actions.h"
#include "bus/buses.h"
#include "catalog/device_description.h"
#include "vocabulary/refusal_text.h"
#include "widgets/models/shown_encoder.h"
#include "widgets/transfer/replace_page.h"
#include "widgets/transfer/transfer_page.h"

#include <QAction>
#include <QStackedWidget>

namespace codewheel {
namespace {

void explain(QAction &action, const QString &what)
{
    action.setStatusTip(what);
    action.setToolTip(
        QStringLiteral("%1 (%2)").arg(what, action.shortcut().toString(QKeySequence::NativeText)));
}

} // namespace

TransferPages::TransferPages(const Buses &buses, const Catalog &catalog, ProjectDocument &project,
                             FindValuesBefore findBefore, LastPositions &positions,
                             const WindowActions &actions, QStackedWidget &pages, QObject *parent)
    : QObject(parent)
    , m_buses(buses)
    , m_findBefore(std::move(findBefore))
    , m_actions(actions)
    , m_pages(pages)
    , m_transfer(pages, "transfer.md",
                 [this, &catalog, &project] {
                     auto *page = new TransferPage(m_buses, catalog, project, m_findBefore, &m_pages);
                     connect(page, &TransferPage::messaged, this, &TransferPages::told);
                     return page;
                 })
    , m_replace(pages, "transfer.md#replace-an-encoder", [this, &catalog, &project, &positions] {
        auto *page = new ReplacePage(m_buses, catalog, project, positions, &m_pages);
        connect(page, &ReplacePage::messaged, this, &TransferPages::told);
        page->setStepsOfKind(m_makeReplaceSteps);
        return page;
    })
{
    connect(actions.transfer, &QAction::triggered, this, &TransferPages::showTransfer);
    connect(actions.restoreValues, &QAction::triggered, this, &TransferPages::showRestore);
    connect(actions.replaceEncoder, &QAction::triggered, this, &TransferPages::showReplace);
    showActions();
}

void TransferPages::setEncoder(const ShownEncoder &shown)
{
    if (m_number)
        if (EncoderSession *before = m_buses.encoder(*m_number))
            before->disconnect(this);
    EncoderSession *encoder = shown.session();
    m_number = encoder ? std::optional(encoder->place()) : std::nullopt;
    m_isOnlyPlanned = shown.isThere() && !encoder;
    if (encoder) {
        connect(encoder, &EncoderSession::finished, this, &TransferPages::showActions, Qt::QueuedConnection);
        connect(encoder, &EncoderSession::knownBeforeChanged, this, &TransferPages::showActions,
                Qt::QueuedConnection);
    }
    showActions();
}

void TransferPages::showActions()
{
    const EncoderSession *encoder = m_number ? m_buses.encoder(*m_number) : nullptr;
    const bool canBeWritten = encoder && encoder->can().writes;
    const QString why = m_isOnlyPlanned ? tr("Not connected: nothing can be sent.")
                        : !encoder      ? tr("No encoder is chosen.")
                                        : refusalText({RefusalKind::notSupported,
                                                       RefusalId::writingNotSupported,
                                                       {encoder->device().fullName()}});
    m_actions.replaceEncoder->setEnabled(canBeWritten);
    explain(*m_actions.replaceEncoder,
            canBeWritten
                ? tr("Gives the new encoder at this place the values and the position of the previous one")
                : why);
    const auto before = canBeWritten ? m_findBefore(*m_number) : std::vector<ValuesBefore>();
    m_actions.restoreValues->setEnabled(!before.empty());
    m_actions.restoreValues->setText(
        before.empty() ? tr("Restore earlier &values…")
                       : tr("Restore &values of %1…").arg(timeOf(before.front(), m_buses.now(*m_number))));
    explain(*m_actions.restoreValues,
            !canBeWritten    ? why
            : before.empty() ? refusalText(whyNothingBefore(*encoder))
                             : tr("Shows what the encoder had before this program wrote to it, and writes "
                                  "it again"));
}

bool TransferPages::isBusy() const
{
    const TransferPage *transfer = m_transfer.ifMade();
    const ReplacePage *replace = m_replace.ifMade();
    return (transfer != nullptr && transfer->isBusy()) || (replace != nullptr && replace->isBusy());
}

void TransferPages::showTransfer()
{
    TransferPage &page = m_transfer.page();
    m_pages.setCurrentWidget(&page);
    page.setFocus();
}

void TransferPages::showRestore()
{
    m_transfer.page().choose(TransferChoice::What::restore, m_number);
    showTransfer();
}

void TransferPages::showReplace()
{
    if (!m_number)
        return;
    ReplacePage &page = m_replace.page();
    page.replace(*m_number);
    m_pages.setCurrentWidget(&page);
}

} // namespace codewheel
