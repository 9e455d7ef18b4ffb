// SPDX-License-Identifier: GPL-3.0-or-later
// What the transfer page is made of, and how its parts are connected.
#include "bus/buses.h"
#include "widgets/eeprom/eeprom_gate.h"
#include "widgets/job/account_view.h"
#include "widgets/job/job_strip.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/on_event.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/project/project_document.h"
#include "widgets/transfer/transfer_page.h"
#include "widgets/transfer/transfer_table.h"

#include <QCheckBox>
#include <QPushButton>
#include <QStackedWidget>

namespace codewheel {
namespace {

constexpr auto planDelay = std::chrono::milliseconds(50);

} // namespace

TransferPage::TransferPage(const Buses &buses, const Catalog &catalog, ProjectDocument &project,
                           FindValuesBefore findBefore, QWidget *parent)
    : Page(parent)
    , m_buses(buses)
    , m_catalog(catalog)
    , m_project(project)
    , m_round(buses)
    , m_choice(new TransferChoice(buses, std::move(findBefore), this))
    , m_model(new TransferModel(TransferModel::Choice::free, this))
    , m_table(named(new TransferTable(*m_model, tr("What differs"), this), "transferTable"))
    , m_all(describe(new QPushButton(tr("Choose &all"), this), "chooseAll",
                     tr("Chooses every encoder that can be written to")))
    , m_none(describe(new QPushButton(tr("Choose &none"), this), "chooseNone", tr("Chooses no encoder")))
    , m_stop(describe(new QCheckBox(tr("&Stop after a refusal"), this), "stopAfterRefusal",
                      tr("Start no other encoder after one has refused")))
    , m_summary(wrappedLabel(this, "transferSummary"))
    , m_problem(new InlineMessage(this))
    , m_gate(new EepromGate(this))
    , m_begin(named(new QPushButton(this), "transferBegin"))
    , m_progress(new JobStrip(m_round, this))
    , m_stage(new QStackedWidget(this))
    , m_choosing(new QWidget(this))
    , m_done(new QWidget(this))
    , m_result(wrappedLabel(this, "transferResult"))
    , m_account(new AccountView(this))
    , m_back(describe(new QPushButton(lineIcon(Icon::back), tr("Bac&k"), this), "transferBack",
                      tr("Shows what differs now")))
{
    setAccessibleName(tr("Transfer"));
    m_begin->setDefault(true);
    m_progress->hide();
    m_soon.setSingleShot(true);
    m_soon.setInterval(planDelay);
    setFocusProxy(m_choice);
    layOut();
    connectAll();
    showSummary();
    onEvent(this, {QEvent::Show}, [this] {
        if (m_stage->currentWidget() == m_choosing)
            showPlan();
    });
}

void TransferPage::layOut()
{
    layOutColumn(m_choosing,
                 {m_choice,
                  {m_table, 1},
                  layOutRow({m_all, m_none, m_stop, Stretch{1}}),
                  m_problem,
                  m_gate,
                  m_progress,
                  layOutRow({{m_summary, 1}, m_begin})},
                 {.spacing = grid::margin, .margins = QMargins()});
    layOutColumn(m_done, {m_result, {m_account, 1}, {m_back, 0, Qt::AlignLeft}},
                 {.spacing = grid::margin, .margins = QMargins()});
    m_stage->addWidget(m_choosing);
    m_stage->addWidget(m_done);
    layOutColumn(this, {m_stage}, {.margins = allAround(grid::margin)});
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
    connect(m_gate, &EepromGate::changed, this, &TransferPage::showBegin);
    connect(m_begin, &QPushButton::clicked, this, &TransferPage::begin);
    connect(m_back, &QPushButton::clicked, this, &TransferPage::backToChoice);
    connect(&m_round, &JobRound::finished, this, &TransferPage::finish);
    connect(&m_soon, &QTimer::timeout, this, &TransferPage::showPlan);
    connect(&m_project, &ProjectDocument::changed, this, &TransferPage::planSoon);
    connect(&m_project, &ProjectDocument::replaced, this, [this] {
        m_problem->withdraw();
        if (m_stage->currentWidget() == m_done)
            backToChoice(); // what was written belongs to the other project
    });
    connect(&m_buses, &Buses::changed, this, [this] {
        m_choice->showEncoders();
        followEncoders();
        planSoon();
    });
    followEncoders();
}

} // namespace codewheel
