// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/rod_panel.h"

#include "widgets/dial/resolution.h"
#include "widgets/input/form_fields.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/wizard/calculator_field.h"

#include <QGridLayout>
#include <QLocale>
#include <QPushButton>

#include <array>

namespace codewheel {
namespace {

// As the manual writes it: "C350h".
QString hexText(std::int64_t number)
{
    return QString::number(number, 16).toUpper() + QLatin1Char('h');
}

} // namespace

RodPanel::RodPanel(QWidget *parent)
    : QGroupBox(tr("From rod length and resolution"), parent)
    , m_answer(wrappedLabel(this, "rodAnswer"))
    , m_take(named(new QPushButton(tr("&Use this"), this), "rodUse"))
{
    auto *layout = new QGridLayout(this);
    layout->setSpacing(grid::unit);
    const auto changed = [this] { calculate(); };
    m_length = addCalculatorField(*layout, *this,
                                  {.caption = tr("Rod &length, mm"),
                                   .name = tr("Length of the rod"),
                                   .toolTip = tr("The measuring length in mm, on the label of the rod."),
                                   .least = 0.001},
                                  500, changed);
    m_mmPerStep = addCalculatorField(*layout, *this,
                                     {.caption = tr("mm per s&tep"),
                                      .name = tr("Wanted resolution"),
                                      .toolTip = tr("mm for one step of the position."),
                                      .least = 0.00001,
                                      .decimals = 5},
                                     0.01, changed);
    m_length->setObjectName(QStringLiteral("rodLength"));
    m_mmPerStep->setObjectName(QStringLiteral("rodResolution"));
    m_take->setToolTip(
        tr("Adds this measuring length to the wanted values, and sets the length of the rod manually."));
    layout->addWidget(m_take, layout->rowCount(), 0);
    layout->addWidget(m_answer, layout->rowCount(), 0, 1, 3);
    layout->setColumnStretch(2, 1); // the fields are as wide as a number
    connect(m_take, &QPushButton::clicked, this, &RodPanel::take);
    calculate();
}

void RodPanel::setRodLength(double millimetres)
{
    m_length->setValue(millimetres);
}

double RodPanel::rodLength() const
{
    return m_length->value();
}

void RodPanel::setMostSteps(std::int64_t most)
{
    m_most = most;
    calculate();
}

void RodPanel::calculate()
{
    const std::array<const DecimalField *, 2> fields{m_length, m_mmPerStep};
    const QString wrong = firstComplaint(fields);
    m_result.reset();
    if (wrong.isEmpty())
        m_result = stepsForRod(m_length->value(), m_mmPerStep->value(), m_most);
    m_take->setEnabled(m_result.has_value());
    if (!m_result) {
        m_answer->setText(wrong.isEmpty() ? tr("The encoder cannot resolve this. Choose more mm per step.")
                                          : wrong);
        return;
    }
    const QLocale locale;
    m_answer->setText(tr("%1 steps (%2): %3, %4 mm off over %5 mm.")
                          .arg(locale.toString(qlonglong{m_result->steps}), hexText(m_result->steps),
                               resolution(m_result->mmPerStep),
                               locale.toString(m_result->errorOverLength, 'g', 3),
                               locale.toString(m_length->value(), 'g', 7)));
}

// What is still being typed counts.
void RodPanel::take()
{
    if (takeFields(*this).isEmpty() && m_result)
        Q_EMIT chosen(m_result->steps);
}

} // namespace codewheel
