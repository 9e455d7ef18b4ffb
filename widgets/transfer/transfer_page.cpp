// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/transfer_page.h"

#include "catalog/catalog.h"
#include "encoder/refusal_text.h"
#include "journal/eeprom_cost.h"
#include "ring/bus_session.h"
#include "transfer/transfer_report.h"
#include "transfer/transfer_words.h"
#include "transfer/value_store.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/project/project_document.h"
#include "widgets/transfer/account_view.h"
#include "widgets/transfer/eeprom_gates.h"
#include "widgets/transfer/transfer_progress.h"
#include "widgets/transfer/transfer_table.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>

#include <algorithm>

namespace codewheel {
namespace {

using What = TransferChoice::What;

constexpr auto planDelay = std::chrono::milliseconds(50);

bool isOneOf(const std::vector<DeviceNumber> &numbers, DeviceNumber number)
{
    return std::ranges::find(numbers, number) != numbers.end();
}

} // namespace

TransferPage::TransferPage(BusSession &bus, ProjectDocument &project, FindValuesBefore findBefore,
                           QWidget *parent)
    : QWidget(parent)
    , m_bus(bus)
    , m_project(project)
    , m_round(bus)
    , m_choice(new TransferChoice(bus, std::move(findBefore), this))
    , m_model(new TransferModel(TransferModel::Choice::free, this))
    , m_table(new TransferTable(*m_model, tr("What differs"), this))
    , m_all(new QPushButton(tr("Choose &all"), this))
    , m_none(new QPushButton(tr("Choose &none"), this))
    , m_stop(new QCheckBox(tr("Stop &after a refusal"), this))
    , m_summary(new QLabel(this))
    , m_problem(new InlineMessage(this))
    , m_gates(new EepromGates(bus, this))
    , m_begin(new QPushButton(this))
    , m_close(new QPushButton(tr("&Close"), this))
    , m_progress(new TransferProgress(m_round, this))
    , m_stage(new QStackedWidget(this))
    , m_choosing(new QWidget(this))
    , m_done(new QWidget(this))
    , m_result(new QLabel(this))
    , m_account(new AccountView(this))
    , m_back(new QPushButton(lineIcon(Icon::back), tr("&Back"), this))
{
    setAccessibleName(tr("Transfer"));
    m_table->setObjectName(QStringLiteral("transferTable"));
    m_all->setToolTip(tr("Chooses every encoder that can be written to"));
    m_none->setToolTip(tr("Chooses none"));
    m_all->setObjectName(QStringLiteral("chooseAll"));
    m_none->setObjectName(QStringLiteral("chooseNone"));
    m_stop->setObjectName(QStringLiteral("stopAfterRefusal"));
    m_stop->setToolTip(tr("Begin no other encoder after one has refused"));
    m_summary->setWordWrap(true);
    m_summary->setObjectName(QStringLiteral("transferSummary"));
    m_begin->setObjectName(QStringLiteral("transferBegin"));
    m_begin->setDefault(true);
    m_close->setObjectName(QStringLiteral("transferClose"));
    m_close->setToolTip(tr("Back to the monitors; nothing is sent"));
    m_result->setWordWrap(true);
    m_result->setObjectName(QStringLiteral("transferResult"));
    m_back->setObjectName(QStringLiteral("transferBack"));
    m_back->setToolTip(tr("Shows what differs now"));
    m_progress->hide();
    m_soon.setSingleShot(true);
    m_soon.setInterval(planDelay);
    setFocusProxy(m_choice);
    layOut();
    connectAll();
    showSummary();
}

void TransferPage::layOut()
{
    auto *choosing = new QHBoxLayout;
    choosing->addWidget(m_all);
    choosing->addWidget(m_none);
    choosing->addWidget(m_stop);
    choosing->addStretch(1);
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_summary, 1);
    buttons->addWidget(m_begin);
    buttons->addWidget(m_close);
    auto *first = new QVBoxLayout(m_choosing);
    first->setContentsMargins(0, 0, 0, 0);
    first->setSpacing(grid::margin);
    first->addWidget(m_choice);
    first->addWidget(m_table, 1);
    first->addLayout(choosing);
    first->addWidget(m_problem);
    first->addWidget(m_gates);
    first->addWidget(m_progress);
    first->addLayout(buttons);
    auto *second = new QVBoxLayout(m_done);
    second->setContentsMargins(0, 0, 0, 0);
    second->setSpacing(grid::margin);
    second->addWidget(m_result);
    second->addWidget(m_account, 1);
    second->addWidget(m_back, 0, Qt::AlignLeft);
    m_stage->addWidget(m_choosing);
    m_stage->addWidget(m_done);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(grid::margin, grid::margin, grid::margin, grid::margin);
    layout->addWidget(m_stage);
}

