// SPDX-License-Identifier: GPL-3.0-or-later
// What the transfer page is made of, and how its parts are connected.
#include "bus/buses.h"
#include "widgets/job/account_view.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/project/project_document.h"
#include "widgets/transfer/eeprom_gates.h"
#include "widgets/transfer/transfer_page.h"
#include "widgets/transfer/transfer_progress.h"
#include "widgets/transfer/transfer_table.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>

namespace codewheel {
namespace {

constexpr auto planDelay = std::chrono::milliseconds(50);

} // namespace

TransferPage::TransferPage(const Buses &buses, const Catalog &catalog, ProjectDocument &project,
                           FindValuesBefore findBefore, QWidget *parent)
    : QWidget(parent)
    , m_buses(buses)
    , m_catalog(catalog)
    , m_project(project)
    , m_round(buses)
    , m_choice(new TransferChoice(buses, std::move(findBefore), this))
    , m_model(new TransferModel(TransferModel::Choice::free, this))
    , m_table(new TransferTable(*m_model, tr("What differs"), this))
    , m_all(describe(new QPushButton(tr("Choose &all"), this), "chooseAll",
                     tr("Chooses every encoder that can be written to")))
    , m_none(describe(new QPushButton(tr("Choose &none"), this), "chooseNone", tr("Chooses none")))
    , m_stop(describe(new QCheckBox(tr("&Stop after a refusal"), this), "stopAfterRefusal",
                      tr("Begin no other encoder after one has refused")))
    , m_summary(new QLabel(this))
    , m_problem(new InlineMessage(this))
    , m_gates(new EepromGates(buses, this))
    , m_begin(new QPushButton(this))
    , m_close(describe(new QPushButton(tr("&Close"), this), "transferClose",
                       tr("Back to the monitors; nothing is sent")))
    , m_progress(new TransferProgress(m_round, this))
    , m_stage(new QStackedWidget(this))
    , m_choosing(new QWidget(this))
    , m_done(new QWidget(this))
    , m_result(new QLabel(this))
    , m_account(new AccountView(this))
    , m_back(describe(new QPushButton(lineIcon(Icon::back), tr("Bac&k"), this), "transferBack",
                      tr("Shows what differs now")))
{
    setAccessibleName(tr("Transfer"));
    m_table->setObjectName(QStringLiteral("transferTable"));
    m_summary->setWordWrap(true);
    m_summary->setObjectName(QStringLiteral("transferSummary"));
    m_begin->setObjectName(QStringLiteral("transferBegin"));
    m_begin->setDefault(true);
    m_result->setWordWrap(true);
    m_result->setObjectName(QStringLiteral("transferResult"));
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
    connect(&m_buses, &Buses::changed, this, [this] {
        m_choice->showEncoders();
        followEncoders();
        planSoon();
    });
    followEncoders();
}

} // namespace codewheel
