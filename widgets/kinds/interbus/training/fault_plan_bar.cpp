// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/training/fault_plan_bar.h"

#include "kinds/interbus/simulator/fault_plan.h"
#include "kinds/interbus/simulator/ring_training_acts.h"
#include "vocabulary/refusal_text.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

namespace codewheel {

FaultPlanBar::FaultPlanBar(const SharedControls &controls, QWidget *parent)
    : QWidget(parent)
    , m_controls(controls)
    , m_load(addButton(tr("Fault plan…"), tr("Loads a file of faults with their times and places")))
    , m_start(addButton(tr("Run"), tr("Carries out the fault plan from its beginning")))
    , m_stop(addButton(tr("Halt"), tr("Ends the fault plan; what it has caused stays")))
    , m_next(new QLabel(this))
    , m_message(new InlineMessage(this))
{
    auto *column = layOut<QVBoxLayout>(this, grid::unit);
    column->addWidget(m_load);
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_start);
    buttons->addWidget(m_stop);
    column->addLayout(buttons);
    column->addWidget(m_message);
    m_next->setFont(textFont(TextSize::small));
    m_next->setWordWrap(true);
    m_next->setAccessibleName(tr("Fault plan"));
    column->addWidget(m_next);
    connect(m_load, &QPushButton::clicked, this, &FaultPlanBar::chooseFile);
    connect(m_start, &QPushButton::clicked, this, &FaultPlanBar::start);
    connect(m_stop, &QPushButton::clicked, this, [this] { m_controls->stopFaultPlan(); });
    refresh();
}

QPushButton *FaultPlanBar::addButton(const QString &text, const QString &toolTip)
{
    auto *button = new QPushButton(text, this);
    button->setAutoDefault(false);
    button->setToolTip(toolTip);
    return button;
}

void FaultPlanBar::chooseFile()
{
    const QString path = QFileDialog::getOpenFileName(this, tr("Fault plan"), QFileInfo(m_file).path(),
                                                      tr("Fault plans (*.cwfaults *.json)"));
    if (!path.isEmpty())
        load(path);
}

bool FaultPlanBar::load(const QString &path)
{
    auto plan = loadFaultPlan(path, m_controls->places());
    if (!plan) {
        m_message->showMessage(Role::attention, refusalText(plan.error()));
        return false;
    }
    m_message->withdraw();
    m_controls->stopFaultPlan();
    m_file = path;
    m_loaded = *std::move(plan);
    refresh();
    return true;
}

void FaultPlanBar::start()
{
    if (m_loaded)
        m_controls->startFaultPlan(*m_loaded);
    refresh();
}

void FaultPlanBar::refresh()
{
    const TrainingControls::PlanProgress progress = m_controls->planProgress();
    for (const FaultStep &step : m_news.take(progress))
        Q_EMIT carriedOut(step.place, faultAct(step.fault, step.place, step.value));
    m_start->setEnabled(m_loaded.has_value());
    m_stop->setEnabled(progress.isRunning);
    show(progress);
}

void FaultPlanBar::show(const TrainingControls::PlanProgress &progress)
{
    QString text;
    if (progress.isRunning) {
        const FaultStep &next = progress.plan->steps[progress.next];
        const double seconds = static_cast<double>((next.at - progress.elapsed).count()) / 1'000;
        text = tr("In %1 s: %2")
                   .arg(QLocale().toString(seconds, 'f', 1),
                        trainingFaultText(next.fault, next.place, next.value));
    } else if (m_loaded) {
        const QString name = m_loaded->title.isEmpty() ? QFileInfo(m_file).fileName() : m_loaded->title;
        text = tr("%1: %n steps", nullptr, static_cast<int>(m_loaded->steps.size())).arg(name);
    }
    m_next->setVisible(!text.isEmpty());
    if (m_next->text() != text)
        m_next->setText(text);
}

} // namespace codewheel