void TransferPage::connectAll()
{
    connect(m_choice, &TransferChoice::changed, this, [this] {
        m_model->forgetChoice();
        m_problem->withdraw();
        showPlan();
    });
    connect(m_model, &TransferModel::chosenChanged, this, &TransferPage::showSummary);
    connect(m_all, &QPushButton::clicked, m_model, [this] { m_model->chooseAll(true); });
    connect(m_none, &QPushButton::clicked, m_model, [this] { m_model->chooseAll(false); });
    connect(m_gates, &EepromGates::changed, this, &TransferPage::showBegin);
    connect(m_begin, &QPushButton::clicked, this, &TransferPage::begin);
    connect(m_close, &QPushButton::clicked, this, &TransferPage::closeRequested);
    connect(m_back, &QPushButton::clicked, this, &TransferPage::backToChoice);
    connect(&m_round, &JobRound::finished, this, &TransferPage::finish);
    connect(&m_soon, &QTimer::timeout, this, &TransferPage::showPlan);
    connect(&m_project, &ProjectDocument::changed, this, &TransferPage::planSoon);
    connect(&m_bus, &BusSession::stateChanged, this, &TransferPage::planSoon);
    connect(&m_bus, &BusSession::named, this, [this] {
        followEncoders();
        planSoon();
    });
    connect(&m_bus, &BusSession::structureChanged, this, [this] {
        m_choice->showRing();
        followEncoders();
        planSoon();
    });
    followEncoders();
}

void TransferPage::followEncoders()
{
    for (const DeviceNumber number : m_bus.numbers())
        if (EncoderSession *encoder = m_bus.encoder(number)) {
            connect(encoder, &EncoderSession::knownChanged, this, &TransferPage::planSoon,
                    Qt::UniqueConnection);
            connect(encoder, &EncoderSession::finished, this, &TransferPage::planSoon, Qt::UniqueConnection);
        }
}

void TransferPage::choose(What what, std::optional<DeviceNumber> number)
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

void TransferPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (m_stage->currentWidget() == m_choosing)
        showPlan();
}

// Nothing changes in the table while it is carried out.
void TransferPage::planSoon()
{
    if (isVisible() && !isBusy() && m_stage->currentWidget() == m_choosing)
        m_soon.start();
}

std::vector<ProjectDevice> TransferPage::plannedDevices() const
{
    std::vector<ProjectDevice> devices;
    m_project.forEachDevice([&](DeviceNumber number, const ProjectDevice &device) {
        devices.push_back(device);
        devices.back().participant.number = number;
    });
    std::ranges::sort(devices, {}, [](const ProjectDevice &device) { return device.participant.number; });
    return devices;
}

std::vector<TransferWish> TransferPage::wishes() const
{
    std::vector<TransferWish> wishes;
    const What what = m_choice->what();
    if (what == What::restore) {
        if (const ValuesBefore *before = m_choice->before())
            wishes.push_back(wishToRestore(*before));
        return wishes;
    }
    if (what == What::clone) {
        const auto from = m_choice->from();
        const EncoderSession *model = from ? m_bus.encoder(*from) : nullptr;
        for (const DeviceNumber number : m_bus.numbers())
            if (const EncoderSession *to = m_bus.encoder(number);
                model && to && number != *from && to->can().writes)
                wishes.push_back(wishToClone(*model, *to, m_choice->withCams()));
        return wishes;
    }
    for (const ProjectDevice &device : plannedDevices()) {
        TransferWish wish =
            wishOf(device, what == What::write ? TransferSource::wanted : TransferSource::stored);
        if (!wish.values.empty() || !wish.cams.empty())
            wishes.push_back(std::move(wish));
    }
    return wishes;
}

