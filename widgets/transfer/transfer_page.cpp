// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/transfer_page.h"

#include "bus/buses.h"
#include "catalog/catalog.h"
#include "journal/eeprom_cost.h"
#include "report/transfer_report.h"
#include "transfer/project_places.h"
#include "transfer/transfer_words.h"
#include "transfer/value_store.h"
#include "vocabulary/refusal_text.h"
#include "widgets/eeprom/eeprom_gate.h"
#include "widgets/job/account_view.h"
#include "widgets/job/job_strip.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/project/project_document.h"
#include "widgets/transfer/transfer_lines.h"
#include "widgets/transfer/transfer_table.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>

#include <algorithm>

namespace codewheel {
namespace {

using What = TransferChoice::What;

bool isOneOf(const std::vector<Place> &numbers, Place number)
{
    return std::ranges::find(numbers, number) != numbers.end();
}

} // namespace

void TransferPage::followEncoders()
{
    for (const Place number : m_buses.places())
        if (EncoderSession *encoder = m_buses.encoder(number)) {
            connect(encoder, &EncoderSession::knownChanged, this, &TransferPage::planSoon,
                    Qt::UniqueConnection);
            connect(encoder, &EncoderSession::finished, this, &TransferPage::planSoon, Qt::UniqueConnection);
            connect(encoder, &EncoderSession::freshnessChanged, this, &TransferPage::planSoon,
                    Qt::UniqueConnection);
        }
}

void TransferPage::choose(What what, std::optional<Place> number)
{
    if (isBusy())
        return;
    backToChoice();
    if (number)
        m_choice->setEncoder(*number);
    m_choice->choose(what);
    if (number)
        m_choice->setEncoder(*number);
    showPlan();
}

QString TransferPage::effect() const
{
    return m_stage->currentWidget() == m_done ? tr("What was written. Nothing more is sent.")
           : m_choice->what() == What::store
               ? tr("Stores in the project what encoders have. Nothing is sent before Read and store.")
               : tr("Writes to encoders. Nothing is sent before Write.");
}

// The table does not change while it is being carried out.
void TransferPage::planSoon()
{
    if (isVisible() && !isBusy() && m_stage->currentWidget() == m_choosing)
        m_soon.start();
}

void TransferPage::showPlan()
{
    m_soon.stop();
    if (isBusy())
        return;
    if (m_choice->what() == What::store) {
        m_plan.clear();
        m_model->show(linesToStore(m_buses, ProjectPlaces(m_project.project(), m_buses),
                                   m_project.project().devices, m_choice->withCams()),
                      TransferModel::Heads::store);
        return;
    }
    m_plan = planTransfer(m_buses, m_choice->wishes(m_catalog, m_project));
    m_model->show(linesOf(m_buses, m_plan));
}

TransferPlan TransferPage::chosenPlan() const
{
    TransferPlan plan;
    for (const EncoderPlan &encoder : m_plan)
        if (m_model->isChosen(encoder.place))
            plan.push_back(encoder);
    return plan;
}

void TransferPage::showSummary()
{
    const std::vector<Place> chosen = m_model->chosen();
    const bool stores = m_choice->what() == What::store;
    Q_EMIT headChanged();
    m_begin->setText(stores ? tr("&Read and store") : tr("&Write"));
    m_begin->setIcon(lineIcon(stores ? Icon::read : Icon::write));
    m_begin->setToolTip(stores ? tr("Reads the chosen encoders, and stores in the project what they have. "
                                    "Those on a ring show no position meanwhile")
                               : tr("Sends what is shown above to the chosen encoders, one after the other"));
    if (!isBusy())
        m_gate->setWrites(writesOf(m_buses, planOfCost()));
    showBegin();
    const bool choosesAny = std::ranges::any_of(m_model->rows(), &ReviewRow::canBeChosen);
    m_all->setEnabled(choosesAny);
    m_none->setEnabled(choosesAny);
    m_stop->setVisible(!stores);
    if (m_model->rowCount() == 0)
        m_summary->setText(m_choice->what() == What::restore ? tr("There is nothing to restore.")
                                                             : tr("There is nothing to transfer: nothing is "
                                                                  "wanted, stored or known."));
    else if (stores)
        m_summary->setText(tr("Encoders chosen: %1.").arg(chosen.size()));
    else
        m_summary->setText(tr("Encoders chosen: %1. EEPROM writes: at most %2.")
                               .arg(chosen.size())
                               .arg(eepromWritesOf(chosenPlan())));
}

std::vector<EncoderJobs> TransferPage::jobsToDo() const
{
    if (m_choice->what() != What::store)
        return jobsOf(chosenPlan());
    std::vector<EncoderJobs> jobs;
    for (const Place number : m_toStore)
        if (const EncoderSession *encoder = m_buses.encoder(number))
            if (EncoderJobs one = jobsToStore(*encoder, m_choice->withCams()); !one.jobs.empty())
                jobs.push_back(std::move(one));
    return jobs;
}

// Reading cams may first store a changed program.
TransferPlan TransferPage::planOfCost() const
{
    if (m_choice->what() != What::store)
        return chosenPlan();
    TransferPlan plan;
    for (const Place number : m_model->chosen())
        if (const EncoderSession *encoder = m_buses.encoder(number)) {
            EncoderPlan one{.place = number, .jobs = jobsToStore(*encoder, m_choice->withCams()).jobs};
            for (const Job &job : one.jobs)
                one.eepromWrites += mostEepromWrites(*encoder, job);
            plan.push_back(std::move(one));
        }
    return plan;
}

void TransferPage::showBegin()
{
    m_begin->setEnabled(!m_model->chosen().empty() && !isBusy() && m_gate->isOpen());
}

// An encoder that shows no position meanwhile may only be read in Operate.
bool TransferPage::mayBeRead() const
{
    return std::ranges::none_of(jobsToDo(), [this](const EncoderJobs &one) {
        const EncoderBus *bus = m_buses.busOf(one.place);
        return bus && !bus->isOperating() && bus->encoder(one.place)->can().readingHidesPosition;
    });
}

void TransferPage::begin()
{
    showPlan(); // as of this moment
    m_toStore = m_model->chosen();
    if (m_toStore.empty() || !m_gate->isOpen())
        return;
    if (m_choice->what() == What::store && !mayBeRead()) {
        m_problem->showMessage(Role::attention, refusalText({RefusalKind::busy, RefusalId::watchOnly, {}}));
        return;
    }
    m_problem->withdraw();
    carryOut();
}

void TransferPage::carryOut()
{
    m_plan = m_choice->what() == What::store ? TransferPlan() : chosenPlan();
    m_choice->setEnabled(false);
    m_table->setEnabled(false);
    m_begin->setEnabled(false);
    m_progress->begin();
    m_progress->show();
    m_progress->setFocus();
    m_round.start(jobsToDo(),
                  m_stop->isChecked() ? JobRound::AfterRefusal::stop : JobRound::AfterRefusal::goOn);
}

void TransferPage::finish()
{
    m_choice->setEnabled(true);
    m_table->setEnabled(true);
    m_progress->hide();
    if (m_choice->what() == What::store)
        finishStoring();
    else
        finishWriting();
}

// If an encoder did not report a value, the one known before is kept.
void TransferPage::finishStoring()
{
    Project project = m_project.project();
    const ProjectPlaces places(project, m_buses); // other buses may be connected meanwhile
    std::vector<ProjectDevice> stored;
    for (ProjectDevice &device : project.devices) {
        const EncoderSession *encoder = m_buses.encoder(device.place());
        if (encoder == nullptr || !isOneOf(m_toStore, device.place()) || places.hindrance(device.place()))
            continue;
        device = withStored(device, *encoder);
        stored.push_back(device);
    }
    m_project.edit(std::move(project), tr("Store values of encoders"));
    Q_EMIT messaged(valuesStoredMessage(stored));
    const auto failed = std::ranges::find_if(
        m_round.results(), [](const EncoderResult &result) { return result.why.has_value(); });
    if (failed == m_round.results().end())
        m_problem->showMessage(Role::running, messageText(valuesStoredMessage(stored)));
    else
        m_problem->showMessage(
            Role::attention, QStringLiteral("%1: %2").arg(failed->place.shown(), refusalText(*failed->why)));
    showPlan();
    m_begin->setFocus();
}

QString TransferPage::source() const
{
    switch (m_choice->what()) {
    case What::clone:
        return tr("Values of %1").arg(m_choice->from().value_or(Place()).toString());
    case What::restore:
        return m_choice->before()
                   ? tr("Values of %1")
                         .arg(timeOf(*m_choice->before(), m_buses.now(m_choice->before()->place)))
                   : QString();
    default:
        break;
    }
    const QString file = QFileInfo(m_project.file()).fileName();
    return file.isEmpty() ? m_project.project().title : file;
}

void TransferPage::finishWriting()
{
    const What what = m_choice->what();
    TransferAccount account = accountOf(m_buses,
                                        what == What::clone     ? TransferKind::clone
                                        : what == What::restore ? TransferKind::restore
                                                                : TransferKind::write,
                                        m_plan, m_round.results());
    account.source = source();
    const Message message = messageOf(account);
    Q_EMIT messaged(message);
    if (what == What::restore && m_choice->before() != nullptr)
        Q_EMIT messaged(valuesRestoredMessage(*m_choice->before(), account));
    m_result->setText(messageText(message));
    m_account->show(
        reportOf(account, m_catalog, QCoreApplication::applicationVersion()),
        QStringLiteral("transfer-%1").arg(account.at.toString(QStringLiteral("yyyy-MM-dd-hhmm"))));
    m_stage->setCurrentWidget(m_done);
    Q_EMIT headChanged();
    m_account->setFocus();
}

void TransferPage::backToChoice()
{
    m_stage->setCurrentWidget(m_choosing);
    m_model->forgetChoice();
    showPlan();
    m_choice->setFocus();
}

} // namespace codewheel
