// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/replace_write_steps.h"

#include "bus/buses.h"
#include "catalog/device_description.h"
#include "report/transfer_report.h"
#include "transfer/transfer_words.h"
#include "vocabulary/refusal_text.h"
#include "widgets/eeprom/eeprom_gate.h"
#include "widgets/job/account_view.h"
#include "widgets/job/job_strip.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/project/project_document.h"
#include "widgets/transfer/transfer_lines.h"
#include "widgets/transfer/transfer_table.h"

#include <QCoreApplication>
#include <QLocale>

namespace codewheel {
namespace {

QString whereToEnterValues()
{
    return u' ' + ReplaceWriteStep::tr("To have values written, enter them in the panel Parameters first.");
}

} // namespace

ReplaceWriteStep::ReplaceWriteStep(Replacing &replacing, QWidget *parent)
    : ReplaceStep(replacing, tr("Write"), parent)
    , m_round(replacing.buses)
    , m_model(new TransferModel(TransferModel::Choice::fixed, this))
    , m_table(named(new TransferTable(*m_model, tr("What will be written"), this), "replaceTable"))
    , m_note(wrappedLabel(this, "replaceNote"))
    , m_message(new InlineMessage(this))
    , m_gate(new EepromGate(this))
    , m_progress(new JobStrip(m_round, this))
{
    m_progress->hide();
    layOutColumn(this, {{m_table, 1}, m_note, m_message, m_gate, m_progress},
                 {.spacing = grid::margin, .margins = QMargins()});
    setFocusProxy(m_table);
    connect(m_gate, &EepromGate::changed, this, &ReplaceStep::changed);
    connect(&m_round, &JobRound::finished, this, [this] {
        m_progress->hide();
        Q_EMIT changed();
        Q_EMIT ended();
    });
    connect(&replacing.buses, &Buses::changed, this, [this] {
        if (isVisible() && !isBusy())
            showPlan();
    });
    connect(&replacing.buses, &Buses::updated, this, &ReplaceWriteStep::followEncoder);
}

void ReplaceWriteStep::enter()
{
    m_message->withdraw();
    showPlan();
}

// What is written to an encoder in error may be more.
void ReplaceWriteStep::followEncoder()
{
    const EncoderSession *encoder = m_replacing.buses.encoder(m_replacing.place);
    if (isVisible() && !m_isFixed && encoder != nullptr && encoder->latest().state != m_plannedIn)
        showPlan();
}

ProjectPlaces ReplaceWriteStep::places() const
{
    return {m_replacing.project.project(), m_replacing.buses};
}

void ReplaceWriteStep::showPlan()
{
    if (m_isFixed)
        return;
    const EncoderSession *encoder = m_replacing.buses.encoder(m_replacing.place);
    m_plannedIn = encoder != nullptr ? encoder->latest().state : EncoderState::notSeen;
    m_plan =
        planTransfer(m_replacing.buses,
                     {wishToReplace(m_replacing.before, m_replacing.now, m_replacing.position, places())});
    m_model->show(linesOf(m_replacing.buses, m_plan));
    m_gate->setWrites(writesOf(m_replacing.buses, m_plan));
    m_note->setText(noteOf(m_plan.front()));
    Q_EMIT changed();
}

QString ReplaceWriteStep::noteOf(const EncoderPlan &plan)
{
    if (!plan.isWritten() && !plan.hindrance)
        return tr("There are no values for it, neither wanted nor stored. Write puts the new encoder into "
                  "the project.") +
               whereToEnterValues();
    const QString summary = transfer_words::summary(plan);
    if (plan.hindrance && plan.hindrance->id == RefusalId::valuesMissingAfterLoss)
        return summary + whereToEnterValues();
    if (plan.hindrance || !plan.write.rows.empty() || !plan.cams.empty())
        return summary;
    return summary + u' ' +
           tr("The project has no values for it, neither wanted nor stored: what the previous encoder had "
              "is not written.") +
           whereToEnterValues();
}

bool ReplaceWriteStep::mayGoOn() const
{
    return !m_round.isRunning() && !m_plan.empty() && !m_plan.front().hindrance && m_gate->isOpen();
}

// A job may have been started elsewhere since the plan was made.
bool ReplaceWriteStep::leave()
{
    const EncoderSession *encoder = m_replacing.buses.encoder(m_replacing.place);
    if (encoder != nullptr && encoder->runningJob())
        showPlan();
    return mayGoOn();
}

void ReplaceWriteStep::takeNew()
{
    m_isFixed = true;
    const Replacement &now = m_replacing.now;
    EncoderBus *bus = m_replacing.buses.busOf(m_replacing.place);
    if (bus != nullptr && bus->encoder(m_replacing.place) != nullptr) {
        const auto replaced = bus->replace(m_replacing.place, now.device->key, now.turns, now.stepsPerTurn);
        if (!replaced)
            m_message->showMessage(Role::attention, refusalText(replaced.error()));
    }
}

void ReplaceWriteStep::begin()
{
    const QString &serial = m_replacing.now.serialNumber;
    m_source = serial.isEmpty() ? m_replacing.project.project().title : tr("Serial number %1").arg(serial);
    m_progress->begin();
    m_progress->show();
    m_progress->setFocus();
    m_round.start(jobsOf(m_plan), JobRound::AfterRefusal::stop);
    Q_EMIT changed();
}

TransferAccount ReplaceWriteStep::account() const
{
    TransferAccount account = accountOf(m_replacing.buses, TransferKind::replace, m_plan, m_round.results());
    account.source = m_source;
    return account;
}

ReplaceAccountStep::ReplaceAccountStep(Replacing &replacing, QWidget *parent)
    : ReplaceStep(replacing, tr("What was written"), parent)
    , m_result(wrappedLabel(this, "replaceResult"))
    , m_account(new AccountView(this))
{
    layOutColumn(this, {m_result, {m_account, 1}}, {.spacing = grid::margin, .margins = QMargins()});
    setFocusProxy(m_account);
}

void ReplaceAccountStep::show(const TransferAccount &account)
{
    const EncoderAccount &its = account.encoders.front();
    QString result = transfer_words::outcome(its);
    if (its.why && its.positionSet && its.positionWanted)
        result += u' ' + tr("The position was set to %1 all the same.")
                             .arg(QLocale().toString(qlonglong{*its.positionWanted}));
    if (its.notInForce)
        result += u' ' + noteText(*its.notInForce);
    m_result->setText(result);
    m_account->show(reportOf(account, m_replacing.catalog, QCoreApplication::applicationVersion()),
                    QStringLiteral("replaced-%1-%2")
                        .arg(m_replacing.place.shown(), account.at.toString(QStringLiteral("yyyy-MM-dd"))));
}

} // namespace codewheel
