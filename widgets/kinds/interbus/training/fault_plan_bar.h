// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/fault_plan_news.h"
#include "vocabulary/training_act.h"
#include "widgets/kinds/interbus/training/shared_controls.h"

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace codewheel {

class InlineMessage;

// Loads a fault plan, starts and stops it, and shows what comes next. Used by the training panel.
class FaultPlanBar : public QWidget
{
    Q_OBJECT

public:
    explicit FaultPlanBar(const SharedControls &controls, QWidget *parent = nullptr);

    // Reports on the spot what is wrong with it.
    bool load(const QString &path);
    // Called with each frame. Reports the steps carried out since the last one.
    void refresh();

Q_SIGNALS:
    void carriedOut(codewheel::NodeId node, const codewheel::TrainingAct &what);

private:
    QPushButton *addButton(const QString &text, const QString &toolTip);
    void chooseFile();
    void start();
    void show(const TrainingControls::PlanProgress &progress);

    const SharedControls &m_controls;
    std::optional<FaultPlan> m_loaded;
    FaultPlanNews m_news;
    QString m_file;
    QPushButton *m_load;
    QPushButton *m_start;
    QPushButton *m_stop;
    QLabel *m_next;
    InlineMessage *m_message;
};

} // namespace codewheel