void TransferPage::showPlan()
{
    m_soon.stop();
    if (isBusy())
        return;
    if (m_choice->what() == What::store) {
        m_plan.clear();
        m_model->show(linesToStore(m_bus, plannedDevices(), m_choice->withCams()),
                      TransferModel::Heads::store);
        return;
    }
    m_plan = planTransfer(m_bus, wishes());
    m_model->show(linesOf(m_bus, m_plan));
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
    const std::vector<DeviceNumber> chosen = m_model->chosen();
    const bool stores = m_choice->what() == What::store;
    m_begin->setText(stores ? tr("&Read and store") : tr("&Write"));
    m_begin->setIcon(lineIcon(stores ? Icon::read : Icon::write));
    m_begin->setToolTip(stores ? tr("Reads the chosen encoders, which show no position meanwhile, and keeps "
                                    "what they have in the project")
                               : tr("Sends the words above to the chosen encoders, one after the other"));
    if (!isBusy())
        m_gates->setPlan(planOfCost());
    showBegin();
    const bool choosesAny = std::ranges::any_of(m_model->rows(), &TransferLine::canBeChosen);
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
    for (const DeviceNumber number : m_toStore)
        if (const EncoderSession *encoder = m_bus.encoder(number))
            if (EncoderJobs one = jobsToStore(*encoder, m_choice->withCams()); !one.jobs.empty())
                jobs.push_back(std::move(one));
    return jobs;
}

// Reading cams may store a program that was changed before.
TransferPlan TransferPage::planOfCost() const
{
    if (m_choice->what() != What::store)
        return chosenPlan();
    TransferPlan plan;
    for (const DeviceNumber number : m_model->chosen())
        if (const EncoderSession *encoder = m_bus.encoder(number)) {
            EncoderPlan one{.place = number, .jobs = jobsToStore(*encoder, m_choice->withCams()).jobs};
            for (const Job &job : one.jobs)
                one.eepromWrites += mostEepromWrites(*encoder, job);
            plan.push_back(std::move(one));
        }
    return plan;
}

void TransferPage::showBegin()
{
    m_begin->setEnabled(!m_model->chosen().empty() && !isBusy() && m_gates->isOpen());
}

void TransferPage::begin()
{
    showPlan(); // of this moment
    m_toStore = m_model->chosen();
    if (m_toStore.empty() || !m_gates->isOpen())
        return;
    if (m_choice->what() == What::store && !m_bus.isOperating() && !jobsToDo().empty()) {
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
    m_close->setEnabled(false);
    m_progress->show();
    m_progress->setFocus();
    m_round.start(jobsToDo(),
                  m_stop->isChecked() ? JobRound::AfterRefusal::stop : JobRound::AfterRefusal::goOn);
}

void TransferPage::finish()
{
    m_choice->setEnabled(true);
    m_table->setEnabled(true);
    m_close->setEnabled(true);
    m_progress->hide();
    if (m_choice->what() == What::store)
        finishStoring();
    else
        finishWriting();
}

// What an encoder did not tell keeps what was known of it.
void TransferPage::finishStoring()
{
    Project project = m_project.project();
    std::vector<ProjectDevice> stored;
    for (ProjectDevice &device : project.devices) {
        const EncoderSession *encoder = m_bus.encoder(device.participant.number);
        if (encoder == nullptr || !isOneOf(m_toStore, device.participant.number))
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
        m_problem->showMessage(Role::attention, QStringLiteral("%1: %2").arg(failed->place.toString(),
                                                                             refusalText(*failed->why)));
    showPlan();
    m_begin->setFocus();
}

QString TransferPage::source() const
{
    switch (m_choice->what()) {
    case What::clone:
        return tr("Values of %1").arg(m_choice->from().value_or(DeviceNumber()).toString());
    case What::restore:
        return m_choice->before()
                   ? tr("Values of %1").arg(timeOf(*m_choice->before(), m_bus.dateTime(m_bus.latest().at)))
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
    TransferAccount account = accountOf(m_bus,
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
        reportOf(account, m_bus.catalog(), QCoreApplication::applicationVersion()),
        QStringLiteral("transfer-%1").arg(account.at.toString(QStringLiteral("yyyy-MM-dd-hhmm"))));
    m_stage->setCurrentWidget(m_done);
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
